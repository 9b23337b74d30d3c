# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Documents from strangers: the bytes of a text or a file, and XML that neither fills memory nor reaches for more."""

from contextlib import contextmanager
from pathlib import Path
from xml.etree import ElementTree
from xml.parsers import expat

from .parameters import ShapeError, require

DEEPEST = 100  # elements inside one another


@contextmanager
def about(subject):
    """Begin a refusal that names no parameter with what it is about: the file, or the text."""
    try:
        yield
    except ShapeError as error:
        if error.key:
            raise
        raise ShapeError(f"{subject} {error.sentence}") from error.__cause__


def content(text_or_path, kind, mark, largest):
    """The bytes of a document, and what to call it in a refusal.

    Parameters
    ----------
    text_or_path : str or Path
    kind : str
        What it should be: "SVG".
    mark : str
        What is in every such text and in no path.
    largest : int
        Bytes that a file may have.
    """
    if isinstance(text_or_path, str) and mark in text_or_path:
        return text_or_path.encode("utf-8", "surrogatepass"), f"the {kind} text"
    is_path = isinstance(text_or_path, (str, Path)) and str(text_or_path)
    require(is_path, f"must be {kind} text or a path", text_or_path, kind.lower())
    subject = f"the {kind} file {text_or_path}"
    try:
        with about(subject):
            return contained(Path(text_or_path), largest), subject
    except (OSError, ValueError) as error:
        if isinstance(error, ShapeError):
            raise
        raise ShapeError(f"{subject} cannot be read: {getattr(error, 'strerror', None) or error}") from error


def contained(path, largest):
    """The bytes of a file, or a refusal: of a folder, and of too many bytes, as a device has without end."""
    if path.is_dir():
        raise ShapeError("must be a file, got a folder")
    with path.open("rb") as file:
        return limited(file, largest)


def limited(file, largest):
    """The bytes of an open file, or a refusal of more than so many."""
    data = file.read(largest + 1)
    if len(data) > largest:
        raise ShapeError(f"must have at most {largest:,} bytes")
    return data


def parsed(data):
    """The root element of an XML document.

    Raises
    ------
    ShapeError
        For what is no XML, for entities (a few lines of which can stand for terabytes), and for deep nesting.
    """
    try:
        checked(data)
        return ElementTree.fromstring(data)
    except (expat.ExpatError, ElementTree.ParseError, LookupError, ValueError) as error:
        if isinstance(error, ShapeError):
            raise
        raise ShapeError(f"must be XML, got an error: {error}") from error


def checked(data):
    """Go through a document once, without building anything, to refuse entities and deep nesting."""
    depth = 0

    def start(name, attributes):
        nonlocal depth
        depth += 1
        require(depth <= DEEPEST, f"must have elements nested at most {DEEPEST} deep", depth)

    def end(name):
        nonlocal depth
        depth -= 1

    def entity(name, *rest):
        raise ShapeError(f"must have no entity declarations, got one of {name[:40]!r}")

    parser = expat.ParserCreate()
    parser.StartElementHandler, parser.EndElementHandler, parser.EntityDeclHandler = start, end, entity
    parser.Parse(data, True)


def plain(element):
    """The tag of an element without its namespace."""
    return element.tag.rpartition("}")[2] if isinstance(element.tag, str) else ""

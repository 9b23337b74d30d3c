# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""An SVG document from a stranger: its elements, once it is certain that they can be interpreted quickly and safely."""

from pathlib import Path
from xml.etree import ElementTree
from xml.parsers import expat

from ..parameters import ShapeError, require

LARGEST = 2_000_000  # characters, repeated uses counted again
DEEPEST = 100
UNSEEN = {"mask", "marker", "filter", "linearGradient", "radialGradient", "foreignObject", "script"}
HREFS = "href", "{http://www.w3.org/1999/xlink}href"


def content(text_or_path):
    """The bytes of a document, and what to call it in a refusal."""
    if isinstance(text_or_path, str) and "<" in text_or_path:
        return text_or_path.encode("utf-8", "surrogatepass"), "the SVG text"
    require(
        isinstance(text_or_path, (str, Path)) and str(text_or_path), "must be SVG text or a path", text_or_path, "svg"
    )
    subject = f"the SVG file {text_or_path}"
    try:
        path = Path(text_or_path)
        size = path.stat().st_size
        require(size <= LARGEST, f"{subject} must have at most {LARGEST} bytes", size)
        return path.read_bytes(), subject
    except (OSError, ValueError) as error:
        if isinstance(error, ShapeError):
            raise
        raise ShapeError(f"{subject} cannot be read: {getattr(error, 'strerror', None) or error}") from error


def tree(data):
    """The root element of a document, without what is never seen, and the width and height that percentages are of.

    It has lost its viewport, so that its lengths are in the drawing's own units.

    Raises
    ------
    ShapeError
        For what is no SVG, for entities (a few lines of which can stand for terabytes), and for elements nested or
        used over and over.
    """
    require(data.strip(), "must be an SVG drawing", "nothing")
    require(len(data) <= LARGEST, f"must have at most {LARGEST} characters", len(data))
    try:
        checked(data)
        root = ElementTree.fromstring(data)
    except (expat.ExpatError, ElementTree.ParseError, LookupError, ValueError) as error:
        if isinstance(error, ShapeError):
            raise
        raise ShapeError(f"must be XML, got an error: {error}") from error
    require(plain(root) == "svg", "must have an svg element at its root", plain(root))
    Uses(root).measured(root)
    hide(root)
    return root, *own_size(root)


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


class Uses:
    """How large and how deep elements are when every ``use`` has been replaced by what it uses."""

    def __init__(self, root):
        self.named = {element.get("id"): element for element in root.iter() if element.get("id")}
        self.known = {}
        self.open = set()

    def measured(self, element, level=0):
        """The characters and the depth of an element; refuses too much of either, and uses that use themselves."""
        require(element not in self.open, "must have no use of an element within itself", element.get("id") or "use")
        require(level <= DEEPEST, f"must have elements and uses nested at most {DEEPEST} deep", level)
        if element not in self.known:
            self.open.add(element)
            parts = [self.measured(part, level + 1) for part in (*element, *self.used(element))]
            self.open.remove(element)
            size = sum(map(len, element.attrib.values())) + 1 + sum(part[0] for part in parts)
            require(size <= LARGEST, f"must have at most {LARGEST} characters with its uses replaced", size)
            self.known[element] = size, 1 + max((part[1] for part in parts), default=0)
        size, depth = self.known[element]
        require(
            level + depth <= DEEPEST + 1, f"must have elements and uses nested at most {DEEPEST} deep", level + depth
        )
        return size, depth

    def used(self, element):
        if plain(element) != "use":
            return []
        names = [element.get(key, "")[1:] for key in HREFS]
        return [self.named[name] for name in names if name in self.named][:1]


def hide(root):
    """Take out what is drawn nowhere, put symbols where only a use shows them, and let lengths be the file's own."""
    for parent in list(root.iter()):
        for i, element in enumerate(list(parent)):
            if plain(element) in UNSEEN:
                parent.remove(element)
            elif plain(element) == "symbol":
                wrapper = ElementTree.Element(element.tag.replace("symbol", "defs"))
                wrapper.append(element)
                parent.remove(element)
                parent.insert(i, wrapper)


def own_size(root):
    """Width and height of the drawing in its own units; takes the viewport off it."""
    viewport = {
        key: root.attrib.pop(key, "") for key in ("viewBox", "width", "height", "preserveAspectRatio", "x", "y")
    }
    box = viewport["viewBox"].replace(",", " ").split()
    try:
        return tuple(float(x) for x in (box[2:4] if len(box) == 4 else (viewport["width"], viewport["height"])))
    except ValueError:
        return 1000.0, 1000.0

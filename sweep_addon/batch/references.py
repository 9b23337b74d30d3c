# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""References: what a job says in place of a contour or a trajectory that lies in a file beside it."""

from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

from ..core import contours, solids, trajectories
from ..core.csg.known import known
from ..core.declared.description import table_schema
from ..core.declared.grammar_text import Grammar
from ..core.declared.parameters import (
    ShapeError,
    at,
    declared,
    from_table,
    length,
    parameter,
    parameters,
    require,
    shown,
    spelled,
)
from ..core.rings.corners import Corner, Mitre
from ..core.shapes import growing
from ..core.shapes.operand import Operand

LARGEST_FILE = 50_000_000  # bytes of a drawing or a font


@declared
class File:
    """A drawing (.svg, .dxf), a measured path (.gpx, .csv), or an object of a Blender file (.blend)"""

    file: str = parameter("", "Path of an .svg, .dxf, .gpx, .csv or .blend file, relative to the job")
    object: str = parameter("", "Name of the curve, text or mesh object in a .blend file")
    scale: float = parameter(
        1.0,
        "Factor of its size, as 0.001 for a drawing in millimetres; at 1 the own unit of a DXF drawing counts",
        above=0.0,
    )
    corner: Corner = parameter(Mitre(), "What becomes of the corners of a trajectory of straight legs")


@declared
class Text:
    """Letters of a font"""

    text: str = parameter("", "The letters")
    font: str = parameter("", "Path of a .ttf or .otf file, relative to the job")
    size: float = length(1.0, "Size of the font, about the distance between lines of a page")


@declared
class GrammarFile:
    """The text of a grammar"""

    file: str = parameter("", "Path of a text file, relative to the job")


def resolve(declared, table, folder):
    """A table with its references replaced by values.

    Parameters
    ----------
    declared : tuple of Parameter
        Those of the shape that the table describes.
    table : dict
    folder : Path
        What relative paths start from.

    Returns
    -------
    table : dict
    files : tuple of Path
        The files that were read.
    """
    files = []
    for p in declared:
        if p.item:
            table = {**table, **items_resolved(p, table.get(p.name), folder, files)}
            continue
        if p.type is Operand:
            table = {**table, **operand_resolved(p, table.get(p.name), folder, files)}
            continue
        if p.type is Grammar and isinstance(table.get(p.name), dict):
            with at(p.name):
                told, path = grammar(table[p.name], Path(folder))
            table = {**table, p.name: told}
            files.append(path)
            continue
        reference = reference_of(p, table.get(p.name))
        if reference:
            with at(p.name):
                value, path = read(reference, p, Path(folder))
            table = {**table, p.name: value}
            files.append(path)
    return table, tuple(files)


def grammar(reference, folder):
    """The text of a grammar in a file, and the file."""
    told = from_table({"reference": GrammarFile}, {"kind": "reference", **reference}, parameters)
    path = existing(folder / told.file, "file")
    try:
        text = path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError:
        raise ShapeError("must be text in UTF-8", "file") from None
    try:
        growing.read(Grammar(text))  # which keeps it for the plant
    except ShapeError as refusal:
        raise ShapeError(f"{told.file}: {refusal}", "file") from None
    return text, path


def operand_resolved(p, operand, folder, files):
    """The table of an operand with the references in it replaced; what is no such table is refused later."""
    kind = operand.get("kind") if isinstance(operand, dict) else None
    if not isinstance(kind, str) or kind not in known():
        return {}
    with at(p.name):
        made, read_files = resolve(parameters(known()[kind]), operand, folder)
    files.extend(read_files)
    return {p.name: made}


def items_resolved(p, items, folder, files):
    """A list of tables with the references in each replaced; what is no such list is refused later."""
    if not isinstance(items, list):
        return {}
    made = []
    for number, item in enumerate(items, 1):
        if isinstance(item, dict):
            with at(f"{p.name}.{number}"):
                item, read_files = resolve(parameters(p.item), item, folder)
            files.extend(read_files)
        made.append(item)
    return {p.name: made}


def reference_of(p, value):
    """The reference that a plain value is, or None."""
    if not p.accepts or not isinstance(value, dict) or "kind" in value:
        return None
    kind = Text if "text" in value else File if "file" in value else None
    with at(p.name):
        return kind and from_table({"reference": kind}, {"kind": "reference", **value}, parameters)


def read(reference, p, folder):
    """The value that a reference stands for as a parameter, and the file it was read from."""
    is_contour = contours.Outline in p.kinds
    if isinstance(reference, Text):
        require(is_contour, "stands for a contour only", reference.text, "text")
        require(reference.font, "must be a .ttf or .otf file", reference.font, "font")
        path = existing(folder / reference.font, "font")
        with keyed("text"):
            return contours.from_text(reference.text, path, size=reference.size), path
    path = existing(folder / reference.file, "file")
    if "MESH" in p.accepts and path.suffix.lower() == ".blend":
        return generator(reference, path, p.accepts), path
    found = (outline if is_contour else trajectory)(reference, path)
    if isinstance(found, trajectories.Polyline):
        return replace(found, corner=reference.corner), path
    mitred = reference.corner == Mitre()
    require(mitred, "stands for a trajectory of straight legs only", spelled(type(reference.corner)), "corner")
    return found, path


def outline(reference, path):
    """The outline in a file."""
    kind = path.suffix.lower()
    require(kind in (".svg", ".dxf", ".blend"), "must be an .svg, .dxf or .blend file", reference.file, "file")
    if kind == ".svg":
        with keyed("file"):
            return contours.from_svg(path, scale=reference.scale)
    if kind == ".dxf":
        with keyed("file"):
            return contours.from_dxf(path, scale=0.0 if reference.scale == 1.0 else reference.scale)
    with opened(reference) as files:
        found = files.outline(path, reference.object)
    return scaled(found, reference.scale)


def generator(reference, path, types):
    """The solid, the surface or the outline in a .blend file."""
    with opened(reference) as files:
        found = files.generator(path, reference.object, types)
    return found.scaled(reference.scale) if isinstance(found, solids.Triangles) else scaled(found, reference.scale)


def trajectory(reference, path):
    """The trajectory in a file."""
    kind = path.suffix.lower()
    require(kind in (".gpx", ".csv", ".blend"), "must be a .gpx, .csv or .blend file", reference.file, "file")
    if kind != ".blend":
        with keyed("file"):
            measured = (trajectories.from_gpx if kind == ".gpx" else trajectories.from_csv)(path)
            return lengthened(measured, reference.scale)
    with opened(reference) as files:
        found = files.trajectory(path, reference.object)
    return lengthened(found, reference.scale)


@contextmanager
def opened(reference):
    """What reads the files of Blender; where it refuses, it is about the object."""
    require(reference.object, "must name an object of the .blend file", reference.object, "object")
    try:
        from ..bridge import files
    except ImportError as missing:
        raise ShapeError(f"needs Blender to be read, got {shown(reference.file)}", "file") from missing
    with at("object"):
        yield files


@contextmanager
def keyed(key):
    """Give a refusal that has no key of its own the key that it is about."""
    try:
        yield
    except ShapeError as refusal:
        raise ShapeError(refusal.sentence, refusal.key or key) from refusal.__cause__


def existing(path, key):
    require(path.is_file(), "must be a file that exists", str(path), key)
    require(path.stat().st_size <= LARGEST_FILE, f"must have at most {LARGEST_FILE:,} bytes", path.stat().st_size, key)
    return path


def scaled(outline, factor):
    """An outline made larger or smaller; a bulge is an angle and stays."""
    loops = [loop.values * factor for loop in outline.loops]
    return replace(outline, loops=loops, tolerance=outline.tolerance * factor)


def lengthened(trajectory, factor):
    """A trajectory made larger or smaller about the origin."""
    return replace(trajectory, points=trajectory.points.values * factor)


def with_references(form, declared):
    """The schema of a shape's table, whose contours and trajectories may also be references."""
    for p in declared:
        if p.item:
            with_references(form["properties"][p.name]["items"], parameters(p.item))
        if p.type is Grammar:
            text = form["properties"][p.name]
            form["properties"][p.name] = {"anyOf": [{"type": text.pop("type")}], **text}
        if p.accepts or p.type is Grammar:
            kinds = (File, Text) if contours.Outline in p.kinds else (File,)
            for kind in (GrammarFile,) if p.type is Grammar else kinds:
                table = table_schema(kind, parameters(kind))
                del table["properties"]["kind"]
                table["required"] = [parameters(kind)[0].name]
                form["properties"][p.name]["anyOf"].append(table)
    return form

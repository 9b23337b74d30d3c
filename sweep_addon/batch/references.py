# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""References: what a job says in place of a contour or a trajectory that lies in a file beside it."""

from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

from ..core import contours, solids, trajectories
from ..core.csg.known import known
from ..core.declared.coercing import filled
from ..core.declared.description import table_schema
from ..core.declared.hints import unmistakable
from ..core.declared.parameters import ShapeError, at, declared, length, parameter, parameters, require, spelled
from ..core.declared.refusals import MOST
from ..core.declared.texts import Grammar, Program
from ..core.declared.wording import shown
from ..core.rings.corners import Corner, Mitre
from ..core.shapes import growing, milling
from ..core.shapes.operand import Operand

LARGEST_FILE = 50_000_000  # bytes of a drawing, a font or a text
BADLY_WRITTEN = {Grammar: "strict", Program: "replace"}  # comments of programs are in whatever their author had
READ = {  # what reads a text that is a parameter, or refuses it
    Grammar: lambda text: growing.read(Grammar.coerced(text)),
    Program: lambda text: milling.path_of(Program.coerced(text)),
}


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
class TextFile:
    """The text of a grammar or of a program"""

    file: str = parameter("", "Path of a text file, relative to the job")


def resolve(declared, table, folder):
    """A table with its references replaced by values, or by the refusals of those that stand for nothing.

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
    made, files = dict(table), []
    for p in declared:
        if p.name in table:
            try:
                made[p.name] = resolved(p, table[p.name], Path(folder), files)
            except ShapeError as refusal:
                made[p.name] = refusal  # which is told with what else is wrong with the shape
    return made, tuple(files)


def resolved(p, value, folder, files):
    """The value of one parameter with its references replaced, and the files that were read for it added to others."""
    if p.item:
        return items_resolved(p, value, folder, files)
    if p.type is Operand:
        return operand_resolved(value, folder, files)
    if p.type in READ and isinstance(value, str):
        READ[p.type](p.type.coerced(value))  # so that what is wrong in it is told with what else is
        return value
    if p.type in READ and isinstance(value, dict):
        made, path = text_in_file(value, folder, p.type)
    else:
        reference = reference_of(p, value)
        if not reference:
            return value
        made, path = read(reference, p, folder)
    files.append(path)
    return made


def text_in_file(reference, folder, kind):
    """The text of a grammar or a program in a file, and the file."""
    told = filled(TextFile, parameters(TextFile), reference)
    path = existing(folder, told.file, "file")
    try:
        text = path.read_text(encoding="utf-8-sig", errors=BADLY_WRITTEN[kind])
    except UnicodeDecodeError:
        raise ShapeError(f"must be text in UTF-8, got {shown(told.file)}", "file") from None
    try:
        READ[kind](text)  # which keeps it for the shape
    except ShapeError as refusal:
        problems = getattr(refusal, "problems", ())
        places = [problem.placed(path) for problem in problems[:MOST]]
        places += [f"{path}: and {len(problems) - MOST} more"] * (len(problems) > MOST)
        raise ShapeError("\n".join(places) or f"{told.file}: {refusal}", "file") from None
    return text, path


def operand_resolved(operand, folder, files):
    """The table of an operand with the references in it replaced; what is no such table is refused later."""
    word = operand.get("kind") if isinstance(operand, dict) else None
    kind = known().get(word) or unmistakable(known(), word) if isinstance(word, str) else None
    if kind is None:
        return operand
    made, read_files = resolve(parameters(kind), operand, folder)
    files.extend(read_files)
    return made


def items_resolved(p, items, folder, files):
    """A list of tables with the references in each replaced; what is no such list is refused later."""
    if not isinstance(items, list):
        return items
    made = []
    for item in items:
        if isinstance(item, dict):
            item, read_files = resolve(parameters(p.item), item, folder)
            files.extend(read_files)
        made.append(item)
    return made


def reference_of(p, value):
    """The reference that a plain value is, or None."""
    if not p.accepts or not isinstance(value, dict) or "kind" in value:
        return None
    kind = Text if "text" in value else File if "file" in value else None
    return kind and filled(kind, parameters(kind), value)


def read(reference, p, folder):
    """The value that a reference stands for as a parameter, and the file it was read from."""
    is_contour = contours.Outline in p.kinds
    if isinstance(reference, Text):
        require(is_contour, "stands for a contour only", reference.text, "text")
        require(reference.font, "must be a .ttf or .otf file", reference.font, "font")
        path = existing(folder, reference.font, "font")
        with keyed("font"):
            return contours.from_text(reference.text, path, size=reference.size), path
    path = existing(folder, reference.file, "file")
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


def existing(folder, name, key):
    """The path of a file that there is, relative to a folder."""
    require(name, "must name a file", name, key)
    path = folder / name
    require(not path.is_dir(), "must be a file, not a folder", str(path), key)
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
        if p.type in READ:
            text = form["properties"][p.name]
            form["properties"][p.name] = {"anyOf": [{"type": text.pop("type")}], **text}
        if p.accepts or p.type in READ:
            kinds = (File, Text) if contours.Outline in p.kinds else (File,)
            for kind in (TextFile,) if p.type in READ else kinds:
                table = table_schema(kind, parameters(kind))
                del table["properties"]["kind"]
                table["required"] = [parameters(kind)[0].name]
                form["properties"][p.name]["anyOf"].append(table)
    return form

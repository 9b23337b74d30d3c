# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A job: a TOML file that says a shape, and how a picture of it is made."""

import hashlib
import json
from enum import Enum
from os import PathLike
from pathlib import Path

from ..core.csg import NODES
from ..core.declared import description, forms
from ..core.declared.coercing import filled
from ..core.declared.frozen import frozen
from ..core.declared.hints import unmistakable
from ..core.declared.parameters import ShapeError, angle, count, declared, parameter, parameters, require, spelled
from ..core.declared.refusals import MOST, together
from ..core.shapes.kinds import SHAPE_NAMES
from .lines import lines_of
from .references import resolve, with_references

GRAMMARS = (".l", ".ls", ".lpy", ".lsys")  # how names of files end that are most likely no job
DESCRIBED = SHAPE_NAMES | {spelled(node): node for node in NODES}  # what a job may be of


class Engine(Enum):
    CYCLES = "Light followed along its paths, on any machine"
    WORKBENCH = "Plain shading in a fraction of a second; needs OpenGL"
    EEVEE = "Light approximated as in games; needs OpenGL"


@declared
class Render:
    """A picture of a shape, its camera as close as shows all of it"""

    engine: Engine = parameter(Engine.CYCLES, "What computes the picture")
    width: int = count(960, "Pixels across", minimum=16, maximum=16_384)
    height: int = count(720, "Pixels down", minimum=16, maximum=16_384)
    samples: int = count(48, "Samples of each pixel", maximum=65_536)
    frames: int = count(1, "Pictures in one turn round the shape; 1 is a still", maximum=100_000)
    azimuth: float = angle(-0.9, "Where the camera stands round the z axis, from the x axis")
    elevation: float = angle(0.45, "How high the camera stands", minimum=-1.57, maximum=1.57)
    margin: float = parameter(0.06, "Part of the picture left free on each side", minimum=0.0, maximum=0.45)
    side: tuple[float, float, float] = parameter((0.80, 0.36, 0.16), "Colour of the side", minimum=0.0, maximum=1.0)
    caps: tuple[float, float, float] = parameter((0.93, 0.78, 0.55), "Colour of the ends", minimum=0.0, maximum=1.0)
    leaves: tuple[float, float, float] = parameter(
        (0.32, 0.50, 0.16),
        "Colour of polygons, and of what has a further colour's number",
        minimum=0.0,
        maximum=1.0,
    )
    metallic: float = parameter(0.0, "1 for a metal", minimum=0.0, maximum=1.0)
    roughness: float = parameter(0.35, "0 for a mirror, 1 for chalk", minimum=0.0, maximum=1.0)
    background: tuple[float, float, float] = parameter((0.90, 0.91, 0.93), "Colour behind", minimum=0.0, maximum=1.0)
    ground: bool = parameter(True, "A ground that takes the shape's shadow, where the camera stands above it")
    transparent: bool = parameter(False, "Nothing behind the shape")


@frozen
class Job:
    """A job that was understood.

    Attributes
    ----------
    shape : a shape
    render : Render
    digest : str
        A hash of all that the job says, and of the files it refers to; the same for jobs that say the same.
    path : Path or None
        Where it was read from.
    """

    shape: object
    render: Render
    digest: str
    path: Path | None = None


class JobError(ShapeError):
    """A refusal that says in which file, at which line: ``job.toml:12: contour.rounding: must be at most ...``.

    It says all that is wrong with the job, each in a line of its own.

    Attributes
    ----------
    path : Path
    line : int or None
        Of the first.
    """

    def __init__(self, error, path, text=None):
        every = [part for refusal in error.each() for part in parted(refusal)]
        lines = lines_told(every[:MOST], text)
        first, *others = sorted(lines, key=lambda refusal: lines[refusal] or 0)
        super().__init__(first.sentence, first.key)
        self.path, self.line, self.others, self.__cause__ = path, lines[first], tuple(others), first.__cause__
        sentences = [placed(path, lines[refusal], refusal) for refusal in (first, *others)]
        more = len(every) - len(lines)
        self.args = ("\n".join(sentences + [f"{path}: and {more} more mistake{'s' * (more > 1)}"] * (more > 0)),)


def parted(refusal):
    """A refusal, or of a grammar one for each of its problems."""
    problems = getattr(refusal, "problems", ())
    return [ShapeError(str(problem), refusal.key) for problem in problems] or [refusal]


def lines_told(refusals, text):
    """The line of a job that each of some refusals is about, or None."""
    keys = [refusal.key for refusal in refusals]
    if all(key.startswith("line ") for key in keys):  # of a text that is no TOML
        return {refusal: int(refusal.key.removeprefix("line ")) for refusal in refusals}
    return dict(zip(refusals, lines_of(text, keys) if text is not None else [None] * len(keys), strict=True))


def placed(path, line, refusal):
    """A refusal as editors find its place."""
    sentence = refusal.sentence if refusal.key.startswith("line ") else str(refusal)
    return f"{path}:{line}: {sentence}" if line else f"{path}: {sentence}"


def load(job):
    """The shape that a job describes.

    Parameters
    ----------
    job : path, or str of one or more lines ``key = value``
        A job file, or the text of one.

    Returns
    -------
    A shape.

    Raises
    ------
    ShapeError
        If it is no job; for a file, with its name and the line.

    Examples
    --------
    >>> load('kind = "generalized-cylinder"').contour
    Circle(radius=0.1, points=64)
    """
    require(isinstance(job, (str, bytes, PathLike)), "must be a path, or the text of a job", job, "job")
    is_text = isinstance(job, bytes) or isinstance(job, str) and ("\n" in job or "=" in job)
    return parse(job, Path()).shape if is_text else read(job).shape


def read(path):
    """The `Job` in a file; a `JobError` with file and line if it is none."""
    path, text = Path(path), None
    try:
        text = content(path)
        job = parse(text, path.parent)
    except ShapeError as error:
        if path.suffix in GRAMMARS and error.key.startswith("line "):
            error = ShapeError(f"{error.sentence}; of a grammar tell `derive` and `describe`", error.key)
        wrong = JobError(error, path, decoded(text))
        raise wrong from wrong.__cause__
    return Job(job.shape, job.render, job.digest, path)


def content(path):
    try:
        if path.is_file() and path.stat().st_size > forms.LONGEST:
            raise ShapeError(f"must have at most {forms.LONGEST:,} bytes, got {path.stat().st_size:,}")
        if path.is_file():
            return path.read_bytes()
    except OSError as error:
        raise ShapeError(f"cannot be read: {error.strerror}") from None
    if path.exists():
        raise ShapeError(f"must be a job file, got {'a folder' if path.is_dir() else 'no ordinary file'}")
    raise ShapeError("must be a job file that exists")


def decoded(text):
    """The text to find lines in, or None where there is none."""
    try:
        return text.decode("utf-8-sig") if text is not None else None
    except UnicodeDecodeError:
        return None


def parse(text, folder):
    """The `Job` of a text whose relative paths start from a folder."""
    table = forms.tables(text)
    picture, refused = table.pop("render", {}), []
    try:
        render = picture_of(picture)
    except ShapeError as refusal:
        refused.append(refusal.inside("render"))
    try:
        shape = DESCRIBED.get(name(table)) or unmistakable(DESCRIBED, name(table))
        resolved, files = resolve(parameters(shape), table, folder) if shape else (table, ())
        made = forms.shape_of(DESCRIBED.values(), resolved)
    except ShapeError as refusal:
        refused.insert(0, refusal)
    if refused:
        raise together(refused)
    return Job(made, render, digest(table, picture, files))


def picture_of(table):
    """The `Render` that a table describes."""
    if not isinstance(table, dict):
        raise ShapeError("must be a table, [render]")
    return filled(Render, parameters(Render), table)


def name(table):
    kind = table.get("kind")
    return kind if isinstance(kind, str) else None


def digest(table, picture, files):
    """A hash of plain tables and the contents of files."""
    said = hashlib.sha256(json.dumps([table, picture], sort_keys=True, default=str).encode())
    for file in files:
        said.update(hashlib.sha256(file.read_bytes()).digest())
    return said.hexdigest()


def schema():
    """The JSON Schema of a job file, references and ``[render]`` included."""
    made = description.schema(DESCRIBED.values())
    picture = description.table_schema(Render, parameters(Render))
    del picture["properties"]["kind"], picture["required"]
    for form, shape in zip(made["anyOf"], DESCRIBED.values(), strict=True):
        with_references(form, parameters(shape))
        form["properties"]["render"] = picture
    return made

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Presets: job files of shapes that somebody would want, offered wherever shapes are added.

Those in a folder are sizes of one thing and bear its name: ``screw_thread/m8.toml`` is ``screw_thread_m8``.
"""

from functools import cached_property, lru_cache
from itertools import groupby
from os import walk
from pathlib import Path

from ..core.frozen import frozen
from ..core.later import later
from ..core.parameters import at, pick
from ..core.shapes import SHAPES

csg = later("core.csg")
shape_of, tables = later("core.forms", "shape_of", "tables")

FOLDER = Path(__file__).parent


@frozen
class Preset:
    """A job file, whose first line is a comment that says what the shape is."""

    path: Path
    group: str  # the folder that it is in, whose presets are offered together; none for most
    name: str

    @cached_property
    def doc(self):
        with self.path.open(encoding="utf-8") as file:
            return file.readline().lstrip("# ").rstrip(" .\n")

    @property
    def title(self):
        return title(self.name)


def title(name):
    """The name of a preset for people."""
    return name.replace("_", " ").title().replace("Csg", "CSG").replace("L System", "L-System")


def found():
    """The presets in the order in which they are offered."""
    folders = ((Path(path).relative_to(FOLDER).parts, files) for path, _, files in walk(FOLDER))
    parts = ((*groups, file) for groups, files in folders for file in files if file.endswith(".toml"))
    for *groups, file in sorted(parts, key=counted):
        yield Preset(FOLDER.joinpath(*groups, file), "".join(groups), "_".join((*groups, file.removesuffix(".toml"))))


def counted(parts):
    """The parts of a path to sort it by, numbers as numbers: m3 comes before m10."""
    words = ((number, "".join(word)) for number, word in groupby("/".join(parts), str.isdigit))
    return [(number, int(word) if number else word) for number, word in words]


PRESETS = tuple(found())
PATHS = {preset.name: preset.path for preset in PRESETS}


@lru_cache
def shape(name):
    """The shape of a preset.

    >>> type(shape("spring").trajectory).__name__
    'Helix'
    """
    with at("preset"):
        path = pick(PATHS, name)
    table = tables(path.read_bytes())
    table.pop("render", None)  # how its picture is made is a question for `batch`
    return shape_of((*SHAPES, *csg.NODES), table)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Presets: job files of shapes that somebody would want, offered wherever shapes are added.

Those in a folder are sizes of one thing and bear its name: ``screw_thread/m8.toml`` is ``screw_thread_m8``.
"""

import os
from functools import cached_property, lru_cache
from pathlib import Path

from ..core.declared.coercing import pick
from ..core.declared.names import title
from ..core.declared.parameters import at
from ..core.later import later
from ..core.shapes.kinds import SHAPES

csg = later("core.csg")
shape_of, tables = later("core.declared.forms", "shape_of", "tables")

FOLDER = Path(__file__).parent
GROWN = "l_system"  # the folder of presets that are grammars, each a thing of its own
DIGITS = "0123456789"


class Preset:
    """A job file, whose first line is a comment that says what the shape is."""

    def __init__(self, group, stem):
        self.group = group  # the folder that it is in, whose presets are offered together; none for most
        self.file = os.path.join(group, f"{stem}.toml")  # in `FOLDER`: starting Blender makes dozens, and asks no path
        self.name = f"{group}_{stem}" if group else stem

    @cached_property
    def path(self):
        return FOLDER / self.file

    @cached_property
    def doc(self):
        with self.path.open(encoding="utf-8") as file:
            return file.readline().lstrip("# ").rstrip(" .\n")

    @property
    def title(self):
        return title(self.name.removeprefix(f"{GROWN}_"))


def found():
    """The presets in the order in which they are offered."""
    folder = str(FOLDER)
    files = ((path[len(folder) + 1 :], file) for path, _, files in os.walk(folder) for file in files)
    stems = [(group, file.removesuffix(".toml")) for group, file in files if file.endswith(".toml")]
    return (Preset(*parts) for parts in sorted(stems, key=counted))


def counted(parts):
    """The parts of a path to sort it by, a number at its end as one: m3 comes before m10."""
    path = "/".join(filter(None, parts))
    words = path.rstrip(DIGITS)
    return words, int(path[len(words) :] or 0)


PRESETS = tuple(found())
BY_NAME = {preset.name: preset for preset in PRESETS}


@lru_cache
def shape(name):
    """The shape of a preset.

    >>> type(shape("spring").trajectory).__name__
    'Helix'
    """
    with at("preset"):
        preset = pick(BY_NAME, name)
    table = tables(preset.path.read_bytes())
    table.pop("render", None)  # how its picture is made is a question for `batch`
    return shape_of((*SHAPES, *csg.NODES), table)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Presets: job files of shapes that somebody would want, offered wherever shapes are added.

Those in a folder are sizes of one thing and bear its name: ``screw_thread/m8.toml`` is ``screw_thread_m8``.
"""

import os
import re
from functools import cached_property, lru_cache
from pathlib import Path

from ..core.declared.frozen import frozen
from ..core.declared.parameters import at, pick
from ..core.later import later
from ..core.shapes.kinds import SHAPES

csg = later("core.csg")
shape_of, tables = later("core.declared.forms", "shape_of", "tables")

FOLDER = Path(__file__).parent
GROWN = "l_system"  # the folder of presets that are grammars, each a thing of its own
NUMBERS = re.compile("([0-9]+)")
SMALL = re.compile(r"(?<= )(A|And|By|In|Of|On|The|To|With)(?= )")  # words that titles do not begin with


@frozen
class Preset:
    """A job file, whose first line is a comment that says what the shape is."""

    file: str  # below this folder: there are dozens, and starting Blender asks for no path
    group: str  # the folder that it is in, whose presets are offered together; none for most
    name: str

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


def title(name):
    """The name of a preset for people."""
    words = name.replace("_", " ").title().replace("Csg", "CSG")
    return SMALL.sub(lambda word: word.group().lower(), words)


def found():
    """The presets in the order in which they are offered."""
    folder = str(FOLDER)
    found = ((path[len(folder) + 1 :], file) for path, _, files in os.walk(folder) for file in files)
    for parts in sorted((part for part in found if part[1].endswith(".toml")), key=counted):
        group, file = parts
        name = file.removesuffix(".toml")
        yield Preset(os.path.join(*parts), group, f"{group}_{name}" if group else name)


def counted(parts):
    """The parts of a path to sort it by, numbers as numbers: m3 comes before m10."""
    words = NUMBERS.split("/".join(filter(None, parts)))
    return [int(word) if word.isdigit() else word for word in words]  # every other one is a number


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

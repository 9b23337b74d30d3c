# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Presets: job files of shapes that somebody would want, offered wherever shapes are added.

Those in a folder are sizes of one thing and bear its name: ``screw_thread/m8.toml`` is ``screw_thread_m8``.
"""

import re
from functools import lru_cache
from pathlib import Path

from ..core.forms import shape_of, tables
from ..core.frozen import frozen
from ..core.parameters import at, pick
from ..core.shapes import SHAPES

FOLDER = Path(__file__).parent


@frozen
class Preset:
    """A job file and its first line, a comment that says what the shape is."""

    path: Path
    doc: str

    @property
    def group(self):
        """The folder that it is in, whose presets are offered together; none for most."""
        return "" if self.path.parent == FOLDER else self.path.parent.name

    @property
    def name(self):
        return f"{self.group}_{self.path.stem}" if self.group else self.path.stem

    @property
    def title(self):
        return title(self.name)


def title(name):
    """The name of a preset for people."""
    return name.replace("_", " ").title()


def first_comment(path):
    with path.open(encoding="utf-8") as file:
        return file.readline().lstrip("# ").rstrip(" .\n")


def counted(path):
    """The parts of a path to sort it by, numbers as numbers: m3 comes before m10."""
    parts = re.split(r"(\d+)", str(path.relative_to(FOLDER)))
    return [(part.isdigit(), int(part) if part.isdigit() else part) for part in parts]


PRESETS = tuple(Preset(path, first_comment(path)) for path in sorted(FOLDER.rglob("*.toml"), key=counted))
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
    return shape_of(SHAPES, table)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Presets: job files of shapes that somebody would want, offered wherever shapes are added."""

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from ..core.forms import load
from ..core.shapes import SHAPES

FOLDER = Path(__file__).parent


@dataclass(frozen=True)
class Preset:
    """A job file and its first line, a comment that says what the shape is."""

    name: str
    doc: str

    @property
    def title(self):
        return title(self.name)


def title(name):
    """The name of a preset for people."""
    return name.replace("_", " ").title()


def first_comment(path):
    with path.open(encoding="utf-8") as file:
        return file.readline().lstrip("# ").rstrip(" .\n")


PRESETS = tuple(Preset(path.stem, first_comment(path)) for path in sorted(FOLDER.glob("*.toml")))


@lru_cache
def shape(name):
    """The shape of a preset.

    >>> type(shape("spring").trajectory).__name__
    'Helix'
    """
    return load(SHAPES, (FOLDER / f"{name}.toml").read_bytes())

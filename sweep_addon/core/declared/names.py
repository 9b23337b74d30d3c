# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Names: how jobs, identifiers and people have those of classes, options and files."""

import re
import zlib
from enum import Enum
from functools import cache

WORDS = re.compile(r"\B(?=[A-Z][a-z])")  # where a word of a class's name begins
SMALL = {"A", "And", "By", "In", "Of", "On", "The", "To", "With"}  # words that titles do not begin or end with


@cache
def spelled(kind, joint="-"):
    """The name of a class (FixedUp) or of an Enum's member (FIXED_UP) as jobs (fixed-up) or identifiers have it."""
    if isinstance(kind, Enum):
        return kind.name.lower().replace("_", joint)
    return WORDS.sub(joint, kind.__name__).lower()


def titled(kind):
    """The name of a class (PDCurveSweep) or of an Enum's member as people read it (PD Curve Sweep)."""
    if isinstance(kind, Enum):
        return spelled(kind, " ").title()
    return getattr(kind, "TITLE", None) or WORDS.sub(" ", kind.__name__)


def title(name):
    """The name of a file or a folder as people read it.

    >>> title("tree_of_the_plain"), title("csg_on")
    ('Tree of the Plain', 'CSG On')
    """
    first, *words = name.replace("_", " ").title().replace("Csg", "CSG").split(" ")
    return " ".join((first, *(word.lower() if word in SMALL else word for word in words[:-1]), *words[-1:]))


def number_of(name):
    """The number of an item of an enum, which is saved in files; keyframes add a half to it in float32: 23 bits."""
    return zlib.crc32(name.encode()) % 2**23

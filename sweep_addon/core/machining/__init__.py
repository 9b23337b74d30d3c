# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Machining: programs of milling machines, tools and stock, what is left of it, and whether that is the part.

Examples
--------
>>> import sweep_addon as sw
>>> path = sw.machining.read("G21 F100\\nG0 X0 Y0 Z5\\nG1 Z-2")
>>> path.points.tolist()
[[0.0, 0.0, 0.005], [0.0, 0.0, -0.002]]
"""

from importlib import import_module

from .stock import Around, Box, Stock
from .tools import BallNose, BullNose, Cone, FlatEnd, Numbered, Tool

__all__ = [
    "Around",
    "BallNose",
    "Box",
    "BullNose",
    "Cone",
    "FlatEnd",
    "Numbered",
    "Stock",
    "Tool",
    "Toolpath",
    "Verification",
    "read",
    "verify",
]

LATER = {
    "Toolpath": ".programs",
    "Verification": ".verification",
    "read": ".programs",
    "verify": ".verification",
}


def __dir__():
    return __all__  # what a console offers


def __getattr__(name):
    # Reading and cutting are loaded when they are asked for: declaring stock needs neither.
    if name not in LATER:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(LATER[name], __package__), name)

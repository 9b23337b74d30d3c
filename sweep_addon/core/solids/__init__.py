# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids: bodies that move as they are, or that are offset; each is a value with a ``mesh()``, its surface.

They stand about the origin, their reference point, and reach as far down as up.

Examples
--------
>>> round(Block(width=1.0, depth=2.0, height=3.0).mesh().volume(), 12)
6.0
"""

from .bodies import Ball, Block, Bracket, Cylinder, DrilledBlock, Triangles

Solid = Block | Ball | Cylinder | Bracket | DrilledBlock | Triangles

__all__ = ["Ball", "Block", "Bracket", "Cylinder", "DrilledBlock", "Solid", "Triangles"]


def __dir__():
    return __all__  # what a console offers

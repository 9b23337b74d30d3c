# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Contours: what moves in a sweep, planar figures about a reference point.

Each kind is a value with a ``section()``: closed loops of points that bound an area.

Examples
--------
>>> Circle(radius=1.0, points=6).section().points.shape
(6, 2)
"""

from .circle import Circle
from .fonts import from_text
from .outline import Outline
from .rectangle import Rectangle
from .section import Section
from .svg import from_svg

Contour = Circle | Rectangle | Outline

__all__ = ["Circle", "Contour", "Outline", "Rectangle", "Section", "from_svg", "from_text"]

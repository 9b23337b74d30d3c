# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ends: what closes a sweep where its trajectory starts and ends."""

from .parameters import declared, length


@declared
class Flat:
    """A flat face, holes left open"""


@declared
class Open:
    """No face: the sweep stays a surface"""


@declared
class Taper:
    """The contour shrinks evenly to a point"""

    length: float = length(0.25, "How much of the trajectory the point takes")


End = Flat | Open | Taper

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What counts as nothing beside the size of an outline."""

from math import hypot
from typing import NamedTuple

from .edges import apex

LAST = 8 * 2.0**-52  # what a few operations leave uncertain of a coordinate


class Tolerance(NamedTuple):
    """Distances, in the unit of the outline.

    Parameters
    ----------
    size : float
        Twice the distance from the middle of the outline to its farthest vertex, which no turn changes. No line is
        prolonged by more.
    least : float
        A vertex this near to the line or circle through its neighbours is none, and an arc this near to its chord is
        that. A millionth of a millionth of the size: a thousand times what rounding moves a point, and no area changes
        by more.
    near : float
        Edges this near to each other touch, and a corner turns only if it stands out by more. A thousandth of a
        millionth of the size: single precision tells no less than sixty times as much, so that nothing is closed that
        a mesh could show open. An arc that should be tangent to a line may cross it beside their common end by as
        much: coordinates and bulges of ten digits allow no better.
    seen : float
        Neighbours of an outline that overlap beside their common end by more cross each other. A millionth of the size,
        which is what drawings of six digits may miss a tangent by.
    """

    size: float
    least: float
    near: float
    seen: float

    @classmethod
    def of(cls, loop):
        """The tolerances of a loop; far from the origin none is less than what its coordinates can tell."""
        points = [*loop.corners, *map(apex, loop.edges())]
        x, y = (sum(values) / len(values) for values in zip(*points, strict=True))
        size = 2 * max(hypot(px - x, py - y) for px, py in points)
        last = LAST * max(max(abs(px), abs(py)) for px, py in points)
        return cls(size, *(part * size + last for part in (1e-12, 1e-9, 1e-6)))

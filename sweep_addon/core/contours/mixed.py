# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The mixed contour: areas, curves and points of one plane, swept together."""

from functools import lru_cache

import numpy as np

from ..declared.parameters import Array, declared, parameter, require
from .outline import MOST_POINTS

BLOCK = ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))
TAIL = ((0.5, 0.0), (1.0, 0.0))


@declared
class Mixed:
    """Areas, curves and points of one plane, whose sweep is of mixed dimension

    What an odd number of loops lies around is an area. Whatever meets is joined there: a curve that ends on the edge of
    an area is a dangling edge. What of a curve lies in an area is the area's. Where loops, curves or points are given,
    those that are not are none.

    Examples
    --------
    >>> areas, lines = Mixed().sections()
    >>> areas.area, lines.points.tolist()
    (1.0, [[0.5, 0.0], [1.0, 0.0]])
    >>> Mixed(curves=[[(0, 0), (1, 0)]])
    Mixed(loops=(), curves=([[0.0, 0.0], [1.0, 0.0]],), points=[])
    """

    loops: tuple[Array, ...] = parameter(
        (BLOCK,), "Corners of each loop round an area", columns=2, unit="length", most=MOST_POINTS
    )
    curves: tuple[Array, ...] = parameter((TAIL,), "Points of each curve", columns=2, unit="length", most=MOST_POINTS)
    points: Array = parameter((), "Single points", columns=2, unit="length", most=MOST_POINTS)

    @staticmethod
    def completed(given):
        """What is given, and nothing for the other parts: the default's are no part of what somebody draws."""
        return {"loops": (), "curves": (), "points": (), **given} if given else given

    def check(self):
        """Refuse a set without any part, loops of less than three points and curves of less than two."""
        for name, fewest in (("loops", 3), ("curves", 2)):
            shortest = min(map(len, getattr(self, name)), default=fewest)
            require(shortest >= fewest, f"must have at least {fewest} points each", shortest, name)
        total = sum(map(len, (*self.loops, *self.curves, self.points)))
        require(total, "must have an area, or curves or points be given", "none", "loops")
        require(total <= MOST_POINTS, f"must have at most {MOST_POINTS} points with curves and points", total, "loops")
        self.sections()

    def sections(self):
        """The areas, if any, and the curves and points outside them, if any: one or two sections."""
        return parts(self)


@lru_cache(maxsize=64)
def parts(mixed):
    """The sections of a mixed contour, made once for equal ones."""
    from .planar import united  # few contours are mixed

    loops, curves = ([line.values for line in lines] for lines in (mixed.loops, mixed.curves))
    figure, even_odd = np.zeros(len(loops), dtype=int), np.array([True])
    found = united(loops, figure, even_odd, curves, mixed.points.values)
    found = tuple(section for section in found if section is not None)
    require(found, "must enclose an area or have a length", [len(loop) for loop in loops], "loops")
    return found

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The outline: closed loops of lines and circular arcs, as a contour with islands and holes."""

from functools import lru_cache

import numpy as np

from ..parameters import Array, at, declared, parameter, require
from .arcs import apexes, arc_points, chords, tangent_turns
from .loops import following, joined
from .section import SHARP, Section

MOST_POINTS = 200_000
CORNERS = ((-0.5, -0.5), (0.5, -0.5), (0.5, -0.3), (-0.3, -0.3), (-0.3, 0.5), (-0.5, 0.5))


@declared
class Outline:
    """Closed loops of lines and arcs, with islands and holes

    What an odd number of loops lies around is inside (the even-odd rule), whichever way they run. An edge is straight
    unless it has a bulge: the tangent of a quarter of its arc's angle, positive where the path turns left. Arcs are
    flattened to chords within the tolerance that turn by at most 30 degrees. A corner is sharp where the edges' true
    directions differ by more than 20 degrees; curves that were flattened before turn by at most 15.

    Examples
    --------
    A washer, each of its circles two half circles:

    >>> ends = [(-1, 0), (1, 0)], [(-0.5, 0), (0.5, 0)]
    >>> washer = Outline(loops=ends, bulges=[(1, 1), (1, 1)], tolerance=1e-5)
    >>> round(washer.section().area / (3.14159265 * 0.75), 4)
    1.0
    """

    loops: tuple[Array, ...] = parameter((CORNERS,), "Corners of each closed loop", columns=2, unit="length")
    bulges: tuple[Array, ...] = parameter(
        (), "Bulge of the edge after each corner, loop by loop: tangent of a quarter of its arc's angle, left positive"
    )
    tolerance: float = parameter(
        0.0, "Largest distance of an arc from its chords; 0 is a thousandth of the outline's size", unit="length",
        minimum=0.0,
    )  # fmt: skip

    def check(self):
        sizes = [len(loop.values) for loop in self.loops]
        got = [len(bulge.values) for bulge in self.bulges]
        require(not got or got == sizes, f"must have one number a corner, {sizes}", got, "bulges")
        steep = max((float(np.abs(bulge.values).max(initial=0)) for bulge in self.bulges), default=0.0)
        require(steep <= 1000, "must be at most 1000", steep, "bulges")
        self.section()

    def section(self):
        """The flattened loops as a `Section`; made once for equal outlines."""
        return flattened(self)


@lru_cache(maxsize=64)
def flattened(outline):
    """The section of an outline; refuses loops that cross, touch or enclose nothing."""
    with at("loops"):
        corners, offsets = joined(outline.loops)
        bulges = np.concatenate([np.zeros(0), *outline.bulges])
        if not bulges.any():
            return Section.from_loops(outline.loops)
    start, end = corners, corners[following(offsets)]
    tolerance = outline.tolerance or size(np.concatenate([corners, apexes(start, end, bulges)])) / 1000
    count = chords(start, end, bulges, tolerance)
    total = int(count.sum())
    require(total <= MOST_POINTS, f"must be large enough to give at most {MOST_POINTS} points", total, "tolerance")
    first = np.cumsum(count) - count
    sharp = np.zeros(count.sum(), dtype=bool)
    sharp[first] = np.abs(tangent_turns(start, end, bulges, following(offsets))) > SHARP
    cuts = first[offsets[1:-1]]
    with at("loops"):
        return Section.from_loops(np.split(arc_points(start, end, bulges, count), cuts), np.split(sharp, cuts))


def size(points):
    return float(np.hypot(*np.ptp(points, axis=0)))

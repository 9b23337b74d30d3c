# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The outline: loops of lines and circular arcs, closed, as a contour with islands and holes, or open."""

from functools import lru_cache

import numpy as np

from ..declared.parameters import Array, at, declared, parameter, require
from ..later import later

apexes, arc_points, chords, segments, tangent_turns = later(
    "core.contours.arcs", "apexes", "arc_points", "chords", "segments", "tangent_turns"
)
joined = later("core.contours.loops", "joined")
sections = later("core.contours.section")
following = later("core.meshes.runs", "following")

MOST_POINTS = 200_000  # of all loops together: what a second or two can check

CORNERS = ((-0.5, -0.5), (0.5, -0.5), (0.5, -0.3), (-0.3, -0.3), (-0.3, 0.5), (-0.5, 0.5))


@declared
class Outline:
    """Loops of lines and arcs: closed, with islands and holes, or open, for a surface

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

    loops: tuple[Array, ...] = parameter((CORNERS,), "Corners of each loop", columns=2, unit="length", most=MOST_POINTS)
    bulges: tuple[Array, ...] = parameter(
        (),
        "Bulge of the edge after each corner, loop by loop: tangent of a quarter of its arc's angle, left positive",
        most=MOST_POINTS,
    )
    tolerance: float = parameter(
        0.0, "Largest distance of an arc from its chords; 0 is a thousandth of the outline's size", unit="length",
        minimum=0.0,
    )  # fmt: skip
    closed: bool = parameter(True, "Lead the end of each loop back to its start; open loops make surfaces")

    def check(self):
        """Refuse loops that cross, touch or enclose nothing, and bulges that are not one a corner or beyond 1000.

        The last bulge of an open loop is that of no edge.
        """
        sizes = [len(loop.values) for loop in self.loops]
        got = [len(bulge.values) for bulge in self.bulges]
        require(not got or got == sizes, f"must have one number a corner, {sizes}", got, "bulges")
        steep = max((float(np.abs(bulge.values).max(initial=0)) for bulge in self.bulges), default=0.0)
        require(steep <= 1000, "must be at most 1000", steep, "bulges")
        self.section()

    @property
    def area(self):
        """What the lines and arcs enclose, holes taken off, in square metres; 0 where they are open."""
        if not self.closed:
            return 0.0
        loops = np.abs(self.signed_areas())
        return float(loops @ np.where(self.section().depth % 2, -1, 1))

    def signed_areas(self):
        """What the lines and arcs of each loop enclose, in square metres, positive where it runs counter-clockwise."""
        corners, offsets, bulges = self.edges()
        straight = sections.Section(corners, offsets, np.zeros(len(corners), dtype=bool)).areas
        return straight + np.add.reduceat(segments(corners, corners[following(offsets)], bulges), offsets[:-1])

    def section(self):
        """The flattened loops as a `Section`; made once for equal outlines."""
        return flattened(self)

    def apexes(self):
        """(m, 2) float array: the point of the curve that is farthest from each edge; none without curves."""
        if not self.edges()[2].any():
            return None
        raw, bulges = chained(self)
        middles = apexes(raw.points, raw.points[raw.following], bulges)
        section = self.section()
        keys, sought = raw.points @ (1, 1j), section.points @ (1, 1j)  # the section's points are some of the raw ones
        order = keys.argsort(kind="stable")
        index = order[np.searchsorted(keys, sought, side="right", sorter=order) - 1]
        turned = (raw.areas > 0) != (section.areas > 0)
        return middles[np.where(turned[section.loop_of], index[section.following], index)]

    def edges(self):
        """Where the lines and arcs start, (m, 2), the offsets of the loops, and the bulges, (m,)."""
        corners, offsets = joined(self.loops)
        bulges = np.concatenate(self.bulges) if self.bulges else np.zeros(len(corners))
        if not self.closed:
            bulges[offsets[1:] - 1] = 0.0
        return corners, offsets, bulges


@lru_cache(maxsize=64)
def flattened(outline):
    """The section of an outline; refuses loops that cross, touch or enclose nothing."""
    with at("loops"):
        if not outline.edges()[2].any():
            return sections.Section.from_loops(outline.loops, closed=outline.closed)
    raw, _ = chained(outline)
    cuts = raw.offsets[1:-1]
    with at("loops"):
        return sections.Section.from_loops(np.split(raw.points, cuts), np.split(raw.sharp, cuts), outline.closed)


def chained(outline):
    """The chords of an outline's lines and arcs, its loops unchecked and as they run, and the bulge over each chord."""
    with at("loops"):
        corners, offsets, bulges = outline.edges()
    start, end = corners, corners[following(offsets)]
    tolerance = outline.tolerance or size(np.concatenate([corners, apexes(start, end, bulges)])) / 1000
    count = chords(start, end, bulges, tolerance)
    total = int(count.sum())
    require(total <= MOST_POINTS, f"must be large enough to give at most {MOST_POINTS} points", total, "tolerance")
    first = np.cumsum([0, *count])
    sharp = np.zeros(total, dtype=bool)
    sharp[first[:-1]] = np.abs(tangent_turns(start, end, bulges, following(offsets))) > sections.SHARP
    if not outline.closed:
        sharp[first[offsets[:-1]]] = sharp[first[offsets[1:]] - 1] = False
    raw = sections.Section(arc_points(start, end, bulges, count), first[offsets], sharp, outline.closed)
    return raw, np.repeat(np.tan(np.arctan(bulges) / count), count)


def size(points):
    return float(np.hypot(*np.ptp(points, axis=0)))

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What figures of the plane visit that move straight on within it, each told by how far places are from it.

A place is as far from all that an edge visits as the edge is from a segment: that from the place back along the way.
"""

import numpy as np

from ...vectors import dot, norms
from .loops import Loops
from .nearby import Nearby

CLOSE = 1e-3  # of the size: tolerances of less share a lattice


class Swathe:
    """What lines, arcs and the areas between them visit that move along a segment, or do not move.

    Parameters
    ----------
    edges : Loops
        All lines and arcs, whether they bound an area or not.
    area : Loops or None
        The area that some of them bound.
    start, end : (2,) float array
        Where the origin of their plane begins and ends.

    Examples
    --------
    A line across its way leaves a square:

    >>> line = Loops(np.array([(0.0, 0.0)]), np.array([(0.0, 1.0)]), np.zeros(1), np.zeros(1, dtype=int))
    >>> square = Swathe(line, None, np.zeros(2), np.array((1.0, 0.0)))
    >>> square.far(np.array([(0.5, 0.5), (1.0, 1.0), (1.25, 0.5)]), 0.5).tolist()
    [0.0, 0.0, 0.25]
    """

    def __init__(self, edges, area, start, end):
        self.end, way = end, end - start
        self.length = float(np.hypot(*way))
        x, y = way / self.length if self.length else (1.0, 0.0)
        self.turn = np.array(((x, -y), (y, x)))  # puts the way onto the x axis
        self.edges, self.area = turned(edges, self.turn), None if area is None else turned(area, self.turn)
        self.box = edges.box + np.stack((np.minimum(start, end), np.maximum(start, end)))
        low, high = self.edges.boxes()
        self.lattices, self.low, self.high = {}, low.min(axis=0) - (self.length, 0.0), high.max(axis=0)
        top, middle, radius = np.array((0.0, 1.0)), self.edges.centres, self.edges.radii
        every = np.arange(len(middle))
        self.tops = [(middle + side * radius[:, None] * top) for side in (1, -1)]  # and bottoms
        self.has_tops = [self.edges.arcs & self.edges.beside(every, place) for place in self.tops]

    def far(self, points, tolerance):
        """How far points (n, 2) are from it, 0 within; infinite where that is more than the tolerance: (n,)."""
        places = (points - self.end) @ self.turn
        found = np.zeros(len(places))
        left = np.arange(len(places)) if self.area is None else np.flatnonzero(self.area.depth(places) >= 0)
        found[left] = self.lattice(0.0, tolerance).least(self.apart, places[left])
        return np.maximum(found, 0.0)

    def lattice(self, level, tolerance):
        """The lattice for distances about a level; the last two are kept."""
        size = float(np.hypot(*(self.high - self.low))) + level
        room = max(tolerance, CLOSE * size)
        found = self.lattices.get((level, room))
        if found is None:
            reach = level + room
            ends, inside = (self.low - reach, self.high + reach), self.area and self.inside
            found = Nearby.of(self.apart, len(self.edges.start), *ends, level, room, inside)
            self.lattices = {(level, room): found} | dict(list(self.lattices.items())[:1])
        return found

    def inside(self, places):
        """Negative where an end of the segments from places (k, 2) along x is in the area, by how far: (k,)."""
        return np.minimum(self.area.depth(places), self.area.depth(places + (self.length, 0.0)))

    def apart(self, edge, places):
        """How far edges are from the segments that lead from places (k, 2) along x: (k,).

        Where they cross it is negative: so far is the nearest end of either from the other.
        """
        found = off(self.edges, edge, places)
        if not self.length:
            return found
        found = np.minimum(found, off(self.edges, edge, places + (self.length, 0.0)))
        start, end, arc = self.edges.start[edge], self.edges.end[edge], self.edges.arcs[edge]
        found = np.minimum.reduce([found, self.beside(places, start), self.beside(places, end)])
        (a, b), (c, d), (x, y) = start.T, end.T, places.T
        rise = np.where(d == b, 1.0, d - b)
        at = a + (y - b) / rise * (c - a)
        crossed = ~arc & ((b > y) != (d > y)) & (at >= x) & (at <= x + self.length)
        some = np.flatnonzero(arc)
        if len(some):
            crossed[some] = self.meets(edge[some], places[some])
            for top, has in zip(self.tops, self.has_tops, strict=True):
                chosen = some[has[edge[some]]]
                found[chosen] = np.minimum(found[chosen], self.beside(places[chosen], top[edge[chosen]]))
        return np.where(crossed, -found, found)

    def beside(self, places, points):
        """How far points (k, 2) are from the segments that lead from places (k, 2) along x: (k,)."""
        right, above = (points - places).T
        return np.hypot(np.maximum(np.maximum(-right, right - self.length), 0.0), above)

    def meets(self, edge, places):
        """Which arcs the segments meet that lead from places (k, 2) along x: (k,) bool."""
        centre, radius, (x, y) = self.edges.centres[edge], self.edges.radii[edge], places.T
        above = y - centre[:, 1]
        half = np.sqrt(np.maximum(radius**2 - above**2, 0.0))
        found = np.zeros(len(edge), dtype=bool)
        for side in (1, -1):
            at = centre[:, 0] + side * half
            on = self.edges.beside(edge, np.stack((at, y), axis=1))
            found |= on & (at >= x) & (at <= x + self.length)
        return found & (np.abs(above) <= radius)


class RoundSwathe:
    """What a disc visits that moves along a segment, or an ellipse or another superellipse.

    Parameters
    ----------
    region : Disc or Superdisc
    start, end : (2,) float array
        Where its middle begins and ends.

    Its two outermost places, left and right of the way, draw straight lines. Between these all is visited that the line
    between both places comes over, and at the ends half of the figure more.
    """

    def __init__(self, region, start, end):
        self.region, self.start, way = region, start, end - start
        self.length = float(np.hypot(*way))
        self.along = way / self.length
        self.across = self.along[::-1] * (-1, 1)
        self.reach, outermost = region.support(self.across)
        self.ahead = float(outermost @ self.along)
        self.box = region.box + np.stack((np.minimum(start, end), np.maximum(start, end)))

    def far(self, points, tolerance):
        """How far points (n, 2) are from it, 0 within: (n,)."""
        off = points - self.start
        aside = dot(off, np.broadcast_to(self.across, off.shape))
        gone = dot(off, np.broadcast_to(self.along, off.shape))
        gone -= np.clip(aside / self.reach, -1.0, 1.0) * self.ahead
        found = np.maximum(np.abs(aside) - self.reach, 0.0)
        ends = np.flatnonzero((gone < 0) | (gone > self.length))
        places = off[ends] - np.where(gone[ends] < 0, 0.0, self.length)[:, None] * self.along
        found[ends] = np.maximum(self.region.distance(*places.T), 0.0)
        return found


def turned(loops, matrix):
    """The same lines and arcs in other axes of the plane."""
    return Loops(loops.start @ matrix, loops.end @ matrix, loops.bulges, loops.before)


def off(edges, edge, places):
    """How far places (k, 2) are from an edge each: (k,)."""
    across, beside = edges.distances(edge, places)
    ends = np.minimum(norms(places - edges.start[edge]), norms(places - edges.end[edge]))
    return np.where(beside, np.abs(across), ends)

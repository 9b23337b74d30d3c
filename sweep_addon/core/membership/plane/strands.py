# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines and arcs of the plane that bound nothing: what an open contour is, which sweeps a surface without an inside."""

from functools import cached_property

import numpy as np

from ...vectors import dot, unit
from .loops import Loops

CHUNK = 1 << 18  # pairs of points and edges at a time


class Strands:
    """Lines and arcs as they are.

    Parameters
    ----------
    start, end : (m, 2) float array
        Their ends, in metres; a single point is a line without length.
    bulges : (m,) float array
        The tangent of a quarter of each arc's angle, positive where it turns left; 0 of a line.

    Examples
    --------
    >>> line = Strands(np.array([(0.0, 0.0)]), np.array([(2.0, 0.0)]), np.zeros(1))
    >>> line.depth(np.array([(1.0, 0.5), (1.0, -0.5), (2.0, 3.0)])).tolist()
    [0.5, 0.5, 3.0]
    """

    def __init__(self, start, end, bulges):
        self.edges = Loops(start, end, bulges, np.arange(len(start)))

    @classmethod
    def of_sections(cls, sections):
        """Those of open `Section`s."""
        starts, ends = [], []
        for section in sections:
            ahead = section.following.copy()
            ahead[section.gaps] = section.gaps
            single = np.diff(section.offsets)[section.loop_of] == 1
            kept = single | (ahead != np.arange(len(ahead)))
            starts.append(section.points[kept])
            ends.append(section.points[ahead[kept]])
        start, end = np.concatenate(starts), np.concatenate(ends)
        return cls(start, end, np.zeros(len(start)))

    @classmethod
    def of_outline(cls, outline):
        """An open outline's own lines and arcs."""
        corners, offsets, bulges = outline.edges()
        kept = np.ones(len(corners), dtype=bool)
        kept[offsets[1:] - 1] = False
        return cls(corners[kept], np.roll(corners, -1, axis=0)[kept], bulges[kept])

    @cached_property
    def box(self):
        """The least and the greatest x and y: (2, 2) float array."""
        return self.edges.box

    def depth(self, points):
        """How far points (n, 2) are from the nearest of the edges, never negative: (n,)."""
        return self.exact(points)[0]

    def distance(self, x, y):
        """The same of places x (n,) and y (n,): (n,)."""
        return self.depth(np.stack((x, y), axis=1))

    def exact(self, points):
        """The same, and unit vectors away from it: (n,), (n, 2)."""
        depth, outward = np.empty(len(points)), np.empty((len(points), 2))
        count = len(self.edges.start)
        size = max(CHUNK // count, 1)
        for first in range(0, len(points), size):
            some = points[first : first + size]
            places, edge = np.repeat(some, count, axis=0), np.tile(np.arange(count), len(some))
            nearest = self.feet(edge, places)
            off = places - nearest
            far = np.sqrt(dot(off, off)).reshape(len(some), count)
            chosen = far.argmin(axis=1) + count * np.arange(len(some))
            least, across = far.ravel()[chosen], self.edges.right(edge[chosen], places[chosen])
            depth[first : first + size] = least
            away = np.where((least > 0)[:, None], off[chosen], across)
            outward[first : first + size] = unit(away)
        return depth, outward

    def feet(self, edge, places):
        """The nearest places on an edge each: (k, 2)."""
        across, beside = self.edges.distances(edge, places)
        start, end = self.edges.start[edge], self.edges.end[edge]
        nearer = dot(places - start, places - start) <= dot(places - end, places - end)
        ends = np.where(nearer[:, None], start, end)
        return np.where(beside[:, None], places - across[:, None] * self.edges.right(edge, places), ends)

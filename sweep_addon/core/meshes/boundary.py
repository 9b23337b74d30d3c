# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The boundary of what is left to fill: rings of nodes, each a point as one of the rings passes it.

A seam between two nodes doubles both. Between two rings it joins them, which is how a hole is opened to its outline;
within one it divides it.
"""

import numpy as np

from ..contours.orientation import orientation
from ..declared.parameters import ShapeError

NEAREST = 12  # nodes whose view is tested at a time
SPACING = 16  # nodes between those that seams start from


class Boundary:
    """Rings of nodes that have what is left to fill on their left.

    Attributes
    ----------
    points : (m, 2) float array
    point, before, after : (n,) int arrays
        Of each node its point, and its neighbours on its ring.
    left : (n,) bool array
        Which nodes are still on a ring.
    """

    def __init__(self, points, loops):
        self.points = points
        self.point = np.concatenate(loops).astype(int)
        self.after, self.before = np.arange(1, len(self.point) + 1), np.arange(len(self.point)) - 1
        self.offsets = np.cumsum([0, *(len(loop) for loop in loops)])
        self.after[self.offsets[1:] - 1] = self.offsets[:-1]
        self.before[self.offsets[:-1]] = self.offsets[1:] - 1
        self.left = np.ones(len(self.point), dtype=bool)
        self.edges = np.stack([self.point, self.point[self.after]], axis=1)

    def places(self, nodes):
        """(..., 2) float array: where nodes are."""
        return self.points[self.point[nodes]]

    def join_holes(self):
        """Open every hole to the ring around it by a seam from its leftmost node to one in its view.

        Holes are taken from left to right: then what is to the left of a hole is joined already, and some of it is
        in view.
        """
        nodes = np.arange(len(self.point))
        loops = np.split(nodes, self.offsets[1:-1])
        joined = [loop for loop in loops if self.area(loop) > 0]
        holes = [loop[np.lexsort(self.places(loop).T[::-1])] for loop in loops if self.area(loop) <= 0]
        for hole in sorted(holes, key=lambda hole: tuple(self.places(hole[0]))):
            node = int(hole[0])
            other = self.nearest_in_view(node, np.concatenate([*joined, np.zeros(0, dtype=int)]))
            if other is None:
                raise ShapeError("holes must lie in outer loops and touch nothing, got one that cannot be reached")
            joined += hole, self.connect(node, other)

    def divide(self):
        """Divide rings by short seams from some of the nodes that turn right."""
        nodes = np.flatnonzero(self.left)
        self.edges = self.point[np.stack([nodes, self.after[nodes]], axis=1)]
        a, b, c = (self.places(x) for x in (self.before[nodes], nodes, self.after[nodes]))
        for node in nodes[orientation(a, b, c) < 0][::SPACING].tolist():
            other = self.nearest_in_view(node, nodes, most=4 * NEAREST)
            if other is not None:
                self.connect(node, other)

    def area(self, loop):
        """Twice the area that a loop of nodes encloses."""
        x, y = (self.places(loop) - self.places(loop[0])).T
        return (x * np.roll(y, -1) - y * np.roll(x, -1)).sum()

    def nearest_in_view(self, node, candidates, most=None):
        """The nearest of the candidates that a straight seam can reach, or None; at most so many are looked at."""
        candidates = candidates[self.in_sector(node, candidates)]
        distance = ((self.places(candidates) - self.places(node)) ** 2).sum(axis=1)
        if most and most < len(candidates):
            near = np.argpartition(distance, most)[:most]
            candidates, distance = candidates[near], distance[near]
        candidates = candidates[np.argsort(distance, kind="stable")]
        for start in range(0, len(candidates), NEAREST):
            some = candidates[start : start + NEAREST]
            some = some[self.in_sector(some, node)]
            some = some[self.in_view(node, some)] if len(some) else some
            if len(some):
                return int(some[0])
        return None

    def in_sector(self, nodes, others):
        """Which other nodes are in the angle that the boundary leaves free at the nodes; the two broadcast."""
        a, b, c, place = (self.places(x) for x in (self.before[nodes], nodes, self.after[nodes], others))
        first, second = orientation(a, b, place) > 0, orientation(b, c, place) > 0
        return np.where(orientation(a, b, c) > 0, first & second, first | second)

    def in_view(self, node, others):
        """Which other nodes a straight seam reaches that meets no edge and no seam on its way."""
        a, b = self.places(node), self.places(others)[:, None]
        low, high = np.minimum(a, b), np.maximum(a, b)
        start, end = self.points[self.edges[:, 0]], self.points[self.edges[:, 1]]
        close = (np.maximum(start, end) >= low.min(axis=0)) & (np.minimum(start, end) <= high.max(axis=0))
        near = np.flatnonzero(close.all(axis=1))
        c, d = start[near], end[near]
        ends = np.stack(np.broadcast_arrays(self.point[node], self.point[others]))
        apart = (self.edges[near] != ends.T[:, None, :1]).all(axis=2) & (self.edges[near] != ends.T[:, None, 1:]).all(2)
        boxes = ((np.maximum(c, d) >= low) & (np.minimum(c, d) <= high)).all(axis=2)
        across = orientation(a, b, c) * orientation(a, b, d) <= 0
        along = orientation(c, d, a) * orientation(c, d, b) <= 0
        return ~(apart & boxes & across & along).any(axis=1)

    def connect(self, i, j):
        """Make a seam between two nodes; returns the two new ones, which run along it the other way."""
        twin_i, twin_j = len(self.point), len(self.point) + 1
        self.point = np.append(self.point, self.point[[i, j]])
        self.left = np.append(self.left, [True, True])
        self.edges = np.concatenate([self.edges, [self.point[[i, j]]]])
        self.before = np.append(self.before, [twin_j, self.before[j]])
        self.after = np.append(self.after, [self.after[i], twin_i])
        self.before[self.after[i]], self.after[self.before[j]] = twin_i, twin_j
        self.after[i], self.before[j] = j, i
        return np.array([twin_i, twin_j])

    def cut(self, tips):
        """Take ears off at nodes that are no neighbours; returns their (t, 3) points. A ring of three goes whole."""
        before, after = self.before[tips], self.after[tips]
        last = self.after[after] == before
        self.after[before], self.before[after] = after, before
        self.left[tips] = False
        self.left[before[last]] = self.left[after[last]] = False
        return self.point[np.stack([before, tips, after], axis=1)]

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Regions of the plane bounded by loops of lines and circular arcs, with holes and islands, exact to rounding.

The nearest edge tells the side, at a corner the sum of the normals of both edges: no ray is cast, so none can meet a
vertex. A lattice over the region keeps the edges that may be nearest in each of its cells, and the side of the cells
that no edge comes near.

Source
------
Baerentzen, Aanaes: Signed distance computation using the angle weighted pseudonormal, IEEE TVCG 11(3), 2005, of which
this is the case of the plane.
"""

from functools import cached_property

import numpy as np

from ...declared.frozen import individual
from ...meshes.runs import following
from ...vectors import dot, norms, unit
from ..motion.hash import portions
from .lattice import lattice
from .one_by_one import nearest_of

CHUNK = 1 << 18  # pairs of points and edges at a time
LEAST = 1e-300  # keeps quotients of an edge without length finite
CUSP = 2e-3  # radians that drawings of three decimals may miss a tangent by


@individual
class Loops:
    """Loops with the region on their left.

    Parameters
    ----------
    start, end : (m, 2) float array
        The ends of the edges, in metres.
    bulges : (m,) float array
        The tangent of a quarter of each arc's angle, positive where it turns left; 0 of a line.
    before : (m,) int array
        The edge that ends where each begins.

    Examples
    --------
    A half disc on the x axis:

    >>> half = Loops.of(np.array([(-1.0, 0.0), (1.0, 0.0)]), np.array([0, 2]), np.array([0.0, 1.0]))
    >>> half.exact(np.array([(0.0, 0.25), (0.0, 3.0), (2.0, 0.0)]))[0].tolist()
    [-0.25, 2.0, 1.0]
    """

    start: np.ndarray
    end: np.ndarray
    bulges: np.ndarray
    before: np.ndarray

    @classmethod
    def of(cls, points, offsets, bulges):
        """The region on the left of loops, given by all their points, where each begins, and the bulges after them."""
        ahead = following(offsets)
        before = np.empty_like(ahead)
        before[ahead] = np.arange(len(ahead))
        return cls(points, points[ahead], bulges, before)

    @cached_property
    def arcs(self):
        """Whether each edge is an arc: (m,) bool."""
        return self.bulges != 0

    @cached_property
    def centres(self):
        """The centres of the arcs; of lines nothing that counts: (m, 2)."""
        x, y = (self.end - self.start).T
        bulges = np.where(self.arcs, self.bulges, 1.0)
        up = (1 - bulges**2) / (4 * bulges)
        return (self.start + self.end) / 2 + up[:, None] * np.stack((-y, x), axis=1)

    @cached_property
    def radii(self):
        """The radii of the arcs: (m,)."""
        return norms(self.start - self.centres)

    @cached_property
    def tangents(self):
        """Unit vectors along the edges where they start and where they end: two (m, 2)."""
        chord, half = unit(self.end - self.start), 2 * np.arctan(self.bulges)
        return tuple(
            np.stack((c * chord[:, 0] - s * chord[:, 1], s * chord[:, 0] + c * chord[:, 1]), axis=1)
            for c, s in ((np.cos(half), -np.sin(half)), (np.cos(half), np.sin(half)))
        )

    @cached_property
    def corners(self):
        """The direction away from the region where each edge starts: (m, 2).

        It is the sum of both normals. In a cusp they cancel: there it leads ahead, over the tip, or back.
        """
        first, last = self.tangents
        both, tip = first + last[self.before], last[self.before]
        normals = np.stack((both[:, 1], -both[:, 0]), axis=1)
        return np.where(self.cusps[:, None] != 0, self.cusps[:, None] * tip, normals)

    @cached_property
    def after(self):
        """The edge that begins where each ends: (m,) int."""
        after = np.empty_like(self.before)
        after[self.before] = np.arange(len(after))
        return after

    @cached_property
    def cusps(self):
        """Where an arc turns back along its tangent, and each edge starts: (m,) of -1, 0, 1.

        1 where the region ends in the tip, as the edges bend apart to the right: who is nearest to the tip is outside.
        -1 where a gap ends in it: who is nearest is inside. 0 where there is no cusp.
        """
        first, last = self.tangents
        bends = np.where(self.arcs, np.sign(self.bulges) / np.where(self.radii > 0, self.radii, 1.0), 0.0)
        turned = norms(first + last[self.before]) < CUSP
        return np.where(turned, -np.sign(bends + bends[self.before]), 0.0)

    @cached_property
    def box(self):
        """The least and the greatest x and y: (2, 2) float array."""
        low, high = self.boxes()
        return np.stack((low.min(axis=0), high.max(axis=0)))

    def beside(self, edge, points):
        """Whether the nearest point of an edge's line or circle lies on the edge itself: (k,) bool.

        On a circle that is told by the chord: a point is beside an arc if its ray from the centre crosses it.
        """
        start, end, arc = self.start[edge], self.end[edge], self.arcs[edge]
        along, way = end - start, points - start
        share, squares = dot(way, along), dot(along, along)
        line = (share >= 0) & (share <= squares) & (squares > 0)  # beside a single point nothing is
        if not arc.any():
            return line
        centre, left = self.centres[edge], self.bulges[edge] > 0
        a, b, p = start - centre, end - centre, points - centre
        a, b = np.where(left[:, None], a, b), np.where(left[:, None], b, a)  # so that it runs counter-clockwise
        after, ahead = a[:, 0] * p[:, 1] - a[:, 1] * p[:, 0] >= 0, p[:, 0] * b[:, 1] - p[:, 1] * b[:, 0] >= 0
        minor = np.abs(self.bulges[edge]) <= 1
        return np.where(arc, np.where(minor, after & ahead, after | ahead), line)

    def distances(self, edge, points):
        """How far points (k, 2) are from an edge each, on its right positive; from its ends so far; where beside it.

        Returns
        -------
        across : (k,) float array
            The distance from the line or circle, positive on the right.
        beside : (k,) bool array
            Whether that is the distance from the edge.
        """
        start, along = self.start[edge], self.end[edge] - self.start[edge]
        way, arc = points - start, self.arcs[edge]
        length = np.sqrt(along[:, 0] ** 2 + along[:, 1] ** 2)
        across = (way[:, 0] * along[:, 1] - way[:, 1] * along[:, 0]) / np.where(length > 0, length, 1.0)
        if arc.any():
            round_ = (norms(points - self.centres[edge]) - self.radii[edge]) * np.sign(self.bulges[edge])
            across = np.where(arc, round_, across)
        return across, self.beside(edge, points)

    def nearest(self, point, edge, points):
        """The nearest edges of points, of pairs whose points rise.

        Returns
        -------
        depth : (n,) float array
            The distance, negative on the left.
        outward : (n, 2) float array
            The direction in which it grows.
        """
        across, beside = self.distances(edge, points[point])
        to_start = points[point] - self.start[edge]
        far = np.where(beside, np.abs(across), np.inf)
        if self.cusps.any():  # whose two edges are on different sides of a point that is beside the end of both
            tips = self.cusps[self.after[edge]] != 0
            far[tips & (norms(points[point] - self.end[edge]) <= far)] = np.inf
        corner = np.sqrt(to_start[:, 0] ** 2 + to_start[:, 1] ** 2)
        first = np.flatnonzero(np.append(True, point[1:] != point[:-1]))
        held = np.minimum(far, corner)
        least = np.minimum.reduceat(held, first)
        counts = np.diff(np.append(first, len(point)))
        chosen = np.flatnonzero(held == np.repeat(least, counts))
        chosen = chosen[np.append(True, point[chosen][1:] != point[chosen][:-1])]
        at_corner = corner[chosen] <= far[chosen]
        which = edge[chosen]
        away = np.where(at_corner[:, None], self.corners[which], self.right(which, points[point[chosen]]))
        side = np.where(self.cusps[which] != 0, self.cusps[which], dot(to_start[chosen], away))
        side = np.where(at_corner, side, across[chosen])
        return np.where(side > 0, least, -least), unit(away)

    def right(self, edge, points):
        """Unit vectors to the right of edges, at their places nearest to points: (k, 2)."""
        along = self.end[edge] - self.start[edge]
        line = np.stack((along[:, 1], -along[:, 0]), axis=1)
        spoke = (points - self.centres[edge]) * np.sign(self.bulges[edge])[:, None]
        return unit(np.where(self.arcs[edge][:, None], spoke, line))

    def depth(self, points):
        """How far points (n, 2) are from the boundary, negative inside: (n,); in cells away from it at least so far."""
        cells = self.lattice
        place = (points - cells.low) / cells.step
        within = ((place >= 0) & (place < cells.shape)).all(axis=1)
        i, j = np.clip(place, 0, cells.shape - 1).astype(np.intp).T
        cell = i * int(cells.shape[1]) + j
        depth = np.where(within, cells.clear[cell], norms(points - np.clip(points, *self.box)))
        near = np.flatnonzero(within & (depth == 0))
        counts = cells.first[cell[near] + 1] - cells.first[cell[near]]
        for some in portions(counts, CHUNK):
            chosen, count = near[some], counts[some]
            pair = np.repeat(np.arange(len(chosen)), count)
            shift = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
            edge = cells.edges[cells.first[cell[chosen]][pair] + shift]
            depth[chosen] = self.nearest(pair, edge, points[chosen])[0]
        return depth

    def distance(self, x, y):
        """How far places x (n,) and y (n,) are from the boundary, negative inside: (n,)."""
        return nearest_of(self, x, y)

    @cached_property
    def lattice(self):
        return lattice(self)

    def exact(self, points):
        """The distance of points (n, 2) from the boundary, negative inside, and unit vectors away: (n,), (n, 2)."""
        depth, outward, edges = np.empty(len(points)), np.empty((len(points), 2)), np.arange(len(self.start))
        size = max(CHUNK // len(edges), 1)
        for start in range(0, len(points), size):
            some = points[start : start + size]
            pair = np.repeat(np.arange(len(some)), len(edges))
            found = self.nearest(pair, np.tile(edges, len(some)), some)
            depth[start : start + size], outward[start : start + size] = found
        return depth, outward

    def boxes(self):
        """The least and the greatest x and y of each edge: two (m, 2)."""
        low, high = np.minimum(self.start, self.end), np.maximum(self.start, self.end)
        for axis, side in ((0, 1), (0, -1), (1, 1), (1, -1)):
            extreme = self.centres.copy()
            extreme[:, axis] += side * self.radii
            on = self.arcs & self.beside(np.arange(len(extreme)), extreme)
            low[on], high[on] = np.minimum(low, extreme)[on], np.maximum(high, extreme)[on]
        return low, high

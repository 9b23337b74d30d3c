# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far points are from the sweep of a figure that is deformed: from what its outline sweeps, and from its faces.

Both are looked for in the cells in which the motion F is nearly linear. To first order a place q of figure and way goes
to F(q) + J d as it is moved by d, and the figure's outline is where g + n . d = 0. Of all these places the one that
goes nearest to a point is a projection in space, as the outline is the plane m . J d = -g there, with m = J^-T n. It is
projected so again and again. Where F folds, the boxes of cells that are not nearly linear tell less.
"""

from functools import cached_property

import numpy as np

from ...vectors import dot, norms
from ..labels import IN, decided
from ..motion.boxes import from_box
from ..motion.linear import solved
from ..plane.loops import Loops
from ..plane.smooth import Disc, Superdisc
from .least import CHUNK, FAIR, MOST, Along

STEPS = 10
SAFE = 0.85  # of a distance that is not small: bends of what is swept leave it as much too large
ASIDE = 0.1  # of a half cell: roots so far outside count
REACH = 1.001  # of half a cell, for rounding
MISSED = 1e-3  # of a cell: what is so near the outline is on it
ARC = 16  # chords of each edge
LEAST = 1e-300


class DeformedDistance:
    """The distance of a `DeformedBody`.

    Parameters
    ----------
    body : DeformedBody
        A solid.
    """

    def __init__(self, body):
        self.body, self.way, self.region = body, body.way, body.region
        way, pieces = self.way, self.pieces()
        order = np.argsort(way.middle[pieces[0], 2], kind="stable")
        self.cell, start, self.edge, self.corner, self.end = (part[order] for part in pieces)
        self.start = np.column_stack((start, way.middle[self.cell, 2]))
        self.start[:, 2] = np.where(np.isnan(self.end), self.start[:, 2], self.end)
        reached = np.flatnonzero((self.edge >= 0) | self.corner | self.brought())
        rough = np.flatnonzero(~way.linear)
        self.start, self.end = self.start[reached], self.end[reached]
        self.edge, self.corner = self.edge[reached], self.corner[reached]
        self.cell = np.concatenate((self.cell[reached], rough))
        self.samples = np.concatenate((way.places(self.start), np.full((1, 3), np.inf)))  # the last of none
        low, high = way.low[self.cell], way.high[self.cell]
        known = np.arange(len(self.cell)) < len(reached)
        self.along = Along((low + high) / 2, np.zeros_like(low), norms(high - low) / 2, known)

    def pieces(self):
        """What the boundary is looked for in: cells, places of the figure, edges, if these are corners, and ends.

        The number of an edge is -1 where all of the outline is meant, or of a face what is within. Corners are ends of
        edges. The end is where on its way the figure, or an edge, stands; it is no number where all of the way counts.
        """
        way, loops = self.way, self.loops
        linear = np.flatnonzero(way.linear)
        middle, half = way.middle[linear, :2], way.half[linear, :2]
        parts = [(linear, middle, -1, False)]
        if loops:
            edge, cell, start = crossed(loops, middle, (1 + ASIDE) * half)
            parts.append((linear[cell], start, edge, False))
        corners = corners_of(loops or self.region.region) if self.region.is_still else np.zeros((0, 2))
        corner, cell = np.nonzero((np.abs(corners[:, None] - middle) <= REACH * half).all(axis=2))
        parts.append((linear[cell], corners[corner], -1, True))
        cell, start, edge, corner = (
            np.concatenate([np.broadcast_to(part[i], (len(part[0]), *np.shape(part[i])[1:])) for part in parts])
            for i in range(4)
        )
        skin = np.flatnonzero((edge >= 0) | corner | (loops is None))
        pieces = [(cell[skin], start[skin], edge[skin], corner[skin], np.full(len(skin), np.nan))]
        for end, _ in self.body.ends:
            last = np.flatnonzero(np.abs(way.middle[cell, 2] - end) <= REACH * way.half[cell, 2])
            pieces.append((cell[last], start[last], edge[last], corner[last], np.full(len(last), end)))
        for turn in way.breaks[1 if self.body.ends else 0 : -1]:  # where the way may turn at once, the outline's edges
            last = np.flatnonzero(
                (np.abs(way.middle[cell, 2] - turn) <= REACH * way.half[cell, 2]) & ((edge >= 0) | corner)
            )
            pieces.append((cell[last], start[last], edge[last], corner[last], np.full(len(last), turn)))
        return [np.concatenate(part) for part in zip(*pieces, strict=True)]

    def __call__(self, points):
        """How far points (n, 3) are from the boundary, or a fair part of that; negative inside: (n,)."""
        found, rounding = np.empty(len(points)), 1e-9 * self.way.size
        size = min(max(CHUNK // len(self.along.first), 1), MOST)
        for start in range(0, len(points), size):
            some = points[start : start + size]
            labels = decided(self.body.labels(some, rounding), some, rounding, self.body)
            least = self.of_some(some)
            found[start : start + size] = np.where(labels == IN, -least, least)
        return found

    def of_some(self, points):
        """How far so few points that all pairs fit into memory are from the boundary: (n,)."""
        point, piece, lower, most = self.along.candidates(points)
        cell, known = self.cell[piece], piece < len(self.start)
        lower = np.maximum(lower, from_box(points[point], self.way.low[cell], self.way.high[cell]))
        value = np.where(known, norms(points[point] - self.samples[np.where(known, piece, -1)]), lower)
        np.minimum.at(most, point, value)
        found = np.full(len(points), np.inf)
        point, kept = self.along.settled(found, point, lower, most, FAIR)
        if len(point):
            known = np.flatnonzero(piece[kept] < len(self.start))
            q, missed = self.followed(points[point[known]], piece[kept][known])
            far = norms(points[point[known]] - self.way.places(q)) + missed
            np.minimum.at(most, point[known], far)
            least = np.full(len(points), np.inf)
            np.minimum.at(least, point, lower[kept])
            found[point] = np.where(most <= self.along.near, most, np.maximum(least, SAFE * most))[point]
        return found

    def followed(self, points, piece):
        """Places in pieces of the boundary that go nearest to points (p, 3), and how far they are from the boundary."""
        q, end, edge, corner = self.start[piece].copy(), self.end[piece], self.edge[piece], self.corner[piece]
        face = ~np.isnan(end)
        room = self.way.half[self.cell[piece]] * (1 + ASIDE, 1 + ASIDE, 1.0)
        low, high = (self.way.middle[self.cell[piece]] + side * room for side in (-1, 1))
        box = np.column_stack((self.region.box, (0.0, self.way.total)))
        low, high = np.maximum(low, box[0]), np.minimum(high, box[1])
        for _ in range(STEPS):
            here = self.way.places(q)
            slopes = self.way.slopes(q, here)
            back = inverted(slopes)
            depth, across = self.outward(q, back, edge)
            left, along = np.where(face, end - q[:, 2], 0.0), slopes[:, :, 2]
            step = projected(points - here, depth, across, back[:, 2], left, face, edge >= 0)
            step = np.einsum("nij,nj->ni", back, step)
            step[corner] = 0.0
            step[corner, 2] = (dot(along, points - here) / np.maximum(dot(along, along), LEAST))[corner]
            q = np.clip(q + step, low, high)
            q[:, 2] = np.where(face, end, q[:, 2])
        here = self.way.places(q)
        depth, across = self.outward(q, inverted(self.way.slopes(q, here)), np.full(len(q), -1))
        missed = np.where(face & (edge < 0), np.maximum(depth, 0.0), np.abs(depth)) / np.maximum(norms(across), LEAST)
        return q, np.where(corner, 0.0, missed)

    def brought(self):
        """Bring the starts of what is no edge to the outline or, of faces, within it: which come to be, (p,) bool."""
        for _ in range(STEPS):
            depth, outward = self.region.exact(self.start[:, :2], self.start[:, 2])
            depth = np.where(np.isnan(self.end), depth, np.maximum(depth, 0.0))
            depth[(self.edge >= 0) | self.corner] = 0.0
            self.start[:, :2] -= depth[:, None] * outward
        half = self.way.half[self.cell, :2]
        off = np.abs(self.start[:, :2] - self.way.middle[self.cell, :2])
        return (off <= (1 + ASIDE) * half).all(axis=1) & (np.abs(depth) <= MISSED * half.min(axis=1))

    @cached_property
    def loops(self):
        """The lines and arcs of the outline, if it is of such."""
        region = getattr(self.region, "region", None)
        if isinstance(region, Disc):
            ends = region.radius * np.array([(1.0, 0), (0, 1), (-1, 0), (0, -1)])
            region = Loops.of(ends, np.array([0, 4]), np.full(4, np.tan(np.pi / 8)))
        return region if isinstance(region, Loops) else None

    def outward(self, q, back, edge):
        """How far places q (n, 3) are from an edge's line or the outline, and how that grows in space: (n,), (n, 3)."""
        depth, outward = self.region.exact(q[:, :2], q[:, 2])
        some = np.flatnonzero(edge >= 0)
        if len(some):
            depth[some] = self.loops.distances(edge[some], q[some, :2])[0]
            outward[some] = self.loops.right(edge[some], q[some, :2])
        growth = np.broadcast_to(self.region.growth(q[:, :2], q[:, 2]), len(q))
        return depth, np.einsum("ni,nij->nj", np.column_stack((outward, growth)), back)


def crossed(loops, middle, half):
    """Which edges cross which rectangles about middles (n, 2): the numbers of both, and a place there, (p, 2)."""
    part = np.linspace(0.0, 1.0, ARC + 1)[:, None, None]
    chord = loops.end - loops.start
    corners = loops.start + part * chord
    turn = 4 * np.arctan(loops.bulges)[:, None] * part
    spoke = loops.start - loops.centres
    round_ = np.stack((-spoke[:, 1], spoke[:, 0]), axis=1)
    corners = np.where(loops.arcs[:, None], loops.centres + np.cos(turn) * spoke + np.sin(turn) * round_, corners)
    edge = np.tile(np.arange(len(chord)), ARC)
    start, way = corners[:-1].reshape(-1, 2), np.diff(corners, axis=0).reshape(-1, 2)
    with np.errstate(divide="ignore", invalid="ignore"):
        sides = [(middle + side * half - start[:, None]) / way[:, None] for side in (-1, 1)]
    outside = (way == 0)[:, None] & (np.abs(start[:, None] - middle) > half)
    level = np.broadcast_to((way == 0)[:, None], outside.shape)
    first = np.where(level, 0.0, np.minimum(*sides)).max(axis=2).clip(0.0, 1.0)
    last = np.where(level, 1.0, np.maximum(*sides)).min(axis=2).clip(0.0, 1.0)
    piece, cell = np.nonzero((first < last) & ~outside.any(axis=2))
    found = start[piece] + ((first + last) / 2)[piece, cell][:, None] * way[piece]
    across = loops.distances(edge[piece], found)[0]
    found -= np.where(loops.arcs[edge[piece]], across, 0.0)[:, None] * loops.right(edge[piece], found)
    _, one = np.unique(np.stack((edge[piece], cell)), axis=1, return_index=True)
    return edge[piece[one]], cell[one], found[one]


def corners_of(region):
    """The corners of a region's outline, smooth joints among them: (k, 2)."""
    if isinstance(region, Loops):
        return region.start
    if isinstance(region, Superdisc) and region.exponent < 2:
        return np.concatenate([np.diag(region.half) * side for side in (-1, 1)])
    return np.zeros((0, 2))


def inverted(matrices):
    """The inverses of (n, 3, 3), or of what is next to them where they have none."""
    return solved(matrices[:, None], np.eye(3)).swapaxes(1, 2)


def projected(way, depth, across, along, left, face, rim):
    """Ways (n, 3) to points, brought to the outline's plane, or to that of a face and within the outline or at the rim.

    The outline is where ``across . y`` is minus the depth, the face where ``along . y`` is what is left.
    """
    aa, bb = (np.maximum(dot(axis, axis), LEAST) for axis in (across, along))
    outline = way - ((dot(across, way) + depth) / aa)[:, None] * across
    on_face = way - ((dot(along, way) - left) / bb)[:, None] * along
    beyond = rim | (depth + dot(across, on_face) > 0)
    ab = dot(across, along)
    flat = np.maximum(aa * bb - ab**2, LEAST)
    a, b = dot(across, way) + depth, dot(along, way) - left
    both = way - ((bb * a - ab * b) / flat)[:, None] * across - ((aa * b - ab * a) / flat)[:, None] * along
    return np.where(face[:, None], np.where(beyond[:, None], both, on_face), outline)

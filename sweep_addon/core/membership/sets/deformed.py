# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweeps of planar figures that are deformed on their way, as sets of points: inverse sweeping without a plane."""

from functools import cached_property

import numpy as np

from ...vectors import norms
from ..labels import IN, ON, OUT, TOUCHED
from ..motion.deforming import EXACT
from ..motion.hash import portions
from .deformed_distance import DeformedDistance

CHUNK = 1 << 13  # pairs of points and cells at a time
FOLD = 4.0  # tolerances: what is around a point is looked at not so far out
LEAST = 1e-150


class DeformedBody:
    """All points that a deformed figure visits.

    Parameters
    ----------
    way : Deforming
    closed : bool
        Whether the figure comes back to where it began.
    faces : tuple of two bool
        Whether one closes its start and its end.
    """

    overlaps = True

    def __init__(self, way, closed, faces):
        self.way, self.region, self.box = way, way.region, way.box
        self.ends = () if closed else ((0.0, faces[0]), (way.total, faces[1]))
        self.is_sheet = self.region.is_open or not (closed or all(faces))

    def labels(self, points, tolerance):
        """IN, ON, OUT, or TOUCHED where a neighbourhood decides, for points (n, 3): (n,) int8."""
        boxes, labels = self.way.boxes(tolerance), np.full(len(points), OUT, dtype=np.int8)
        counts = boxes.counts(boxes.cells(points))
        asked = np.flatnonzero(counts)
        for some in portions(counts[asked], CHUNK):
            labels[asked[some]] = self.of_places(points[asked[some]], boxes, tolerance)
        return labels

    def distance(self, points):
        """How far points (n, 3) are from the boundary, or a fair part of that, negative inside: (n,)."""
        return self.told(points)

    @cached_property
    def told(self):
        """What tells the distance."""
        return DeformedDistance(self)

    def of_places(self, points, boxes, tolerance):
        """The labels of so few points that all pairs with cells fit into memory."""
        point, cell, q, missed = self.way.back(points, boxes, tolerance)
        inside, contact = self.sides(cell, q, missed, tolerance)
        sure = np.zeros(len(points), dtype=bool)
        sure[point[inside]] = True
        contacts = np.bincount(point, contact, len(points))
        if self.is_sheet:
            return np.where(contacts > 0, ON, OUT).astype(np.int8)
        return np.where(sure, IN, np.choose(np.minimum(contacts, 2).astype(int), (OUT, ON, TOUCHED))).astype(np.int8)

    def sides(self, cell, q, missed, tolerance):
        """Which places are within the figure, (k,) bool, and which at a boundary: (k,) int, 2 where others decide."""
        slope = self.way.slopes(q, self.way.places(q))
        rates = np.linalg.pinv(slope)  # how x, y and s grow with the point: a row each
        depth = self.depths(q, rates, tolerance)
        edge, face = np.zeros((2, len(q)), dtype=bool)
        for end, closed in self.ends:
            near = np.abs(q[:, 2] - end) <= tolerance * norms(rates[:, 2])
            edge |= near
            face |= near & closed
        present = depth <= tolerance
        if self.is_sheet:
            return np.zeros(len(q), dtype=bool), (present & ((depth >= -tolerance) | face)).astype(int)
        off = missed > EXACT * self.way.size
        inside = (depth < -tolerance) & ~edge & ~off
        contact = (present & ~inside).astype(int)
        least = np.linalg.svd(slope * self.way.half[cell][:, None], compute_uv=False)[:, -1]
        bend = 2 * self.way.off[cell]
        folded = present & (~self.way.linear[cell] & (least**2 <= 2 * FOLD * tolerance * (bend + tolerance)))
        inside[folded], contact[folded] = False, 2
        return inside, contact

    def depths(self, q, rates, tolerance):
        """How far the points of places are from the figure's boundary to first order, or less if more than a tolerance.

        Negative inside: (k,). Near it the figure tells its distance and in which direction that grows; elsewhere it
        grows no faster than all three of x, y and s together.
        """
        growth = np.broadcast_to(self.region.growth(q[:, :2], q[:, 2]), len(q))
        fastest = np.sqrt((rates**2).sum(axis=(1, 2)) * (1 + growth**2))
        depth = self.region.depth(q[:, :2], q[:, 2]) / np.maximum(fastest, LEAST)
        near = np.flatnonzero(np.abs(depth) <= tolerance)
        exact, outward = self.region.exact(q[near, :2], q[near, 2])
        moving = np.einsum("ni,nij->nj", np.column_stack((outward, growth[near])), rates[near])
        depth[near] = exact / np.maximum(norms(moving), LEAST)
        return depth

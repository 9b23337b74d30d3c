# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweep-CSG trees as sets of points: the labels of the operands, put together.

Where a point is on the boundary of two operands at once neither label tells what it is of the whole: between two boxes
that share a face there is no membrane. Such points are decided by what is around them, once, at the root.

Source
------
Tilove: Set membership classification, IEEE Trans. Computers C-29(10), 1980, neighbourhoods of on/on cases.
"""

import numpy as np

from ..labels import IN, OUT, joined, negated
from ..motion.boxes import corners


class TreeMember:
    """A tree as a set of points.

    Parameters
    ----------
    base : member
    steps : list of (str, member)
        The operations and their operands.
    """

    is_sheet = False

    def __init__(self, base, steps):
        self.base, self.steps = base, steps
        self.overlaps = any(member.overlaps for member in (base, *(other for _, other in steps)))
        self.overlaps |= any(operation == "union" for operation, _ in steps)
        self.box = base.box
        for operation, other in steps:
            if operation == "union":
                self.box = np.stack((np.minimum(self.box[0], other.box[0]), np.maximum(self.box[1], other.box[1])))

    def labels(self, points, tolerance):
        """IN, ON, OUT, or TOUCHED where a neighbourhood decides, for points (n, 3): (n,) int8."""
        labels = within(self.base, points, tolerance)
        for operation, other in self.steps:
            asked = np.flatnonzero(labels != (IN if operation == "union" else OUT))
            found = within(other, points[asked], tolerance)
            if operation == "union":
                labels[asked] = joined(labels[asked], found)
            else:
                left = found if operation == "difference" else negated(found)
                labels[asked] = negated(joined(negated(labels[asked]), left))
        return labels

    def distance(self, points):
        """How far points (n, 3) are from the boundary, or less, negative inside: (n,)."""
        distance = self.base.distance(points)
        for operation, other in self.steps:
            found = other.distance(points)
            if operation == "union":
                distance = np.minimum(distance, found)
            else:
                distance = np.maximum(distance, -found if operation == "difference" else found)
        return distance


def within(member, points, tolerance):
    """The labels of points against a member, which is asked for those alone that are in its box."""
    low, high = member.box
    near = ((points >= low - 2 * tolerance) & (points <= high + 2 * tolerance)).all(axis=1)
    labels = np.full(len(points), OUT, dtype=np.int8)
    labels[near] = member.labels(points[near], tolerance)
    return labels


class PlacedMember:
    """A set of points somewhere else.

    Where a matrix stretches directions differently, what is on within the tolerance is so along the longest.
    """

    def __init__(self, placed, solid):
        self.solid, self.origin, self.is_sheet, self.overlaps = solid, placed.origin, solid.is_sheet, solid.overlaps
        self.inverse = np.linalg.inv(placed.axes)
        stretches = np.linalg.svd(placed.axes, compute_uv=False)
        self.longest, self.shortest = float(stretches[0]), float(stretches[-1])
        reached = corners(solid.box) @ placed.axes.T + placed.origin
        self.box = np.stack((reached.min(axis=0), reached.max(axis=0)))

    def back(self, points):
        """Points as the solid has them."""
        return np.einsum("ni,ji->nj", points - self.origin, self.inverse)

    def labels(self, points, tolerance):
        """IN, ON, OUT or TOUCHED for points (n, 3): (n,) int8."""
        return self.solid.labels(self.back(points), tolerance / self.longest)

    def distance(self, points):
        """How far points (n, 3) are from the boundary, or less, negative inside: (n,)."""
        return self.shortest * self.solid.distance(self.back(points))

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Crossings: which edges of closed loops cross or touch where they should not."""

import numpy as np

from .orientation import orientation
from .ranges import ranges


def crossings(points, following):
    """Find the pairs of edges that meet, other than neighbours in their common point.

    Parameters
    ----------
    points : (m, 2) float array
        The points of all loops.
    following : (m,) int array
        The next point of the same loop; edge ``i`` runs from point ``i`` to point ``following[i]``.

    Returns
    -------
    (c, 2) int array
        Pairs of edges. Neighbours are among them only where the second folds back onto the first.

    Examples
    --------
    A bow tie's two diagonals:

    >>> bow = np.array([[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]])
    >>> crossings(bow, np.array([1, 2, 3, 0])).tolist()
    [[0, 2]]
    """
    start, end = points, points[following]
    found = [folds(points, following)]
    for pairs in overlapping_boxes(np.minimum(start, end), np.maximum(start, end)):
        i, j = pairs[(following[pairs[:, 0]] != pairs[:, 1]) & (following[pairs[:, 1]] != pairs[:, 0])].T
        sides = orientation(start[i], end[i], start[j]) * orientation(start[i], end[i], end[j])
        i, j = i[sides <= 0], j[sides <= 0]
        sides = orientation(start[j], end[j], start[i]) * orientation(start[j], end[j], end[i])
        found.append(np.stack([i, j], axis=1)[sides <= 0])
    return np.concatenate(found)


def folds(points, following):
    """The pairs of neighbouring edges of which the second runs back along the first."""
    middle, last = points[following], points[following[following]]
    straight = orientation(points, middle, last) == 0
    back = np.einsum("ij,ij->i", middle - points, last - middle) < 0
    first = np.flatnonzero(straight & back)
    return np.stack([first, following[first]], axis=1)


def overlapping_boxes(low, high):
    """Yield, in portions, the (c, 2) pairs i < j of boxes that have a point in common.

    Boxes sorted by where they begin along one axis: those that begin before box i ends are a range, found by
    bisection. The axis is the one along which the fewest overlap.
    """
    axis = min((0, 1), key=lambda axis: later_starts(low[:, axis], high[:, axis])[1].sum())
    order, count = later_starts(low[:, axis], high[:, axis])
    across = 1 - axis
    for i, j in ranges(np.arange(1, len(order) + 1), count):
        i, j = order[i], order[j]
        meet = (low[i, across] <= high[j, across]) & (low[j, across] <= high[i, across])
        yield np.sort(np.stack([i[meet], j[meet]], axis=1), axis=1)


def later_starts(low, high):
    """The order of intervals by their start, and for each how many of the later ones start before it ends."""
    order = np.argsort(low, kind="stable")
    return order, np.searchsorted(low[order], high[order], side="right") - np.arange(1, len(order) + 1)

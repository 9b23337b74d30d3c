# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Crossings: which edges of closed loops cross or touch where they should not."""

import numpy as np

from ..declared.parameters import require
from ..vectors import dot
from .orientation import orientation
from .ranges import IN_CACHE, ranges

MOST_PAIRS = 512 * IN_CACHE  # of edges that may meet: about a second
TOO_MANY = f"must have at most {MOST_PAIRS:,} pairs of edges that lie beside each other"
FEW = 16  # neighbours of an edge for which no other direction is tried
ROUNDING = 16 * np.finfo(float).eps  # of the largest coordinate, when points are turned


def crossings(points, following):
    """Find pairs of edges that meet, other than neighbours in their common point.

    Parameters
    ----------
    points : (m, 2) float array
        The points of all loops.
    following : (m,) int array
        The next point of the same loop; edge ``i`` runs from point ``i`` to point ``following[i]``.

    Returns
    -------
    (c, 2) int array
        Pairs of edges: all of them if there are few, some if there are many. Neighbours are among them only where the
        second folds back onto the first.

    Raises
    ------
    ShapeError
        When so many edges lie close beside each other that the search would take too long.

    Examples
    --------
    A bow tie's two diagonals:

    >>> bow = np.array([[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]])
    >>> crossings(bow, np.array([1, 2, 3, 0])).tolist()
    [[0, 2]]
    """
    found = folds(points, following)
    start, end = points, points[following]
    low, high = np.minimum(start, end), np.maximum(start, end)
    boxes = fewest_neighbours(start, end)
    total = int(boxes[-1].sum())
    for portion, pairs in enumerate(meeting_boxes(*boxes)):
        require(portion * IN_CACHE < MOST_PAIRS, TOO_MANY, total)
        i, j = pairs.T
        apart = np.flatnonzero((following[i] != j) & (following[j] != i))
        i, j = i[apart], j[apart]
        for _ in range(2):  # the ends of one on different sides of the other, and the other way round
            a, b, c, d = (ends.take(edges, axis=0) for edges in (i, j) for ends in (start, end))
            meet = np.flatnonzero(orientation(a, b, c) * orientation(a, b, d) <= 0)
            i, j = j[meet], i[meet]
        meet = ((low[i] <= high[j]) & (low[j] <= high[i])).all(axis=1)
        found = np.concatenate([found, np.stack([i, j], axis=1)[meet]])
        if len(found):
            break
    return found


def folds(points, following):
    """The pairs of neighbouring edges of which the second runs back along the first."""
    middle, last = points[following], points[following[following]]
    straight = orientation(points, middle, last) == 0
    back = dot(middle - points, last - middle) < 0
    first = np.flatnonzero(straight & back)
    return np.stack([first, following[first]], axis=1)


def fewest_neighbours(start, end):
    """The boxes of edges `swept`: upright ones, or, if it spares work, ones that lean like most of the edges."""
    upright = swept(np.minimum(start, end), np.maximum(start, end))
    if upright[-1].sum() <= FEW * len(start):
        return upright
    edges = (end - start) @ (1, 1j)
    way = np.sqrt((edges * edges).sum())  # the square of an edge is that of its reverse
    turn = np.array([[way.real, -way.imag], [way.imag, way.real]]) / (abs(way) or 1)
    room = ROUNDING * max(np.abs(start).max(), np.abs(end).max())
    start, end = start @ turn, end @ turn
    leaning = swept(np.minimum(start, end) - room, np.maximum(start, end) + room)
    return min(upright, leaning, key=lambda boxes: boxes[-1].sum())


def overlapping_boxes(low, high):
    """Yield, in portions, the (c, 2) pairs i < j of boxes that have a point in common."""
    return meeting_boxes(*swept(low, high))


def swept(low, high):
    """Boxes sorted so that those that may meet a box are a range behind it.

    They are sorted by where they begin along one axis: those that begin before box i ends are a range, found by
    bisection. The axis is the one along which the fewest overlap. This is done in strips along it, each of which has
    the boxes that lie in it at least in part: so many strips that all have about twice as many boxes as there are.

    Returns
    -------
    low, high : (n, 2) float arrays
        The boxes, the axis first.
    first : (n,) int array
        The first strip of each box.
    box, strip : (s,) int arrays
        The boxes, sorted, once for each strip.
    count : (s,) int array
        How many of those behind may meet it.
    """
    n = len(low)
    starts = [later_starts(low[:, axis], high[:, axis]) for axis in (0, 1)]
    axis = min((0, 1), key=lambda axis: starts[axis][1].sum())
    (place, later), (place_across, later_across) = starts[axis], starts[1 - axis]
    strips = np.clip(n * n // max(later_across.sum(), 1), 1, n)
    width = -(-n // strips)
    first, last = place_across // width, (place_across + later_across) // width
    many = last - first + 1
    box = np.repeat(np.arange(n), many)
    strip = np.arange(len(box)) - np.repeat(np.cumsum(many) - many - first, many)
    key = strip * n + place[box]
    order = np.argsort(key)
    box, strip, key = box[order], strip[order], key[order]
    count = np.searchsorted(key, key + later[box], side="right") - np.arange(1, len(key) + 1)
    axes = [axis, 1 - axis]
    return low[:, axes], high[:, axes], first, box, strip, count


def meeting_boxes(low, high, first, box, strip, count):
    """Yield, in portions, the (c, 2) pairs i < j of `swept` boxes that have a point in common."""
    low, high = low[:, 1], high[:, 1]
    for i, j in ranges(np.arange(1, len(box) + 1), count, IN_CACHE):
        here, i, j = strip[i], box[i], box[j]
        once = here == np.maximum(first[i], first[j])  # boxes that share several strips are a pair of one
        meet = np.flatnonzero(once & (low[i] <= high[j]) & (low[j] <= high[i]))
        i, j = i[meet], j[meet]
        yield np.stack([np.minimum(i, j), np.maximum(i, j)], axis=1)


def later_starts(low, high):
    """Of each interval the place in their order by start, and how many of the later ones start before it ends."""
    order = np.argsort(low, kind="stable")
    place = np.empty(len(order), dtype=np.intp)
    place[order] = np.arange(len(order))
    return place, np.searchsorted(low[order], high, side="right") - 1 - place

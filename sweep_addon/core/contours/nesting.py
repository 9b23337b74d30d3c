# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Nesting: which loops lie in which, and so which bound an island and which a hole."""

import numpy as np

from ..declared.parameters import require
from ..meshes.runs import following, run_of
from .orientation import orientation
from .ranges import IN_CACHE, ranges

MOST_LEVEL = 1 << 26  # edges on a level with first points of loops: about a second
MOST_PASSED = 1 << 22  # of them on one side of loops that they may lie around: memory


def nesting(points, offsets):
    """Find, of loops that do not meet, those that lie in others.

    Parameters
    ----------
    points : (m, 2) float array
        The points of all loops, one loop after the other.
    offsets : (k + 1,) int array
        Loop ``i`` is ``points[offsets[i]:offsets[i + 1]]``.

    Returns
    -------
    (c, 2) int array
        All pairs of a loop and one that it lies in. How often a loop comes first is its depth: even-odd, loops of an
        even depth bound islands, those of an odd depth holes.

    Examples
    --------
    >>> square = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    >>> nesting(np.concatenate([square * 4, square + 1]), np.array([0, 4, 8])).tolist()
    [[1, 0]]

    A loop lies in another if a ray from its first point along an axis passes an odd number of the other's edges.
    """
    if len(offsets) == 2:
        return np.zeros((0, 2), dtype=int)
    loop, places, after = run_of(offsets), points[offsets[:-1]], following(offsets)
    levels = [on_a_level(points[:, axis], after, places[:, axis]) for axis in (0, 1)]
    axis = min((0, 1), key=lambda axis: levels[axis][2].sum())
    order, first, count = levels[axis]
    few = count.sum() <= MOST_LEVEL
    require(few, f"must have at most {MOST_LEVEL:,} edges on a level with other loops", int(count.sum()))
    across = points[:, 1 - axis]
    low, high = (bound.reduceat(across, offsets[:-1])[loop] for bound in (np.minimum, np.maximum))
    found, total = [np.zeros(0, dtype=int)], 0
    for edge, place in ranges(first, count, IN_CACHE):
        place = order[place]
        there = across[offsets[place]]
        near = np.flatnonzero((low[edge] < there) & (there < high[edge]) & (loop[edge] != place))
        edge, place = edge[near], place[near]
        start, end = points[edge], points[after[edge]]
        rises = end[:, axis] > start[:, axis]
        passed = (orientation(start, end, places[place]) > 0) == rises
        found.append((place * len(places) + loop[edge])[passed])
        total += len(found[-1])
        require(total <= MOST_PASSED, f"must have at most {MOST_PASSED:,} edges around other loops", total)
    pairs, passed = np.unique(np.concatenate(found), return_counts=True)
    return np.stack(np.divmod(pairs[passed % 2 == 1], len(places)), axis=1)


def on_a_level(heights, after, places):
    """The order of places by height, and of each edge the range of those on a level with it: first and count."""
    order = np.argsort(places, kind="stable")
    first, past = np.searchsorted(places[order], np.sort([heights, heights[after]], axis=0))
    return order, first, past - first

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Nesting: which loops lie in which, and so which bound an island and which a hole."""

import numpy as np

from .crossing import overlapping_boxes
from .loops import following
from .orientation import orientation
from .ranges import ranges


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
    """
    low, high = np.minimum.reduceat(points, offsets[:-1]), np.maximum.reduceat(points, offsets[:-1])
    found = [np.zeros((0, 2), dtype=int)]
    for pairs in overlapping_boxes(low, high):
        pairs = np.concatenate([pairs, pairs[:, ::-1]])
        inner, outer = pairs.T
        pairs = pairs[((low[inner] > low[outer]) & (high[inner] < high[outer])).all(axis=1)]
        found.append(pairs[inside(points[offsets[pairs[:, 0]]], pairs[:, 1], points, offsets)])
    return np.concatenate(found)


def inside(places, loops, points, offsets):
    """Tell which of (p, 2) places lie in one loop each, (p,): those with an odd number of its edges to the right."""
    after = following(offsets)
    passed = np.zeros(len(places), dtype=int)
    for i, edge in ranges(offsets[loops], np.diff(offsets)[loops]):
        start, end = points[edge], points[after[edge]]
        upward = end[:, 1] > start[:, 1]
        straddles = (start[:, 1] > places[i, 1]) != (end[:, 1] > places[i, 1])
        left = orientation(start, end, places[i]) > 0
        passed += np.bincount(i[straddles & (left == upward)], minlength=len(places))
    return passed % 2 == 1

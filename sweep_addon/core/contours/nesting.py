# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Nesting: which loops lie in which, and so which bound an island and which a hole."""

import numpy as np

from .loops import following
from .orientation import orientation

TESTS_AT_ONCE = 1 << 21  # bounds the memory, not the work


def nesting(points, offsets):
    """Tell for every pair of loops that do not meet whether the first lies in the second.

    Parameters
    ----------
    points : (m, 2) float array
        The points of all loops, one loop after the other.
    offsets : (k + 1,) int array
        Loop ``i`` is ``points[offsets[i]:offsets[i + 1]]``.

    Returns
    -------
    (k, k) bool array
        Entry ``[i, j]``: loop ``i`` lies in loop ``j``. The sum of a row is the depth of its loop: even-odd, loops
        of an even depth bound islands, those of an odd depth holes.

    Examples
    --------
    >>> square = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    >>> nesting(np.concatenate([square * 4, square + 1]), np.array([0, 4, 8])).astype(int).tolist()
    [[0, 0], [1, 0]]
    """
    firsts = offsets[:-1]
    inside = np.concatenate(
        [inside_loops(points[some], points, offsets) for some in np.array_split(firsts, portions(len(firsts), points))]
    )
    np.fill_diagonal(inside, False)
    return inside


def portions(tests, points):
    return min(tests, 1 + tests * len(points) // TESTS_AT_ONCE)


def inside_loops(places, points, offsets):
    """Tell for (p, 2) places and k loops, as (p, k) bool, which lie in which: an odd number of edges to the right."""
    start, end = points, points[following(offsets)]
    above = start[:, 1] > places[:, 1:]
    straddles = above != (end[:, 1] > places[:, 1:])
    left = orientation(start, end, places[:, None]) > 0
    return np.bitwise_xor.reduceat(straddles & (left == ~above), offsets[:-1], axis=1)

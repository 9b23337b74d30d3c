# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Vertices where primitives meet, put into the lines on which they lie.

Where a line is prolonged to a corner, its old end is on the longer line only to rounding. Solvers of Boolean operations
see faces as one only if they share all their vertices, to the bit: else a gap of the last digit remains between solids
that should be united.
"""

from math import hypot

from .contacts import lies_on
from .loop import Loop


def seamed(loops, near):
    """The loops with the corners of all others on their lines.

    Parameters
    ----------
    loops : sequence of Loop
    near : float
        How far from a line a corner still is on it.

    Returns
    -------
    list of Loop

    Examples
    --------
    >>> large = Loop(((0.0, 0.0), (2.0, 0.0), (0.0, 2.0)), (0.0, 0.0, 0.0))
    >>> small = Loop(((1.0, 0.0), (2.0, 0.0), (2.0, 1.0)), (0.0, 0.0, 0.0))
    >>> seamed([large, small], 1e-9)[0].corners
    ((0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (0.0, 2.0))
    """
    corners = sorted({corner for loop in loops for corner in loop.corners})
    return [with_corners(loop, corners, near) for loop in loops]


def with_corners(loop, corners, near):
    """One loop with those of the corners that are on its lines."""
    found, bulges = [], []
    for edge in loop.edges():
        start = edge[:2]
        inner = [] if edge[4] else [corner for corner in corners if between(edge, corner, near)]
        inner.sort(key=lambda corner: hypot(corner[0] - start[0], corner[1] - start[1]))
        found += [start, *inner]
        bulges += [edge[4]] * (1 + len(inner))
    return Loop(tuple(found), tuple(bulges))


def between(line, corner, near):
    """Whether a corner is on a line and neither of its ends."""
    ax, ay, bx, by, _ = line
    x, y = corner
    if not (min(ax, bx) - near <= x <= max(ax, bx) + near and min(ay, by) - near <= y <= max(ay, by) + near):
        return False
    return lies_on(line, x, y, near) and min(hypot(x - ax, y - ay), hypot(x - bx, y - by)) > near

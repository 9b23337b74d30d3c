# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which points are inside a loop of lines and arcs: in an odd number of its polygon of chords and its segments."""

import numpy as np


def inside(loop, points):
    """Whether points are inside; a point of the boundary is inside of one of the two regions that share it.

    Parameters
    ----------
    loop : Loop
    points : (n, 2) float array-like

    Returns
    -------
    (n,) bool array

    A point on a chord counts as one a little to its right, or above where the chord is horizontal, for the polygon and
    for the segment alike. Chords and arcs are computed from the lower of their ends on, so that regions which share an
    edge compute the same bits of it.

    Examples
    --------
    >>> from sweep_addon.core.conversion.loop import Loop
    >>> inside(Loop(((0.0, 0.0), (1.0, 0.0)), (1.0, 0.0)), [(0.5, -0.4), (0.5, 0.4), (0.5, -0.6)]).tolist()
    [True, False, False]
    """
    x, y = np.asarray(points, dtype=float).T
    odd = np.zeros(len(x), dtype=bool)
    for edge in loop.edges():
        ax, ay, bx, by, bulge = upwards(edge)
        dx, dy = bx - ax, by - ay
        ux, uy = x - ax, y - ay
        across = dx * uy - dy * ux
        left = np.where(across == 0, dx if dy == 0 else -dy, across) > 0
        odd ^= (ay <= y) & (y < by) & left
        if bulge:
            power = 2 * bulge * (ux * (x - bx) + uy * (y - by)) - (1 - bulge * bulge) * across
            odd ^= (power < 0) & ~left if bulge > 0 else (power > 0) & left
    return odd


def upwards(edge):
    """An edge from its lower end on; of a horizontal one from its left."""
    ax, ay, bx, by, bulge = edge
    return edge if (ay, ax) < (by, bx) else (bx, by, ax, ay, -bulge)

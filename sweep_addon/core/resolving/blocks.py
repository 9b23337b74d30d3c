# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blocks: what a contour visits where it folds, as convex hulls of a few neighbouring contours.

A point of the contour that runs backward is still on the hull of the contours round it, and the hull of contours that
turn by little holds little more than they visit: its excess is of the second order in the turn, and only where a fold
ends.
"""

import numpy as np

TURN = 0.1  # radians in a block
SLIDE = 0.1  # of the contour's width along the line about which it turns, in a block
CORNER = 0.5  # radians in one segment: a mitre, whose leg is a block of its own


def measured(rings, segments):
    """By how many radians contours turn in each segment, or as much as the ways of their points bend, or they slide.

    Parameters
    ----------
    rings : Rings
    segments : (k,) int array

    Returns
    -------
    (k,) float array
    """
    slid = np.minimum(rings.slides * TURN / SLIDE, CORNER)
    return np.maximum(np.maximum(rings.turns, rings.bends), slid)[segments]


def blocks(turned, start, end):
    """The blocks of a stretch that folds.

    Parameters
    ----------
    turned : (n,) float array
        By how many radians the rings have turned up to each, as `measured` counts.
    start, end : int
        The first ring and the last.

    Returns
    -------
    list of (int, int)
        The first and the last ring of each block. Neighbours share a segment, but at mitres.

    Examples
    --------
    >>> blocks(np.arange(7) * 0.04, 0, 6)
    [(0, 2), (1, 3), (2, 4), (3, 5), (4, 6)]
    """
    found = []
    while start < end:
        last = min(int(np.searchsorted(turned, turned[start] + TURN, side="right")) - 1, end)
        last = max(last, min(start + 2, end))
        corners = np.flatnonzero(np.diff(turned[start : last + 1]) > CORNER)
        if len(corners):
            last = start + max(int(corners[0]), 1)
        found.append((start, last))
        if last == end:
            return found
        start = last if last == start + 1 else last - 1
    return found

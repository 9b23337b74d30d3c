# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The arrangement of edges in the plane: split where they meet, so that they share nothing but ends.

On a grid of whole numbers, where the side that a point is on is decided exactly. A crossing moves to the nearest grid
point, by which an edge may come to meet another one; so the splitting is repeated until nothing meets.
"""

import numpy as np

from ..declared.parameters import ShapeError, require
from ..vectors import dot
from .crossing import overlapping_boxes

CELLS = 1 << 22  # along the longer side: a cell is below single precision, a product of two lengths below 2**53
ROUNDS = 30
MOST_PIECES = 250_000
MOST_MEETINGS = 1_000_000


def arrangement(start, end):
    """Split edges wherever they meet.

    Parameters
    ----------
    start, end : (m, 2) float arrays of whole numbers
        The ends of directed edges, at most `CELLS` in size.

    Returns
    -------
    start, end : (n, 2) float arrays of whole numbers
        The pieces, of which no two share more than ends, unless they are equal or each other's reverse.
    edge : (n,) int array
        The edge that each piece is of.

    Raises
    ------
    ShapeError
        If the splitting does not end.

    Examples
    --------
    >>> start, end = np.array([[0.0, 0.0], [0.0, 4.0]]), np.array([[4.0, 4.0], [4.0, 0.0]])
    >>> start, end, edge = arrangement(start, end)
    >>> start.tolist(), edge.tolist()
    ([[0.0, 0.0], [2.0, 2.0], [0.0, 4.0], [2.0, 2.0]], [0, 0, 1, 1])
    """
    edge = np.arange(len(start))
    for _ in range(ROUNDS):
        which, places = meetings(start, end)
        if not len(which):
            return start, end, edge
        start, end, piece_of = split(start, end, which, places)
        edge = edge[piece_of]
        require(len(start) <= MOST_PIECES, f"must have overlaps of at most {MOST_PIECES} pieces", len(start))
    raise ShapeError("must have paths whose overlaps can be resolved, got some that cross too often")


def meetings(start, end):
    """Which edges have to be split and where, as (c,) ints and (c, 2) grid points."""
    which, places, met = [np.zeros(0, dtype=int)], [np.zeros((0, 2))], 0
    for pairs in overlapping_boxes(np.minimum(start, end), np.maximum(start, end)):
        met += len(pairs)
        require(met <= MOST_MEETINGS, f"must overlap at no more than {MOST_MEETINGS} pairs of edges", met)
        i, j = pairs.T
        a, b, c, d = start[i], end[i], start[j], end[j]
        sides = [side(a, b, c), side(a, b, d), side(c, d, a), side(c, d, b)]
        cross = (sides[0] * sides[1] < 0) & (sides[2] * sides[3] < 0)
        part = sides[2] / np.where(cross, sides[2] - sides[3], 1)
        there = np.rint(a + part[:, None] * (b - a))
        for edge, place, holds in (
            (i, there, cross),
            (j, there, cross),
            (i, c, (sides[0] == 0) & strictly_between(a, b, c)),
            (i, d, (sides[1] == 0) & strictly_between(a, b, d)),
            (j, a, (sides[2] == 0) & strictly_between(c, d, a)),
            (j, b, (sides[3] == 0) & strictly_between(c, d, b)),
        ):
            holds = holds & (place != start[edge]).any(axis=1) & (place != end[edge]).any(axis=1)
            which.append(edge[holds])
            places.append(place[holds])
    return np.concatenate(which), np.concatenate(places)


def side(a, b, c):
    """How far c is to the left of the line from a to b, times its length: exact for numbers of the grid."""
    return (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])


def strictly_between(a, b, c):
    """Whether c, on the line through a and b, is between them and neither of them."""
    return dot(c - a, c - b) < 0


def split(start, end, which, places):
    """Split edges at places: the pieces in order, and the edge that each is of."""
    along = dot(places - start[which], (end - start)[which])
    edge = np.concatenate([np.arange(len(start)), which])
    order = np.lexsort((np.concatenate([np.zeros(len(start)), along]), edge))
    edge, begin = edge[order], np.concatenate([start, places])[order]
    last = np.append(edge[1:] != edge[:-1], True)
    finish = np.where(last[:, None], end[edge], np.roll(begin, -1, axis=0))
    some = (begin != finish).any(axis=1)
    return begin[some], finish[some], edge[some]

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Filling: from loops that overlap as they like, with fill rules, to loops around what is filled."""

import numpy as np

from ..declared.parameters import require
from ..meshes.runs import following, run_of
from .arrangement import CELLS, arrangement, side
from .ranges import ranges

MOST_WINDINGS = 20_000_000
THIN = 2  # cells: a filled sliver or a gap of less mean width is a rounding of the file's numbers
APART = 16  # cells by which loops that meet in a point are drawn back from it

QUARTER_TURN = np.array([[0.0, 1.0], [-1.0, 0.0]])  # so that fewest pieces are level with a place: a line of text is


def filled(loops, figure, even_odd):
    """Loops around the area that figures fill together.

    Parameters
    ----------
    loops : sequence of (n, 2) float arrays
        Closed loops, which may cross and touch themselves and each other.
    figure : (k,) int array
        The figure that each loop belongs to.
    even_odd : (f,) bool array
        How each figure is filled: where its loops run round an odd number of times, or any but zero.

    Returns
    -------
    list of (n, 2) float arrays
        Loops that do not meet, the filled area on their left; empty where nothing is filled. Points move by less than
        a four-millionth of the size. Where areas touch in a point they are drawn apart by a few of these.

    Raises
    ------
    ShapeError
        For overlaps beyond what can be resolved.

    Examples
    --------
    Two squares that overlap become one loop:

    >>> square = np.array([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)])
    >>> [len(loop) for loop in filled([square, square + 1], np.array([0, 1]), np.array([False, False]))]
    [8]
    """
    loops, figure = [loop for loop in loops if len(loop)], figure[[len(loop) > 0 for loop in loops]]
    if not loops:
        return []
    points, offsets = np.concatenate(loops), np.cumsum([0, *(len(loop) for loop in loops)])
    origin = points.min(axis=0)
    cell = 2.0 ** np.ceil(np.log2(max(np.ptp(points, axis=0).max() / CELLS, 1e-300)))
    grid = np.rint((points - origin) / cell)
    start, end = grid, grid[following(offsets)]
    some = (start != end).any(axis=1)
    if not some.any():
        return []
    start, end, edge = arrangement(start[some], end[some])
    crowd = np.abs(end - start).sum(axis=0) / np.maximum(np.ptp(start, axis=0), 1)
    turn = QUARTER_TURN if crowd[0] < crowd[1] else np.eye(2)
    start, end = boundary(start @ turn, end @ turn, figure[run_of(offsets)][some][edge], even_odd)
    start, end = start @ turn.T, end @ turn.T
    return [origin + cell * loop for loop in traced(start, end) if wide(loop)]


def boundary(start, end, figure, even_odd):
    """The pieces with the filled area on one side only, directed to have it on their left."""
    low, high, _, left, right = sided(start, end, np.ones(len(start), dtype=int), figure, even_odd)
    forth, back = left & ~right, right & ~left
    return np.concatenate([low[forth], high[back]]), np.concatenate([high[forth], low[back]])


def sided(start, end, turns, figure, even_odd):
    """The different pieces, and on which of their sides the area is filled.

    Parameters
    ----------
    start, end : (n, 2) float arrays of grid points
        Pieces of loops and others that share nothing but ends; those that are a point are places to ask about.
    turns : (n,) int array
        How often the loops of a figure run along each piece; 0 for pieces of no loop.
    figure : (n,) int array
    even_odd : (f,) bool array

    Returns
    -------
    low, high : (p, 2) float arrays
        The ends of the different pieces, whichever way they run.
    piece : (n,) int array
        The number of each given piece among these.
    left, right : (p,) bool arrays
        Whether the area on either side is filled, seen from low to high.
    """
    backward = (end[:, 1] < start[:, 1]) | ((end[:, 1] == start[:, 1]) & (end[:, 0] < start[:, 0]))
    ends = np.where(backward[:, None], np.hstack([end, start]), np.hstack([start, end]))
    order = np.lexsort(ends.T)
    new = np.append(True, (np.diff(ends[order], axis=0) != 0).any(axis=1))
    piece = np.empty(len(order), dtype=int)
    piece[order] = np.cumsum(new) - 1
    low, high = ends[order][new][:, :2], ends[order][new][:, 2:]

    require(len(low) * len(even_odd) <= MOST_WINDINGS, "must have fewer paths and points", len(low) * len(even_odd))
    own = sums(piece, figure, np.where(backward, -turns, turns), (len(low), len(even_odd)))
    above = windings(low, high, own)
    level = (low[:, 1] == high[:, 1])[:, None]
    left, right = np.where(level, above, above + own), np.where(level, above - own, above)
    left, right = (np.where(even_odd, turns % 2, turns).any(axis=1) for turns in (left, right))
    return low, high, piece, left, right


def windings(low, high, own):
    """How often each figure's loops run round a place at the right of each upward piece, or above each level one.

    That is the sum of what pieces further to the right carry, upward ones counted positive. Sorted by height, the
    middles that are level with a piece are a range.

    Parameters
    ----------
    low, high : (n, 2) float arrays
        The ends of different pieces.
    own : (n, f) int array
        How often each figure runs along each piece from its low to its high end.
    """
    middle = low + high
    by_height = np.argsort(middle[:, 1], kind="stable")
    piece, figure = np.nonzero(own)
    first, past = np.searchsorted(middle[by_height, 1], 2 * np.stack([low[piece, 1], high[piece, 1]]))
    total = np.zeros(own.shape, dtype=int)
    for i, j in ranges(first, past - first):
        j = by_height[j]
        right = (side(2 * low[piece[i]], 2 * high[piece[i]], middle[j]) > 0) & (piece[i] != j)
        i, j = i[right], j[right]
        total += sums(j, figure[i], own[piece[i], figure[i]], own.shape)
    return total


def sums(row, column, value, shape):
    """An int array of a shape with values added up where they belong."""
    return np.bincount(row * shape[1] + column, value, shape[0] * shape[1]).astype(int).reshape(shape)


def traced(start, end):
    """Follow directed pieces, which have the filled area on their left, to loops that do not meet."""
    follower, crowded = followers(start, end)
    begin = np.where(crowded[:, None], drawn_back(start, end, follower), start)
    return [begin[loop] for loop in orbits(follower)]


def followers(start, end):
    """The piece that follows each, (n,) ints, and whether several loops pass where each starts, (n,) bools.

    Around a point that several loops pass, pieces that leave and that arrive alternate. An arriving piece is followed
    by the next leaving one clockwise: then a loop has one filled angle there, and can be drawn back into it.
    """
    count = len(start)
    way = np.concatenate([end - start, start - end])
    place = np.concatenate([start, end])
    order = np.lexsort((np.arctan2(way[:, 1], way[:, 0]), place[:, 1], place[:, 0]))
    new = np.append(True, (np.diff(place[order], axis=0) != 0).any(axis=1))[: count * 2]
    group = np.cumsum(new) - 1
    size = np.bincount(group)
    previous = np.arange(2 * count) - 1
    previous[new] += size
    arrives = order >= count
    follower = np.empty(count, dtype=int)
    follower[order[arrives] - count] = order[previous[arrives]]

    crowded = np.empty(2 * count, dtype=bool)
    crowded[order] = size[group] > 2
    return follower, crowded[:count]


def drawn_back(start, end, follower):
    """The start of each piece, moved into the filled angle between it and the piece that it follows."""
    before = np.empty(len(start), dtype=int)
    before[follower] = np.arange(len(start))
    out, back = end - start, start[before] - start
    angle = np.arctan2(out[:, 1], out[:, 0])
    wide = (np.arctan2(back[:, 1], back[:, 0]) - angle) % (2 * np.pi)
    middle = angle + wide / 2
    room = np.minimum(np.hypot(*out.T), np.hypot(*back.T)) / 4
    return start + np.minimum(room, APART)[:, None] * np.stack([np.cos(middle), np.sin(middle)], axis=1)


def orbits(follower):
    """The cycles of a permutation, as lists."""
    follower, unseen = follower.tolist(), dict.fromkeys(range(len(follower)))
    cycles = []
    while unseen:
        cycle, i = [], next(iter(unseen))
        while i in unseen:
            del unseen[i]
            cycle.append(i)
            i = follower[i]
        cycles.append(cycle)
    return cycles


def wide(loop):
    """Whether a loop of grid points encloses more than a sliver."""
    edges = np.roll(loop, -1, axis=0) - loop
    x, y = (loop - loop[0]).T
    return abs(x @ edges[:, 1] - y @ edges[:, 0]) > THIN * np.hypot(*edges.T).sum()

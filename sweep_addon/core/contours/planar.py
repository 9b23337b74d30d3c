# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Planar sets of mixed dimension: areas, curves and points together, each place of the plane in one of them once.

Whatever meets is split there, so that parts that touch have a point in common. What of a curve lies in an area or on
its boundary is of the area already, and so is a point.
"""

import numpy as np

from ..meshes.runs import following, run_of
from .arrangement import CELLS, arrangement, side, split
from .crossing import overlapping_boxes
from .filling import drawn_back, followers, orbits, sided, wide
from .section import SHARP, Section

NEAR = 1.0  # cells: a point so close to an edge is on it


def united(loops, figure, even_odd, curves, points):
    """The sections of a planar set.

    Parameters
    ----------
    loops : sequence of (n, 2) float arrays
        Closed loops, which may cross and touch.
    figure : (k,) int array
        The figure that each loop belongs to.
    even_odd : (f,) bool array
        How each figure is filled: where its loops run round an odd number of times, or any but zero.
    curves : sequence of (n, 2) float arrays
        Open lines, which may cross and touch all.
    points : (p, 2) float array

    Returns
    -------
    areas : Section or None
        What the figures fill together, if anything.
    lines : Section or None
        What of curves, and then of points, each a line of one, is in no area.

    Given points stay where they are. Those closer than a four-millionth of the size are one, and others move by that.

    Examples
    --------
    A line through a square is what sticks out of it, left and right; the square has points where it does:

    >>> square = np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])
    >>> line = np.array([(-2.0, 0.0), (2.0, 0.0)])
    >>> areas, lines = united([square], np.array([0]), np.array([True]), [line], np.zeros((0, 2)))
    >>> len(areas.points), lines.points.tolist(), lines.offsets.tolist()
    (6, [[-2.0, 0.0], [-1.0, 0.0], [1.0, 0.0], [2.0, 0.0]], [0, 2, 4])
    """
    given = np.concatenate([*loops, *curves, points])
    grid = Nodes(given)
    start, end, source = edges(grid, loops, curves)
    places = grid.of(points)
    if len(start):
        start, end, source = split_near(start, end, source, grid.of(given))
        start, end, edge = arrangement(start, end)
        source = source[edge]
    of_loop = source < len(loops)
    turns, owner = of_loop.astype(int), np.append(figure, 0)[np.where(of_loop, source, -1)]
    asked = np.concatenate((start, places)), np.concatenate((end, places))
    none = np.zeros(len(places), dtype=int)
    low, high, piece, left, right = sided(
        *asked, np.concatenate((turns, none)), np.concatenate((owner, none)), even_odd
    )
    forth, back = left & ~right, right & ~left
    areas = traced(grid, np.concatenate((low[forth], high[back])), np.concatenate((high[forth], low[back])))
    filled = (left | right)[piece]
    of_area, in_area = filled[: len(start)], filled[len(start) :]
    kept = once(piece[: len(start)], ~of_loop & ~of_area)
    shown = kept | of_area
    alone = once(piece[len(start) :], ~in_area & ~met(places, start[shown], end[shown]))
    return areas, chained(grid, start, end, source, kept, places[alone])


class Nodes:
    """The grid points of a planar set, and the given points that they stand for."""

    def __init__(self, given):
        self.origin = given.min(axis=0)
        self.cell = 2.0 ** np.ceil(np.log2(max(np.ptp(given, axis=0).max() / CELLS, 1e-300)))
        self.keys, first = np.unique(keyed(self.of(given)), return_index=True)
        self.given = given[first]

    def of(self, points):
        """The grid points next to points: (n, 2) float array of whole numbers."""
        return np.rint((points - self.origin) / self.cell)

    def places(self, nodes):
        """Where grid points are: at the first given point that is next to them, if there is one."""
        index = np.searchsorted(self.keys, keyed(nodes)).clip(max=len(self.keys) - 1)
        known = (self.keys[index] == keyed(nodes))[:, None]
        return np.where(known, self.given[index], self.origin + self.cell * nodes)


def keyed(nodes):
    """A number for each grid point, (n,), exact."""
    return nodes[:, 0] * (4.0 * CELLS) + nodes[:, 1]


def edges(grid, loops, curves):
    """The ends of all edges on the grid, and the number of the loop or, after these, of the curve that each is of."""
    lines = [*loops, *curves]
    if not lines:
        return np.zeros((0, 2)), np.zeros((0, 2)), np.zeros(0, dtype=int)
    offsets = np.cumsum([0, *map(len, lines)])
    nodes, line, ahead = grid.of(np.concatenate(lines)), run_of(offsets), following(offsets)
    open_end = np.zeros(len(nodes), dtype=bool)
    open_end[offsets[len(loops) + 1 :] - 1] = True
    some = ~open_end & (nodes != nodes[ahead]).any(axis=1)
    return nodes[some], nodes[ahead][some], line[some]


def split_near(start, end, source, nodes):
    """Split edges at the nodes that lie on them but for the rounding to the grid."""
    nodes = np.unique(nodes, axis=0)
    edges = len(start)
    low = np.concatenate((np.minimum(start, end) - NEAR, nodes))
    which, places = [np.zeros(0, dtype=int)], [np.zeros((0, 2))]
    for pairs in overlapping_boxes(low, np.concatenate((np.maximum(start, end) + NEAR, nodes))):
        i, j = pairs[(pairs[:, 0] < edges) & (pairs[:, 1] >= edges)].T
        a, b, c = start[i], end[i], nodes[j - edges]
        along = b - a
        share = np.einsum("ij,ij->i", c - a, along)
        squared = np.einsum("ij,ij->i", along, along)
        on = (np.abs(side(a, b, c)) <= NEAR * np.sqrt(squared)) & (share > 0) & (share < squared)
        which.append(i[on])
        places.append(c[on])
    start, end, edge = split(start, end, np.concatenate(which), np.concatenate(places))
    return start, end, source[edge]


def once(numbers, which):
    """(n,) bool array: of the numbers that bools (n,) choose, the first of each."""
    which = np.flatnonzero(which)
    first = np.zeros(len(numbers), dtype=bool)
    first[which[np.unique(numbers[which], return_index=True)[1]]] = True
    return first


def met(places, start, end):
    """Whether each grid point is the end of a piece."""
    return np.isin(keyed(places), keyed(np.concatenate((start, end))))


def traced(grid, start, end):
    """The section that directed pieces bound, None without any.

    Loops that touch have a point in common. One that touches itself, or does nothing but touch, is drawn back there:
    it could not be filled, or not be told from those that it touches.
    """
    if not len(start):
        return None
    follower, crowded = followers(start, end)
    apart, here = grid.origin + grid.cell * drawn_back(start, end, follower), grid.places(start)
    loops = []
    for loop in map(np.array, orbits(follower)):
        if not wide(start[loop]):
            continue
        touches = crowded[loop]
        alone = touches.all() or len(np.unique(keyed(start[loop]))) < len(loop)
        points = np.where((touches & alone)[:, None], apart[loop], here[loop])
        loops.append(np.roll(points, -int(np.argmin(touches)), axis=0))
    if not loops:
        return None
    offsets = np.cumsum([0, *map(len, loops)])
    return cornered(Section(np.concatenate(loops), offsets, None))


def chained(grid, start, end, source, kept, alone):
    """The section of the kept pieces of curves, each joined to the next one of its curve, and of single points."""
    start, end, source = start[kept], end[kept], source[kept]
    if not len(start) + len(alone):
        return None
    breaks = np.append(True, (end[:-1] != start[1:]).any(axis=1) | (source[:-1] != source[1:]))[: len(start)]
    last = np.append(breaks[1:], True)[: len(start)]
    nodes = np.insert(start, np.flatnonzero(last) + 1, end[last], axis=0)
    firsts = np.flatnonzero(breaks) + np.arange(breaks.sum())
    offsets = np.concatenate((firsts, len(nodes) + np.arange(len(alone) + 1)))
    return cornered(Section(grid.places(np.concatenate((nodes, alone))), offsets, None, closed=False))


def cornered(section):
    """The section with a corner wherever it turns by more than a smooth line does."""
    return Section(section.points, section.offsets, np.abs(section.turns) > SHARP, section.closed)

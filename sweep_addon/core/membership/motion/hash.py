# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A lattice of boxes: which of many boxes points may lie in."""

import numpy as np

from ...declared.frozen import individual
from ...vectors import dot, norms

CELLS = 3  # of the lattice in the side of a box, as a rule
MOST_CELLS = 1 << 21
MOST_PAIRS = 1 << 22
ROOM = 1.001  # of a cell's diagonal, for rounding
CHUNK = 1 << 15  # points that fit into a processor's cache


@individual
class Boxes:
    """Boxes in a lattice.

    Parameters
    ----------
    low, step : (3,) float array
    shape : (3,) int array
        Cells along each axis, one more on each side of the boxes.
    number : (cells,) int array
        How many boxes reach into each.
    first : (cells + 1,) int array
    boxes : (p,) int array
        Those that reach into cell i are boxes[first[i]:first[i + 1]].
    """

    low: np.ndarray
    step: np.ndarray
    shape: np.ndarray
    first: np.ndarray
    number: np.ndarray
    boxes: np.ndarray

    @classmethod
    def of(cls, low, high, cells=CELLS, reached=None):
        """The lattice of boxes from low to high, (k, 3) each, so many cells along the side of one.

        Of each box those cells count that it reaches: ``reached(middles, half, box)`` may tell of cells with middles
        (p, 3) and half a diagonal which of them what is in the box does not reach.
        """
        least, most = low.min(axis=0), high.max(axis=0)
        size = np.maximum(most - least, 1e-9 * (most - least).max() + 1e-300)
        side = np.maximum(np.median(high - low, axis=0), size / 256) / cells
        while True:
            shape = np.clip(np.ceil(size / side).astype(int), 1, 512)
            step = size / shape
            begin = np.clip(np.floor((low - least) / step).astype(int), 0, shape - 1)
            end = np.clip(np.floor((high - least) / step).astype(int), 0, shape - 1) + 1
            counts = (end - begin).prod(axis=1)
            if (shape.prod() <= MOST_CELLS and counts.sum() <= MOST_PAIRS) or shape.max() == 1:
                break
            side = side * 1.3
        box = np.repeat(np.arange(len(low)), counts)
        within = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
        spans = (end - begin)[box]
        i, rest = np.divmod(within, spans[:, 1] * spans[:, 2])
        j, k = np.divmod(rest, spans[:, 2])
        place = np.stack((i, j, k), axis=1) + begin[box]
        if reached is not None:
            kept = reached(least + (place + 0.5) * step, ROOM * norms(step) / 2, box)
            place, box = place[kept], box[kept]
        shape = shape + 2  # a layer around it for what is outside
        i, j, k = place.T + 1
        cell = (i * shape[1] + j) * shape[2] + k
        order = np.argsort(cell, kind="stable")
        number = np.bincount(cell, minlength=int(shape.prod()))
        return cls(least, step, shape, np.append(0, np.cumsum(number)), number, box[order])

    def cells(self, points):
        """The cell that each point is in: (n,) int."""
        cell = np.empty(len(points), dtype=np.intp)
        scale = 1 / self.step
        for start in range(0, len(points), CHUNK):
            some, at = points[start : start + CHUNK], 0
            for axis, count in enumerate(self.shape.tolist()):
                place = some[:, axis] - (self.low[axis] - self.step[axis])
                place *= scale[axis]
                np.minimum(np.maximum(place, 0.0, out=place), count - 1, out=place)
                at = at * count + place.astype(np.intp)
            cell[start : start + CHUNK] = at
        return cell

    def counts(self, cell):
        """In how many boxes a point may lie that is in a cell: (n,) int."""
        return self.number[cell]

    def pairs(self, cell):
        """Pairs of points in cells, and boxes that these may lie in: two (p,) int arrays, points rising."""
        begin, counts = self.first[cell], self.number[cell]
        if len(counts) and counts.min() == counts.max() == 1:
            return np.arange(len(cell)), self.boxes[begin]
        point = np.repeat(np.arange(len(cell)), counts)
        shift = np.repeat(begin - np.cumsum(counts) + counts, counts)
        return point, self.boxes[shift + np.arange(len(point))]


@individual
class Capsules:
    """What reaches no farther than a radius from chords: cells beyond that are none of theirs.

    Parameters
    ----------
    start, chord : (k, 3) float array
    radius : (k,) float array
    """

    start: np.ndarray
    chord: np.ndarray
    radius: np.ndarray

    def __call__(self, middles, half, number):
        """Whether cells with middles (p, 3) and half a diagonal may be reached by that of a number each: (p,) bool."""
        way, chord = middles - self.start[number], self.chord[number]
        squares = dot(chord, chord)
        share = np.clip(dot(way, chord) / np.where(squares > 0, squares, 1.0), 0.0, 1.0)
        return norms(way - share[:, None] * chord) <= self.radius[number] + half


def portions(counts, most):
    """Slices of items of so many pairs each that a slice has no more than so many items and pairs, or one item."""
    total, start = np.cumsum(np.maximum(counts, 1)), 0
    while start < len(counts):
        done = total[start - 1] if start else 0
        stop = max(int(np.searchsorted(total, done + most, side="right")), start + 1)
        yield slice(start, stop)
        start = stop

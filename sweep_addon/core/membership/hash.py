# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A lattice of boxes: which of many boxes points may lie in."""

import numpy as np

from ..frozen import individual

CELLS = 3  # of the lattice in the side of a box, as a rule
MOST_CELLS = 1 << 21
MOST_PAIRS = 1 << 22
CHUNK = 1 << 15  # points that fit into a processor's cache


@individual
class Boxes:
    """Boxes in a lattice.

    Parameters
    ----------
    low, step : (3,) float array
    shape : (3,) int array
    first : (cells + 1,) int array
    boxes : (p,) int array
        Those that reach into cell i are boxes[first[i]:first[i + 1]].
    """

    low: np.ndarray
    step: np.ndarray
    shape: np.ndarray
    first: np.ndarray
    boxes: np.ndarray

    @classmethod
    def of(cls, low, high):
        """The lattice of boxes from low to high, (k, 3) each."""
        least, most = low.min(axis=0), high.max(axis=0)
        size = np.maximum(most - least, 1e-9 * (most - least).max() + 1e-300)
        side = np.maximum(np.median(high - low, axis=0), size / 256) / CELLS
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
        i, j, k = np.stack((i, j, k)) + begin[box].T
        cell = (i * shape[1] + j) * shape[2] + k
        order = np.argsort(cell, kind="stable")
        first = np.append(0, np.cumsum(np.bincount(cell, minlength=int(shape.prod()))))
        return cls(least, step, shape, first, box[order])

    def cells(self, points):
        """The cell that each point is in, -1 for none: (n,) int."""
        cell = np.empty(len(points), dtype=np.intp)
        for start in range(0, len(points), CHUNK):
            some = points[start : start + CHUNK]
            within, at = np.ones(len(some), dtype=bool), np.zeros(len(some), dtype=np.intp)
            for axis, count in enumerate(self.shape.tolist()):
                place = (some[:, axis] - self.low[axis]) / self.step[axis]
                within &= (place >= 0) & (place <= count)
                place = np.minimum(np.maximum(place, 0.0, out=place), count - 1, out=place)
                at = at * count + place.astype(np.intp)
            cell[start : start + CHUNK] = np.where(within, at, -1)
        return cell

    def counts(self, cell):
        """In how many boxes a point may lie that is in a cell: (n,) int."""
        return np.where(cell >= 0, self.first[cell + 1] - self.first[cell], 0)

    def pairs(self, cell):
        """Pairs of points in cells, and boxes that these may lie in: two (p,) int arrays, points rising."""
        within = np.flatnonzero(cell >= 0)
        begin = self.first[cell[within]]
        counts = self.first[cell[within] + 1] - begin
        point = np.repeat(within, counts)
        shift = np.arange(len(point)) - np.repeat(np.cumsum(counts) - counts, counts)
        return point, self.boxes[np.repeat(begin, counts) + shift]


def portions(counts, most):
    """Slices of items of so many pairs each that a slice has no more than so many items and pairs, or one item."""
    total, start = np.cumsum(np.maximum(counts, 1)), 0
    while start < len(counts):
        done = total[start - 1] if start else 0
        stop = max(int(np.searchsorted(total, done + most, side="right")), start + 1)
        yield slice(start, stop)
        start = stop

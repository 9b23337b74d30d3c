# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A lattice over a part of the plane in which a distance is asked for: which of many edges may be nearest in each cell.

Only near where the distance is a certain one it is wanted at all, as a set ends there: cells of nothing but less, or of
nothing but more, need no edges. Cells are halved from coarse to fine, each with what is left of the edges.
"""

import numpy as np

from ...declared.frozen import individual
from ..motion.hash import portions

CELLS = 4  # along a side for the root of each edge
COARSE, FINE = 2, 8  # halvings of the longer side: of the cells that are begun with, and at most
MOST = 1 << 21  # pairs of cells and edges: cells with more are not halved
ROOM = 1.001  # of a cell's diagonal, for rounding
CHUNK = 1 << 18  # pairs of places and edges at a time
FIRST = 8  # edges that are asked at first, the likeliest


@individual
class Nearby:
    """Cells, and the edges that may be nearest somewhere in each.

    Parameters
    ----------
    low : (2,) float array
    step : float
    shape : (2,) int array
    sure : (cells,) float array
        0 where all places are nearer than it matters, infinite where all are farther, NaN where edges are asked.
    first : (cells + 1,) int array
    edges : (p,) int array
        Those of cell i are edges[first[i]:first[i + 1]], the nearest to its middle first.
    enough : float
        A distance of less is as good as any.

    Examples
    --------
    How far places are from two points, where it is about 1:

    >>> ends = np.array([(0.0, 0.0), (4.0, 0.0)])
    >>> def far(edge, places):
    ...     return np.hypot(*(places - ends[edge]).T)
    >>> near = Nearby.of(far, 2, np.array([-2.0, -2.0]), np.array([6.0, 2.0]), level=1.0, room=0.1)
    >>> near.least(far, np.array([(1.05, 0.0), (4.0, 0.1), (2.0, 1.9)])).tolist()
    [1.05, 0.1, inf]
    """

    low: np.ndarray
    step: float
    shape: np.ndarray
    sure: np.ndarray
    first: np.ndarray
    edges: np.ndarray
    enough: float

    @classmethod
    def of(cls, far, count, low, high, level, room, inside=None):
        """The lattice of so many edges from low to high, (2,) each, for distances about a level.

        Parameters
        ----------
        far : callable
            From edges (k,) and places (k, 2) to how far these are apart: (k,). It may be negative where places would
            have to be moved so far to come apart at all.
        count : int
        low, high : (2,) float array
        level, room : float
            Distances that are less or more than this one by more than so much are not wanted.
        inside : callable, optional
            From places (k, 2) to numbers (k,) that are negative where places are so near anyway, by how far they are
            from others at least.
        """
        halvings = int(np.clip(np.ceil(np.log2(CELLS * np.sqrt(count))), COARSE + 1, FINE))
        size, factor = high - low, 2 ** (halvings - COARSE)
        step = float(size.max()) / 2**halvings
        coarse = np.maximum(np.ceil(size / (step * factor)), 1).astype(int)
        sure = np.full(coarse * factor, np.nan)
        i, j = (axis.ravel() for axis in np.meshgrid(*map(np.arange, coarse), indexing="ij"))
        cell, edge = np.repeat(np.arange(len(i)), count), np.tile(np.arange(count), len(i))
        while True:
            half = ROOM * step * factor / np.sqrt(2)
            middles = low + (np.stack((i, j), axis=1) + 0.5) * step * factor
            found = np.concatenate(
                [far(edge[some], middles[cell[some]]) for some in portions(np.ones(len(cell), dtype=int), CHUNK)]
            )
            least = np.minimum.reduceat(found, np.flatnonzero(np.append(True, np.diff(cell) > 0)))
            beyond, within = least - half > level + room, least + half <= level - room
            within |= inside is not None and inside(middles) <= -half
            blocks = sure.reshape(sure.shape[0] // factor, factor, -1, factor)
            blocks[i[beyond], :, j[beyond], :] = np.inf
            blocks[i[within], :, j[within], :] = 0.0
            left = ~(beyond | within)
            kept = left[cell] & (found <= least[cell] + 2 * half)
            cell, edge, found, i, j = (np.cumsum(left) - 1)[cell[kept]], edge[kept], found[kept], i[left], j[left]
            if factor == 1 or not len(i) or 4 * len(cell) > MOST:
                break
            factor //= 2
            i, j = (np.add.outer(2 * side, part).ravel() for side, part in ((i, (0, 0, 1, 1)), (j, (0, 1, 0, 1))))
            cell = np.add.outer(4 * cell, np.arange(4)).ravel()
            order = np.argsort(cell, kind="stable")
            cell, edge = cell[order], np.repeat(edge, 4)[order]
        sure = sure[::factor, ::factor]
        cell = (i * sure.shape[1] + j)[cell]
        order = np.lexsort((found, cell))
        first = np.append(0, np.cumsum(np.bincount(cell, minlength=sure.size)))
        return cls(low, step * factor, np.array(sure.shape), sure.ravel(), first, edge[order], max(level - room, 0.0))

    def least(self, far, places):
        """How far places (n, 2) are from the nearest edge: (n,).

        Where it is less than is wanted it may be anything that is, and where it is more it may be infinite.
        """
        at = (places - self.low) / self.step
        found = np.where(((at >= 0) & (at < self.shape)).all(axis=1), np.nan, np.inf)
        i, j = np.clip(at, 0, self.shape - 1).astype(np.intp).T
        cell = i * int(self.shape[1]) + j
        found = np.where(np.isnan(found), self.sure[cell], found)
        asked = np.flatnonzero(np.isnan(found))
        found[asked] = np.inf
        begun, count = self.first[cell[asked]], FIRST
        while len(asked):
            counts = np.minimum(self.first[cell[asked] + 1] - begun, count)
            for some in portions(counts, CHUNK):
                chosen, number = asked[some], counts[some]
                start = np.cumsum(number) - number
                edge = self.edges[np.arange(number.sum()) + np.repeat(begun[some] - start, number)]
                apart = far(edge, places[np.repeat(chosen, number)])
                found[chosen] = np.minimum(found[chosen], np.minimum.reduceat(apart, start))
            begun += counts
            left = (begun < self.first[cell[asked] + 1]) & (found[asked] > self.enough)
            asked, begun, count = asked[left], begun[left], 2 * count
        return found

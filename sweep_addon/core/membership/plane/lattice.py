# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A lattice over loops of lines and arcs: which may be nearest in each of its cells, and the side of other cells."""

import numpy as np

from ...declared.frozen import individual
from ...meshes.components import components
from ...vectors import norms
from ..motion.hash import portions

CELLS = 4  # of the lattice for each edge, along a side as the root of them
MOST = 512  # cells along a side
ROOM = 1.001  # of a cell's diagonal, for rounding
CHUNK = 1 << 18  # pairs of cells and edges at a time


@individual
class Lattice:
    """Cells over a region: the edges that may be nearest somewhere in each.

    Parameters
    ----------
    low, step : (2,) float array
    shape : (2,) int array
    clear : (cells,) float array
        Of cells that no edge comes near, how far they are from the boundary at least, negative inside; 0 of others.
    first : (cells + 1,) int array
    edges : (p,) int array
        Those of cell i are edges[first[i]:first[i + 1]].
    """

    low: np.ndarray
    step: np.ndarray
    shape: np.ndarray
    clear: np.ndarray
    first: np.ndarray
    edges: np.ndarray


def lattice(loops):
    """The lattice of some loops."""
    low, high = loops.box
    size = high - low
    side = min(int(np.ceil(CELLS * np.sqrt(len(loops.start)))) + 4, MOST)
    shape = np.maximum(np.ceil(side * size / size.max()).astype(int), 1)
    step = size / shape
    half = ROOM * float(np.hypot(*step)) / 2
    i, j = (axis.ravel() for axis in np.meshgrid(np.arange(shape[0]), np.arange(shape[1]), indexing="ij"))
    middles = low + (np.stack((i, j), axis=1) + 0.5) * step
    cell, edge, far = within_reach(loops, low, step, shape, middles, 3 * half)
    least = np.full(len(middles), np.inf)
    np.minimum.at(least, cell, far)
    near = least <= half
    kept = near[cell] & (far <= least[cell] + 2 * half)
    order = np.argsort(cell[kept], kind="stable")
    first = np.append(0, np.cumsum(np.bincount(cell[kept], minlength=len(middles))))
    clear = np.where(near, 0.0, np.minimum(least, 3 * half) - half)
    clear[~near] *= sides(loops, middles, ~near, shape)
    return Lattice(low, step, shape, clear, first, edge[kept][order])


def within_reach(loops, low, step, shape, middles, reach):
    """Cells and edges that come so near to the cells' middles, and how near: three (p,)."""
    begin, end = (np.clip(((side - low) / step).astype(int), 0, shape - 1)
                  for side in (loops.boxes()[0] - reach, loops.boxes()[1] + reach))  # fmt: skip
    spans = end - begin + 1
    found = []
    for some in portions(spans.prod(axis=1), CHUNK):
        count = spans[some].prod(axis=1)
        edge = np.repeat(np.arange(len(spans))[some], count)
        within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
        i, j = np.divmod(within, spans[edge, 1])
        cell = (begin[edge, 0] + i) * shape[1] + begin[edge, 1] + j
        across, beside = loops.distances(edge, middles[cell])
        far = np.where(beside, np.abs(across), np.inf)
        for ends in (loops.start, loops.end):
            far = np.minimum(far, norms(middles[cell] - ends[edge]))
        kept = far <= reach
        found.append((cell[kept], edge[kept], far[kept]))
    return tuple(np.concatenate(part) for part in zip(*found, strict=True))


def sides(loops, middles, clear, shape):
    """On which side of the loops clear cells are: 1 out, -1 in; no edge runs between such neighbours."""
    number = np.arange(len(middles)).reshape(shape)
    pairs = [
        np.stack(pair, axis=-1).reshape(-1, 2) for pair in ((number[1:], number[:-1]), (number[:, 1:], number[:, :-1]))
    ]
    pairs = np.concatenate(pairs)
    part = components(len(middles), pairs[clear[pairs].all(axis=1)])[clear]
    firsts, which = np.unique(part, return_inverse=True)
    return np.where(loops.exact(middles[firsts])[0] < 0, -1.0, 1.0)[which.ravel()]

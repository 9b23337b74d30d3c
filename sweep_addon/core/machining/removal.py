# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Removing material: the height that all moves of a tool leave at the places of a lattice, and which move cut last."""

import numpy as np

from ..progress import unheard, within
from .cells import shares
from .lattice import SIDE
from .moves import Moves, counted, left, near_tiles

CHUNK = 8  # moves of a tile that are looked at at once: after that the tile may be as low as all others can make it
WIDE = 2**15  # places of tiles times moves that are looked at at once, so that they stay in the processor's cache


def removed(tool, starts, ends, lattice, heights, lowered_by, rows=None, progress=None):
    """Lower heights to what the moves of a tool leave: exactly, at each place, and in any order of moves the same.

    Parameters
    ----------
    tool : a kind of Tool
    starts, ends : (m, 3) float arrays
        The moves, in metres.
    lattice : Lattice
    heights : (n, k) float array
        At the places of the lattice.
    lowered_by : (n, k) int array
        The number of the move that has cut each place last, or -1.
    rows : (m,) int array, optional
        The numbers of the moves; by default from 0.
    progress : callable, optional
        Is told which part is done, from 0 to 1; what it raises ends the work.

    Returns
    -------
    heights, lowered_by : arrays of the same shapes

    Examples
    --------
    >>> from sweep_addon.core.machining.lattice import Lattice
    >>> from sweep_addon.core.machining.tools import FlatEnd
    >>> lattice = Lattice.across((0.0, 0.0), (0.03, 0.01), 0.01)
    >>> whole = np.zeros(lattice.size), np.full(lattice.size, -1)
    >>> slot = np.array([[0.01, 0.0, -0.002]]), np.array([[0.02, 0.0, -0.003]])
    >>> removed(FlatEnd(diameter=0.01), *slot, lattice, *whole)[0][:, 0].tolist()
    [0.0, -0.0025, -0.003, 0.0]
    """
    moves = Moves.between(starts, ends)
    tiled, by = lattice.in_tiles(heights, -np.inf), lattice.in_tiles(lowered_by, -1)
    tiled, by = tiled.reshape(len(tiled), -1), by.reshape(len(by), -1)
    own = np.arange(len(starts)) if rows is None else rows
    parts = shares(counted(tool, moves, lattice))
    for number, some in enumerate(parts):
        few = moves.of(some)
        pairs = near_tiles(tool, few, lattice, tiled.max(axis=1))
        told = within(progress or unheard, number / len(parts), (number + 1) / len(parts))
        lower_tiles(tool, few, lattice, tiled, by, pairs, own[some], told)
    return tuple(lattice.from_tiles(part.reshape(-1, SIDE, SIDE)) for part in (tiled, by))


def lower_tiles(tool, moves, lattice, tiled, by, pairs, own, progress):
    """Lower all tiles by some of their moves, then those by more that these might still lower, and so on."""
    tiles, rows, bounds = pairs
    starts = np.flatnonzero(np.diff(tiles, prepend=-1))
    ends = np.append(starts[1:], len(tiles))
    total = max(1, len(tiles))
    while len(starts):
        size = max(1, WIDE // (CHUNK * SIDE**2))
        for first in range(0, len(starts), size):
            some = slice(first, first + size)
            lower(tool, moves, lattice, tiled, by, tiles[starts[some]], starts[some], ends[some], rows, own)
        starts = starts + CHUNK
        going = starts < ends
        starts, ends = starts[going], ends[going]
        going = bounds[starts] < tiled[tiles[starts]].max(axis=1)
        starts, ends = starts[going], ends[going]
        progress(1 - (ends - starts).sum() / total)


def lower(tool, moves, lattice, tiled, by, tiles, starts, ends, rows, own):
    """Lower some tiles by the next few moves of each."""
    x, y = lattice.places(tiles)
    here = np.minimum(starts[:, None] + np.arange(CHUNK), ends[:, None] - 1)  # the last again where there are fewer
    chosen = rows[here]
    height = left(tool, moves.of(chosen[:, :, None]), x[:, None], y[:, None])
    best = height.argmin(axis=1)
    height = np.take_along_axis(height, best[:, None], axis=1)[:, 0]
    lowered = height < tiled[tiles]
    tiled[tiles] = np.where(lowered, height, tiled[tiles])
    by[tiles] = np.where(lowered, own[np.take_along_axis(chosen, best, axis=1)], by[tiles])

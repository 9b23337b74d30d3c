# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which moves cut where they must not: below a height that the part has, or fast into stock that is still there."""

import numpy as np

from ..progress import unheard, within
from .cells import shares
from .lattice import SIDE
from .moves import Moves, counted, left, near_tiles

CHUNK = 8  # moves of a tile that are looked at at once
WIDE = 2**15  # places of tiles times moves that are looked at at once
TOUCHING = 1e-5  # metres: a rapid move along a wall, or to where the last move has cut, does not cut


class Thinner:
    """A tool made thinner all round, so that it cuts nowhere where the whole tool only touches a wall."""

    def __init__(self, tool, by):
        self.tool, self.by, self.radius = tool, by, tool.radius - by

    def reach(self, across):
        return np.sqrt(np.maximum(self.radius**2 - across**2, 0.0))

    def rise(self, distance):
        return self.tool.rise(distance + self.by)

    def ahead(self, across, slope):
        return self.tool.ahead(across, slope)


def part_cuts(machined, limits, desired, progress=unheard):
    """How far each piece of a move cuts into what must be left, where that is still there when it comes: (m,) array.

    Parameters
    ----------
    machined : Machined
    limits : (n, m) float array
        Heights that must be left at the places of the lattice, -inf where anything may be cut.
    desired : (n, m) float array
        Heights of the part, from which it counts how deep a move goes that passes a limit.
    progress : callable
        Is told which part is done, from 0 to 1; what it raises ends the work.
    """
    depths = np.zeros(len(machined.starts))
    tiled, whole = (machined.lattice.in_tiles(each, -np.inf).reshape(-1, SIDE**2) for each in (limits, desired))

    def look(tiles, pieces, before, height, x, y):
        limit = tiled[tiles][:, None]
        new = (height < limit) & ((before >= limit) | (before - height > TOUCHING))
        into = np.where(new, whole[tiles][:, None] - height, 0.0).max(axis=2)
        np.maximum.at(depths, pieces, into)

    in_order(machined, tiled.max(axis=1), look, progress)
    return depths


def rapid_cuts(machined, progress=unheard):
    """How far each rapid piece cuts into what is there when it comes: (m,) array, 0 where it does not."""
    depths = np.zeros(len(machined.starts))
    rapid = machined.path.rapid[machined.moves]
    top = machined.high[2] - TOUCHING
    low = rapid & (np.minimum(machined.starts[:, 2], machined.ends[:, 2]) < top)
    if not low.any():
        return depths
    ceiling = np.full(machined.lattice.tile_count, -np.inf)
    for tiles, _ in pairs(machined, low, np.full(len(ceiling), top)):
        ceiling[tiles] = machined.high[2]

    def look(tiles, pieces, before, height, x, y):
        fast = low[pieces].any(axis=1)
        thin = heights_left(machined, pieces[fast], x[fast], y[fast], TOUCHING)
        into = np.where(low[pieces[fast]], (before[fast] - thin).max(axis=2), 0.0)
        np.maximum.at(depths, pieces[fast], np.where(into > TOUCHING, into, 0.0))

    in_order(machined, ceiling, look, progress)
    return depths


def in_order(machined, ceiling, look, progress):
    """Cut tiles by the pieces of moves one after the other, and look at each.

    Parameters
    ----------
    machined : Machined
    ceiling : (t,) array
        The height of each tile; pieces that stay above are left out, and so are tiles without any.
    look : callable
        Is given the tiles (k,), the pieces (k, c), and (k, c, places) the heights before each and what each leaves; and
        the coordinates of the places (k, places).
    progress : callable
    """
    heights = np.full((machined.lattice.tile_count, SIDE**2), machined.high[2])
    count, done = len(machined.starts), 0.0
    for tiles, pieces in pairs(machined, np.ones(count, dtype=bool), ceiling):
        share = (int(pieces.max(initial=-1)) + 1) / count
        some_in_order(machined, tiles, pieces, heights, look, within(progress, done, max(done, share)))
        done = max(done, share)


def some_in_order(machined, tiles, pieces, heights, look, progress):
    """Those of `in_order` of some pairs of tiles and pieces, which lower the heights of the tiles."""
    starts = np.flatnonzero(np.diff(tiles, prepend=-1))
    ends = np.append(starts[1:], len(tiles))
    numbers = tiles[starts]
    which, size = np.arange(len(starts)), max(1, WIDE // (CHUNK * SIDE**2))
    while len(which):
        for first in range(0, len(which), size):
            some = which[first : first + size]
            here = np.minimum(starts[some][:, None] + np.arange(CHUNK), ends[some][:, None] - 1)
            x, y = machined.lattice.places(numbers[some])
            height = heights_left(machined, pieces[here], x, y)
            now = heights[numbers[some]][:, None]
            after = np.minimum.accumulate(np.minimum(height, now), axis=1)
            before = np.concatenate((now, after[:, :-1]), axis=1)
            look(numbers[some], pieces[here], before, height, x, y)
            heights[numbers[some]] = after[:, -1]
        starts = starts + CHUNK
        which = which[starts[which] < ends[which]]
        progress(1 - (ends[which] - starts[which]).sum() / len(tiles))


def pairs(machined, wanted, ceiling):
    """Tiles and pieces of moves that come near them, by tiles and in each in the order of the program.

    There may be more than fit into memory: so they come in several pairs of arrays, of later and later pieces.
    """
    counts = np.zeros(len(machined.starts), dtype=np.int64)
    for tool, rows in machined.tools:
        rows = rows[wanted[rows]]
        counts[rows] = counted(tool, Moves.between(machined.starts[rows], machined.ends[rows]), machined.lattice)
    for some in shares(counts):
        found = []
        for tool, rows in machined.tools:
            rows = np.intersect1d(rows, some, assume_unique=True)
            moves = Moves.between(machined.starts[rows], machined.ends[rows])
            tiles, row, _ = near_tiles(tool, moves, machined.lattice, ceiling)
            found.append((tiles, rows[row]))
        tiles, pieces = (np.concatenate(part) for part in zip(*found, strict=True))
        order = np.lexsort((pieces, tiles))
        yield tiles[order], pieces[order]


def heights_left(machined, pieces, x, y, thinner=0.0):
    """What pieces of moves leave in their tiles, each by its own tool, or by that made thinner: (k, c, places)."""
    found = np.full((*pieces.shape, SIDE**2), np.inf)
    for tool, rows in machined.tools:
        own = np.ones(pieces.shape, dtype=bool) if len(machined.tools) == 1 else np.isin(pieces, rows)
        tile, number = np.nonzero(own)
        if len(tile):
            cutter = Thinner(tool, min(thinner, tool.radius / 2)) if thinner else tool
            moves = Moves.between(machined.starts[pieces[own]], machined.ends[pieces[own]])
            found[tile, number] = left(cutter, moves.of(np.arange(len(tile))[:, None]), x[tile], y[tile])
    return found

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Straight moves of a tool, what each leaves above a place, and which tiles each comes near.

Source
------
Chung, Park, Shin, Choi: Modeling the surface swept by a generalized cutter for NC verification, CAD 30(8), 1998: the
envelope of a tool of revolution in a straight move in closed form; here as the least of a convex function on the move.
"""

from dataclasses import dataclass

import numpy as np

from .cells import cells
from .lattice import SIDE


@dataclass(frozen=True)
class Moves:
    """Moves as rows: where each begins, its direction seen from above, how long it is so, and how steep.

    An upright move is one of no length at its lower end.
    """

    x: np.ndarray
    y: np.ndarray
    z: np.ndarray
    dx: np.ndarray
    dy: np.ndarray
    length: np.ndarray
    slope: np.ndarray

    @classmethod
    def between(cls, starts, ends):
        """Moves from places to others, (m, 3) each in metres."""
        way = ends - starts
        length = np.hypot(way[:, 0], way[:, 1])
        upright = length <= 1e-12 * np.maximum(1e-3, np.abs(ends).max(axis=1, initial=0.0))
        length = np.where(upright, 0.0, length)
        safe = np.where(upright, 1.0, length)
        z = np.where(upright, np.minimum(starts[:, 2], ends[:, 2]), starts[:, 2])
        dx, dy, slope = (np.where(upright, fixed, way[:, i] / safe) for i, fixed in enumerate((1.0, 0.0, 0.0)))
        return cls(starts[:, 0], starts[:, 1], z, dx, dy, length, slope)

    def of(self, rows):
        return Moves(*(getattr(self, name)[rows] for name in self.__match_args__))

    def foot(self, x, y):
        """Where along each move the foot of a place is, and how far that is across the move; rows broadcast."""
        x, y = x - self.x, y - self.y
        return x * self.dx + y * self.dy, np.abs(y * self.dx - x * self.dy)

    @property
    def low(self):
        """The height of the lower end of each."""
        return self.z + np.minimum(0.0, self.slope * self.length)


def left(tool, moves, x, y):
    """The height that each move of a tool leaves at most at places: infinite where it does not come.

    Parameters
    ----------
    tool : a kind of Tool
    moves : Moves
    x, y : arrays that broadcast with the moves

    Returns
    -------
    array
        In metres.
    """
    foot, across = moves.foot(x, y)
    reach = tool.reach(across)
    first, last = np.maximum(foot - reach, 0.0), np.minimum(foot + reach, moves.length)
    at = np.clip(foot + tool.ahead(across, moves.slope), first, last)
    height = moves.z + moves.slope * at + tool.rise(np.sqrt(across**2 + (at - foot) ** 2))
    return np.where((first <= last) & (across <= tool.radius), height, np.inf)


def near_tiles(tool, moves, lattice, ceiling):
    """Which tiles each move comes near, and how low at most it can leave them.

    Parameters
    ----------
    tool : a kind of Tool
    moves : Moves
    lattice : Lattice
    ceiling : (t,) array
        The height of each tile; moves that stay above are left out.

    Returns
    -------
    tiles, rows : (p,) int arrays
        The pairs, by tiles and in each by the bound, so that what cuts deepest comes first.
    bounds : (p,) array
    """
    first_x, last_x, first_y, last_y = boxes(tool, moves, lattice)
    row, x, y = cells(np.maximum(last_x - first_x + 1, 0), np.maximum(last_y - first_y + 1, 0))
    tile = (first_x[row] + x) * lattice.tiles[1] + first_y[row] + y
    bound = lowest(tool, moves.of(row), lattice, tile)
    kept = np.flatnonzero(bound < ceiling[tile])
    kept = kept[np.lexsort((bound[kept], tile[kept]))]
    return tile[kept], row[kept], bound[kept]


def counted(tool, moves, lattice):
    """How many tiles are looked at for each move: (m,) int array."""
    first_x, last_x, first_y, last_y = boxes(tool, moves, lattice)
    return np.maximum(last_x - first_x + 1, 0) * np.maximum(last_y - first_y + 1, 0)


def boxes(tool, moves, lattice):
    """The first and last tile along each axis whose places each move may reach: four (m,) int arrays."""
    spans = []
    for axis, (at, by) in enumerate(((moves.x, moves.dx), (moves.y, moves.dy))):
        ends = at + by * moves.length
        pitch = lattice.step[axis] * SIDE
        low = np.floor((np.minimum(at, ends) - tool.radius - lattice.low[axis]) / pitch - 1e-9)
        high = np.floor((np.maximum(at, ends) + tool.radius - lattice.low[axis]) / pitch + 1e-9)
        count = lattice.tiles[axis]
        outside = (high < 0) | (low >= count)
        spans.append((np.clip(low, 0, count).astype(np.int64), np.where(outside, -1, np.clip(high, 0, count - 1))))
    (left_, right), (below, above) = spans
    return left_, right.astype(np.int64), below, above.astype(np.int64)


def lowest(tool, moves, lattice, tiles):
    """A height below which no move leaves a place of its tile: (p,); infinite where it does not come near."""
    x, y = lattice.corners(tiles)
    half_x, half_y = ((SIDE - 1) / 2 * step for step in lattice.step)
    around = np.hypot(half_x, half_y)
    foot, across = moves.foot(x + half_x, y + half_y)
    reach = tool.radius + around
    first, last = np.maximum(foot - reach, 0.0), np.minimum(foot + reach, moves.length)
    low = moves.z + np.minimum(moves.slope * first, moves.slope * last)
    beside = np.hypot(across, np.maximum(np.maximum(-foot, foot - moves.length), 0.0))
    rise = tool.rise(np.minimum(np.maximum(beside - around, 0.0), tool.radius))
    return np.where((beside <= reach) & (first <= last), low + rise, np.inf)

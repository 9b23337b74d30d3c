# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A lattice of places in the plane, at which heights are known, in tiles of some rows and columns each."""

from dataclasses import dataclass

import numpy as np

SIDE = 8  # places of a tile along each axis


@dataclass(frozen=True)
class Lattice:
    """Places at equal distances.

    Parameters
    ----------
    low : tuple of 2 floats
        The first place, in metres.
    step : tuple of 2 floats
        From place to place.
    size : tuple of 2 ints
        Places along x and along y.
    """

    low: tuple
    step: tuple
    size: tuple

    @classmethod
    def across(cls, low, high, cell):
        """Places from corner to corner of a rectangle, as far apart as a cell or a little less.

        >>> Lattice.across((0.0, 0.0), (1.0, 0.5), 0.3).size
        (5, 3)
        """
        sides = [b - a for a, b in zip(low, high, strict=True)]
        counts = [max(1, int(np.ceil(side / cell - 1e-9))) for side in sides]
        step = tuple(side / count for side, count in zip(sides, counts, strict=True))
        return cls(tuple(low), step, tuple(count + 1 for count in counts))

    def along(self, axis):
        """The coordinates of the places along an axis: (n,)."""
        return self.low[axis] + self.step[axis] * np.arange(self.size[axis])

    @property
    def tiles(self):
        """How many tiles there are along each axis; the last may reach beyond the places."""
        return tuple(-(-size // SIDE) for size in self.size)

    @property
    def tile_count(self):
        return self.tiles[0] * self.tiles[1]

    def in_tiles(self, values, beyond):
        """Values (n, m) at the places as those of each tile, (t, SIDE, SIDE), with another value beyond."""
        nx, ny = self.tiles
        padded = np.full((nx * SIDE, ny * SIDE), beyond, dtype=np.asarray(values).dtype)
        padded[: self.size[0], : self.size[1]] = values
        return padded.reshape(nx, SIDE, ny, SIDE).swapaxes(1, 2).reshape(-1, SIDE, SIDE).copy()

    def from_tiles(self, values):
        """Values of each tile as those at the places: (n, m)."""
        nx, ny = self.tiles
        padded = values.reshape(nx, ny, SIDE, SIDE).swapaxes(1, 2).reshape(nx * SIDE, ny * SIDE)
        return padded[: self.size[0], : self.size[1]].copy()

    def corners(self, tiles):
        """The first place of some tiles, by their numbers: two (k,) arrays."""
        nx, ny = np.divmod(tiles, self.tiles[1])
        return self.low[0] + self.step[0] * SIDE * nx, self.low[1] + self.step[1] * SIDE * ny

    def places(self, tiles):
        """The coordinates of all places of some tiles, by their numbers: two (k, SIDE * SIDE) arrays."""
        x, y = self.corners(tiles)
        inside = np.arange(SIDE)
        along_x, along_y = (self.step[0] * inside).repeat(SIDE), np.tile(self.step[1] * inside, SIDE)
        return x[:, None] + along_x, y[:, None] + along_y

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which heights a desired part has at each place, as near as an allowance: on a wall those of its foot and its top."""

from dataclasses import dataclass

import numpy as np

from .part import seen_from_above, top_of

STEEP = 8  # allowances that the part rises from one side of a place to the other, from which on that is a wall
ASIDE = ((-1, -1), (-1, 1), (1, -1), (1, 1))  # so that each and the last but that are opposite


@dataclass(frozen=True)
class Desired:
    """Heights of a part within a block at the places of a lattice, (n, m) arrays in metres.

    Attributes
    ----------
    height : array
        At the place itself; of a wall through it the top.
    lowest, highest : arrays
        Within the allowance to the side.
    wall : bool array
        Where those are so far apart, or so uneven, that no height of the place itself can be named.
    lower : array
        Which part of the surroundings of a place is at the foot of a wall, if there is one; else 1.
    """

    height: np.ndarray
    lowest: np.ndarray
    highest: np.ndarray
    wall: np.ndarray
    lower: np.ndarray

    @classmethod
    def of(cls, mesh, machined, allowance):
        """Those of a mesh within the block of machined stock."""
        places, seen = seen_from_above(mesh)
        height, *around = (
            np.clip(
                top_of(places, seen, machined.lattice, np.multiply(side, allowance)), machined.low[2], machined.high[2]
            )
            for side in ((0, 0), *ASIDE)
        )
        around = np.stack(around)
        lowest, highest = np.minimum(around.min(axis=0), height), np.maximum(around.max(axis=0), height)
        # On a slope a place is halfway between those on opposite sides, however steep it is; on a step it is not.
        uneven = np.abs((around + around[::-1]) / 2 - height).max(axis=0) > allowance
        foot = (around <= (lowest + highest) / 2).mean(axis=0)
        wall = uneven | (highest - lowest > STEEP * allowance)
        return cls(height, lowest, highest, wall, np.where(uneven, foot, 1.0))

    def nearest(self, heights):
        """The heights of the part, on walls those nearest to what is given: (n, m)."""
        return np.where(self.wall, np.clip(heights, self.lowest, self.highest), self.height)

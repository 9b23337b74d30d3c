# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sweep of a sheet one of whose ends is open: a surface, which the rim leaves, and the sheet at the other end."""

import numpy as np

from ..labels import ON, OUT
from .moving_sheet import MovingSheet


class MovingRim(MovingSheet):
    """What the rim of a sheet visits, and the sheet where it stands.

    Parameters
    ----------
    sheet : Sided
    motion : Motion
    stands : tuple of two bool
        Whether it does at the start and at the end.
    change : Change, optional
    """

    is_sheet = True

    def __init__(self, sheet, motion, stands, change=None):
        super().__init__(sheet, motion, False, change)
        self.ends = [end for end, there in zip((0.0, self.total), stands, strict=True) if there]

    def from_solid(self, places, s, tolerance):
        """How much farther than a tolerance places (n, 3), as seen by the rigid motion, are from the rim, or less."""
        if not self.change:
            return self.solid.from_rim(places) - tolerance
        own = self.change.back(places, s)
        value = own.least * self.solid.from_rim(own.places)
        near = np.flatnonzero((value <= tolerance) & (own.away == 0))
        maps = self.change.maps(own.places[near], s if np.ndim(s) == 0 else s[near])
        value[near] = self.solid.from_rim(own.places[near], maps)
        return own.away + value - tolerance

    def labels(self, points, tolerance):
        """ON or OUT for points (n, 3): (n,) int8."""
        least = self.least(points, tolerance, 1.0, 0.0)
        for end in self.ends:
            there = self.at_times(points - self.middle, np.full(len(points), end), tolerance)
            least = np.minimum(least, np.abs(there.value) - tolerance)
        return np.where(least <= 0, ON, OUT).astype(np.int8)

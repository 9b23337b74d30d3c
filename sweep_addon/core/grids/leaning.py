# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The chart of a solid whose rings lean: each of their vertices has a place of its own along the axis."""

from functools import cached_property

import numpy as np

from ..declared.digest import checksum
from ..declared.frozen import individual
from .chart import Chart, Texture


@individual
class Leaning(Chart):
    """Where on such a solid its vertices and corners lie.

    Parameters
    ----------
    leaning : tuple of two int
        How many rings lean at the start and at the end, k in all, of which ``u`` and ``s`` hold middle values.
    heights, parameters : (m, k) float array
        The arc length of each of their columns in metres, and the trajectory's parameter there.
    """

    leaning: tuple = (0, 0)
    heights: np.ndarray = None
    parameters: np.ndarray = None

    @cached_property
    def keys(self):
        """The texts of a chart, which here hang on all heights, and so have no parts."""
        texture, along, across = super().keys
        own = checksum(self.heights, self.parameters)
        return texture and texture + own, along and along.replace(",", "") + own, across

    @property
    def extent(self):
        """From which arc length the texture goes to which: two floats."""
        both = (self.s, self.heights)
        return min(part.min() for part in both), max(part.max() for part in both)

    def uv(self, dtype=np.float64, empty=np.empty):
        """Texture coordinates of each corner, along the trajectory and round the contour: (c, 2), or None for none."""
        uv = super().uv(dtype, empty)
        if uv is None:
            return None
        heights = self.heights
        if self.texture is Texture.UNIT:
            low, high = self.extent
            heights = (heights - low) / (high - low)
        columns, bands = self.grid.strips[0], self.rings - 1  # an open outline ends with a column that no face follows
        sides = uv[: len(columns) * bands * 4].reshape(len(columns), bands, 4, 2)
        heights = heights.astype(dtype)
        here, ahead = heights[columns], heights[self.grid.following[columns]]
        for own, which in standing(self.leaning, self.rings):
            first, last, _ = which.indices(self.rings)
            for corner, line, ring in ((0, here, 0), (1, ahead, 0), (2, ahead, 1), (3, here, 1)):
                start = max(first, ring)
                end = max(min(last, bands + ring), start)
                sides[:, start - ring : end - ring, corner, 0] = line[:, own][:, start - first : end - first]
        return uv

    def along(self, dtype=np.float64, but=(), rooms=None):
        """Values at each vertex that depend on its place along the axis: u and arc_length."""
        values = super().along(dtype, but, rooms)
        own = {"u": self.parameters, "arc_length": self.heights}
        for name in values:
            for theirs, which in standing(self.leaning, self.rings):
                values[name].reshape(-1, self.rings)[:, which] = own[name][:, theirs]
        return values


def standing(leaning, rings):
    """Which rings lean at the start and which at the end: pairs of slices, of those that lean and of all."""
    before, after = leaning
    return (slice(before), slice(before)), (slice(before, before + after), slice(rings - after, rings))

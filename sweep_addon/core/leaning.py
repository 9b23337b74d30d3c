# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The chart of a solid whose rings lean: each of their vertices has a place of its own along the axis."""

from math import prod

import numpy as np

from .chart import Chart, Texture
from .digest import checksum
from .frozen import individual


@individual
class Leaning(Chart):
    """Where on such a solid its vertices and corners lie.

    Parameters
    ----------
    places : (m, n) float array
        The arc length of each column at each ring, in metres, of which ``s`` holds the means.
    parameters : (m, n) float array
        The trajectory's parameter there.
    """

    places: np.ndarray = None
    parameters: np.ndarray = None

    @property
    def keys(self):
        """The texts of a chart, which here hang on all places."""
        texture, along, across = super().keys
        own = checksum(self.places, self.parameters)
        return texture and texture + own, along and along + own, across

    def uv(self, dtype=np.float64, empty=np.empty):
        """Texture coordinates of each corner, along the trajectory and round the contour: (c, 2), or None for none."""
        if self.texture is Texture.NONE:
            return None
        _, _, left, right = self.strip()
        along = self.places
        if self.texture is Texture.UNIT:
            along = (along - along.min()) / np.ptp(along)
        columns = self.grid.strips[0]  # those that a face follows: an open outline ends with one that none does
        along, ahead = along[columns], along[self.grid.following[columns]]
        shape = len(along), self.rings - 1, 4, 2
        caps = np.concatenate([np.empty(0, dtype), *(cap.ravel() for cap in self.cap_uv(dtype))])
        uv = empty(prod(shape) + len(caps), dtype)
        sides, uv[prod(shape) :] = uv[: prod(shape)].reshape(shape), caps
        for corner, values in enumerate((along[:, :-1], ahead[:, :-1], ahead[:, 1:], along[:, 1:])):
            sides[:, :, corner, 0] = values
            sides[:, :, corner, 1] = (left if corner in (0, 3) else right)[columns, None]
        return uv.reshape(-1, 2)

    def along(self, dtype=np.float64):
        """Values at each vertex that depend on its place along the axis: u and arc_length."""
        if not self.named:
            return {}
        return {"u": self.parameters.ravel().astype(dtype), "arc_length": self.places.ravel().astype(dtype)}

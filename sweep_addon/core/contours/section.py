# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A section: what every contour becomes, closed loops of points in the plane that bound an area."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np


@dataclass(frozen=True, eq=False)
class Section:
    """Loops of points, the area on their left: outer loops counter-clockwise, holes clockwise.

    Parameters
    ----------
    points : (m, 2) float array
        The points of all loops, one loop after the other, in metres.
    offsets : (k + 1,) int array
        Loop ``i`` is ``points[offsets[i]:offsets[i + 1]]``.
    sharp : (m,) bool array
        Where the outline has a corner, so that the sweep has an edge and not a rounding.
    """

    points: np.ndarray
    offsets: np.ndarray
    sharp: np.ndarray

    @cached_property
    def following(self):
        """(m,) int array: the index of the next point of the same loop."""
        following = np.arange(1, len(self.points) + 1)
        following[self.offsets[1:] - 1] = self.offsets[:-1]
        return following

    @cached_property
    def area(self):
        """The enclosed area, holes taken off, in square metres."""
        x, y = self.points.T
        return float(x @ y[self.following] - y @ x[self.following]) / 2

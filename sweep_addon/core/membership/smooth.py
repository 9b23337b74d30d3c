# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Regions of the plane within one smooth curve that has an equation: discs, ellipses and superellipses.

A region tells of points how far they are from its boundary at least, negative inside: ``depth(points)``, whose sign is
exact. Near the boundary ``exact(points)`` tells the distance, to first order, which is all that a tolerance asks, and
in which direction it grows. ``box`` is the least and the greatest x and y.
"""

import numpy as np

from ..declared.frozen import individual
from ..vectors import unit

LEAST = 1e-300  # keeps quotients at a centre finite


@individual
class Disc:
    """The points within a circle about the origin.

    >>> Disc(2.0).depth(np.array([(0.0, 1.0), (3.0, 4.0)])).tolist()
    [-1.0, 3.0]
    """

    radius: float

    @property
    def box(self):
        """The least and the greatest x and y: (2, 2) float array."""
        return np.array([[-self.radius] * 2, [self.radius] * 2])

    def depth(self, points):
        """How far points (n, 2) are from the circle, negative inside: (n,)."""
        return np.sqrt(points[:, 0] ** 2 + points[:, 1] ** 2) - self.radius

    def distance(self, x, y):
        """The same of places x (n,) and y (n,): (n,)."""
        return np.sqrt(x * x + y * y) - self.radius

    def exact(self, points):
        """The same, and unit vectors away from the boundary: (n,), (n, 2)."""
        return self.depth(points), unit(points)


@individual
class Superdisc:
    """The points within |x / a|^n + |y / b|^n = 1, n at least 1; an ellipse where it is 2.

    >>> Superdisc((2.0, 1.0), 2.0).depth(np.array([(2.0, 0.0), (0.0, 0.0)])).round(9).tolist()
    [0.0, -0.894427191]
    """

    half: tuple
    exponent: float

    @property
    def box(self):
        """The least and the greatest x and y: (2, 2) float array."""
        return np.array([-np.array(self.half), self.half])

    def depth(self, points):
        """How far points (n, 2) are from the curve, negative inside, or less: (n,)."""
        a, b = self.half
        return (self.levels(points)[0] - 1) * a * b / np.hypot(a, b)  # within it is a rhombus, and the level a norm

    def exact(self, points):
        """The distance near the curve to first order, and unit vectors away: (n,), (n, 2)."""
        level, slope = self.levels(points)
        steep = np.sqrt(slope[:, 0] ** 2 + slope[:, 1] ** 2)
        return (level - 1) / np.maximum(steep, LEAST), unit(slope)

    def levels(self, points):
        """By what factor the curve about the origin reaches points, and how that grows along x and y: (n,), (n, 2)."""
        scaled = np.abs(points) / self.half
        most = np.maximum(scaled.max(axis=1), LEAST)
        part = scaled / most[:, None]  # so that no power overflows
        sums = (part**self.exponent).sum(axis=1)
        level = most * sums ** (1 / self.exponent)
        slope = part ** (self.exponent - 1) * (np.maximum(sums, LEAST) ** (1 / self.exponent - 1))[:, None]
        return level, slope * np.sign(points) / self.half

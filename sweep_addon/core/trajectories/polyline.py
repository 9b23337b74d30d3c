# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A trajectory of straight legs whose corners are meant."""

import numpy as np

from ..parameters import Array, ShapeError, declared, parameter, require
from ..vectors import unit
from .curve import SHARPEST, Trajectory


@declared
class Polyline(Trajectory):
    """Straight legs with mitred corners

    u counts the corners: 0 at the first, 1 at the second, and so on.

    Examples
    --------
    >>> round(Polyline([(0, 0, 0), (1, 0, 0), (1, 2, 0)]).length(), 12)
    3.0
    """

    points: Array = parameter(((0, 0, 0), (0, 0, 1)), "Corners of the path", columns=3, unit="length")
    closed: bool = parameter(False, "The last corner leads back to the first")
    radii: Array = parameter((), "Scale of the contour at each corner, evenly between them; none: all 1")
    tilts: Array = parameter((), "Turn of the contour at each corner, evenly between them; none: all 0", unit="angle")

    straight = True

    def check(self):
        fewest = 3 if self.closed else 2
        require(len(self.points) >= fewest, f"must have at least {fewest} points", len(self.points), "points")
        legs = self.legs
        size = np.ptp(self.points.values, axis=0).max()
        self.refuse(np.linalg.norm(legs, axis=1) <= 1e-9 * size, "must not be where the next one is")
        legs = unit(legs)
        turn = np.einsum("ij,ij->i", legs, np.roll(legs, 1, axis=0))
        self.refuse((turn < SHARPEST)[0 if self.closed else 1 :], "must not turn back on itself", not self.closed)
        self.check_carried(len(self.points))

    def refuse(self, where, sentence, skipped=0):
        """Refuse the first point where something holds; the skipped points are not among those asked."""
        if where.any():
            index = int(np.argmax(where)) + skipped
            raise ShapeError(f"{sentence}, got point {index + 1} at {self.points.values[index].tolist()}", "points")

    @property
    def legs(self):
        corners = self.points.values
        return np.diff(np.concatenate((corners, corners[:1])) if self.closed else corners, axis=0)

    @property
    def domain(self):
        return 0.0, float(len(self.points) - 1 + self.closed)

    def joints(self):
        return np.arange(self.domain[1] + 1)

    def leg(self, u, before=False):
        """Which leg each parameter is on, and how far along it."""
        u = np.asarray(u, dtype=float)
        index = np.ceil(u) - 1 if before else np.floor(u)
        index = np.clip(index, 0, self.domain[1] - 1).astype(int)
        return index, u - index

    def evaluate(self, u):
        index, along = self.leg(u)
        return self.points.values[index] + along[:, None] * self.legs[index]

    def derivative(self, u, order=1, before=False):
        index, _ = self.leg(u, before)
        return self.legs[index] if order == 1 else np.zeros((len(index), 3))

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Legs: of a path of a rigid body the stretches on which it moves and turns evenly; and poses, where it is."""

from typing import NamedTuple

import numpy as np

from ..declared.frozen import individual
from ..vectors import cross, norms


class Pose(NamedTuple):
    """Where a body is: what was at x is at matrix x + origin."""

    matrix: np.ndarray  # (3, 3), a rotation
    origin: np.ndarray  # (3,), in metres

    def of(self, points):
        """Where points (n, 3) are."""
        return points @ self.matrix.T + self.origin

    def after(self, other):
        """The pose after another one."""
        return Pose(self.matrix @ other.matrix, self.matrix @ other.origin + self.origin)

    def inverse(self):
        """The pose that leads back."""
        return Pose(self.matrix.T, -self.matrix.T @ self.origin)


START = Pose(np.eye(3), np.zeros(3))


@individual
class Leg:
    """A stretch on which a body is carried straight and turned about an axis that is carried with it, both evenly.

    That is a translation where nothing turns, a rotation where nothing is carried, and a screw where the way is along
    the axis.

    Parameters
    ----------
    way : (3,) float array
        By which the axis is carried, in metres.
    pivot : (3,) float array
        A point of the axis as the leg begins.
    axis : (3,) float array
        A unit vector.
    angle : float
        In radians.
    """

    way: np.ndarray
    pivot: np.ndarray = np.zeros(3)
    axis: np.ndarray = np.array([0.0, 0.0, 1.0])
    angle: float = 0.0

    @property
    def turns(self):
        """Whether anything turns."""
        return self.angle != 0.0

    @property
    def carried(self):
        """Whether the axis is carried anywhere."""
        return bool(self.way.any())

    def pose(self, part):
        """The `Pose` after a part of the leg, from 0 to 1, as seen from its beginning."""
        if not self.turns:
            return Pose(np.eye(3), part * self.way)
        matrix = turn(self.axis, part * self.angle)
        return Pose(matrix, part * self.way + self.pivot - matrix @ self.pivot)

    def until(self, part):
        """The leg up to a part of it."""
        return Leg(part * self.way, self.pivot, self.axis, part * self.angle)

    def speed(self, points):
        """The length of the way that the fastest of points (n, 3) has to go at most, in metres."""
        away = norms(cross(points - self.pivot, np.broadcast_to(self.axis, points.shape))).max() if self.turns else 0.0
        return float(norms(self.way)) + abs(self.angle) * float(away)

    def seen(self, pose):
        """The same leg where everything is in another `Pose`."""
        return Leg(pose.matrix @ self.way, pose.of(self.pivot), pose.matrix @ self.axis, self.angle)


def turn(axis, angle):
    """The rotation about a unit axis (3,) by an angle: (3, 3) float array. Source: Rodrigues' formula."""
    across = crossing(axis)
    return np.eye(3) + np.sin(angle) * across + (1 - np.cos(angle)) * (across @ across)


def crossing(vector):
    """The matrix that makes of each vector the cross product of this one (3,) with it: (3, 3) float array."""
    x, y, z = vector
    return np.array([(0.0, -z, y), (z, 0.0, -x), (-y, x, 0.0)])


def poses(legs):
    """The poses in which legs begin, and the last one in which they end: a list, one longer than they are."""
    found = [START]
    for leg in legs:
        found.append(leg.pose(1.0).after(found[-1]))
    return found

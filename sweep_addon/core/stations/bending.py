# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bending: a straight model about the z axis to one about a curved axis, point by point.

"A curved axis defines a nonlinear transformation of the model": x and y lie along e2 and e3, z is the arc length.
Before its start and after its end the axis goes on straight.
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from ..declared.frozen import frozen
from .frames import axes
from .sampling import stations


class Axis(NamedTuple):
    """The curved axis at some heights of the straight model."""

    u: np.ndarray  # the trajectory's parameter, at its ends that of the ends: (n,)
    points: np.ndarray  # (n, 3)
    e1: np.ndarray  # (n, 3)
    e2: np.ndarray  # (n, 3)
    e3: np.ndarray  # (n, 3)
    told: tuple  # sentences for people, where the frame is not defined


class Rings(NamedTuple):
    """Contours along a curved axis, and which of them lean."""

    section: object  # the Section that moves
    u: np.ndarray  # the trajectory's parameter at each ring, of those that lean at their middle height: (n,)
    s: np.ndarray  # that height: (n,)
    axes: np.ndarray  # the axis there, and e2 and e3: (3, n, 3)
    ends: tuple  # the sections at the start and at the end
    leaning: tuple = (0, 0)  # at the start and at the end, how many rings have points at heights of their own: k in all
    heights: np.ndarray = None  # these: (m, k)
    lines: np.ndarray = None  # their places and the trajectory's parameter: (m, 4, k)


@frozen
class Bending:
    """The transformation that a smooth trajectory and its frame define.

    Parameters
    ----------
    trajectory : Trajectory
    frame : Direction or Frame
    total : float
        The trajectory's length in metres.
    mirrored : bool
        Whether x lies against e2.
    """

    trajectory: object
    frame: object
    total: float
    mirrored: bool = False

    def placed(self, stations):
        """The axis at stations of the trajectory, the first at its start."""
        e2, e3, told = carried(self.frame, stations)
        return Axis(stations.u, stations.points, stations.tangent, -e2 if self.mirrored else e2, e3, told)

    def axes(self, stations):
        """The axis, e2 and e3 at stations of the trajectory, which nobody may write to: (3, n, 3)."""
        return together(self, stations)

    def axis(self, z):
        """The axis at heights z, (n,) in any order."""
        s = z % self.total if self.trajectory.closed else np.clip(z, 0.0, self.total)
        known, which = np.unique(np.append(s, (0.0, self.total / 2)), return_inverse=True)
        which = which.ravel()[:-2]  # frames are measured from the start, and no station stands alone
        *parts, told = self.placed(stations(self.trajectory, known))
        u, points, e1, e2, e3 = (part[which] for part in parts)
        beyond = 0.0 if self.trajectory.closed else (z - s)[:, None]
        return Axis(u, points + beyond * e1, e1, e2, e3, told)

    def bend(self, points):
        """The points of a straight model, (n, 3), where the curved axis takes them: (n, 3)."""
        x, y, z = points.T
        axis = self.axis(z)
        return axis.points + x[:, None] * axis.e2 + y[:, None] * axis.e3


@lru_cache(maxsize=16)
def carried(frame, stations):
    """The axes of a frame that nothing twists, made once for each stations."""
    return axes(frame, stations, np.zeros(len(stations.s)))


@lru_cache(maxsize=4)
def together(bending, stations):
    """What `Bending.axes` gives, made once for the same stations."""
    axis = bending.placed(stations)
    found = np.stack((axis.points, axis.e2, axis.e3))
    found.setflags(write=False)
    return found

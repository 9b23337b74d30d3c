# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The way of a plane: what the classification of a planar sweep asks of a shape."""

from typing import NamedTuple

import numpy as np


class Carried(NamedTuple):
    """A contour's plane at some parameters."""

    middle: np.ndarray  # where the contour's origin is: (n, 3)
    normal: np.ndarray  # unit vectors across the plane, onward: (n, 3)
    x: np.ndarray  # what tells of a way within the plane how far it leads along the contour's axes, scales aside:
    y: np.ndarray  # unit vectors along them, where the contour stands across its way: (n, 3)
    scales: np.ndarray  # of the contour along them: (n, 2)


class Corner(NamedTuple):
    """A place where the plane turns at once, and both legs end in the bisector plane."""

    parameter: float
    point: np.ndarray
    arrive: np.ndarray  # unit tangents before and after: (3,)
    leave: np.ndarray
    zone: float  # how far along the way on both sides its plane cuts off what is beyond it, and both legs go on


class Limit(NamedTuple):
    """A plane that cuts the sweep off."""

    point: np.ndarray
    normal: np.ndarray  # away from what is kept
    low: float = -np.inf  # between which parameters it counts
    high: float = np.inf


class Dome(NamedTuple):
    """A round end."""

    middle: np.ndarray
    outward: np.ndarray  # unit vector away from the sweep: (3,)
    axes: np.ndarray  # the contour's axes there: (2, 3)
    scales: np.ndarray
    centre: np.ndarray  # of the contour, over which the tip is: (2,)
    height: float
    parameter: float  # of the end


class Way(NamedTuple):
    """The motion of a contour's plane, and what is in the contour."""

    carried: object  # from rising parameters, the first of them the first break, to a Carried
    breaks: np.ndarray  # between which it is smooth, both ends among them
    closed: bool
    region: object  # of the plane: depth, exact and growth of (points, parameters), and box
    parts: int = 16  # panels at least
    corners: tuple = ()
    limits: tuple = ()
    beyond: tuple = (0.0, 0.0)  # how far it goes on straight, before its start and after its end
    domes: tuple = ()
    clean: object = None  # from a distance to whether it is known that nothing comes so near to itself elsewhere
    faces: tuple = (True, True)  # whether one closes its start and its end
    parameter: object = None  # from the motion's parameter to that of the trajectory, where it is another

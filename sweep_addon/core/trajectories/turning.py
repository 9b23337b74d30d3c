# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turning about the z axis: a point that goes round it and rises evenly, and the derivatives of its way."""

from ..turns import cosines
from ..vectors import columns
from .curve import row


def turning(radius, u, rise, *orders):
    """The point at angles u, and derivatives of its way by u.

    Parameters
    ----------
    radius : float
        Its distance from the axis, in metres.
    u : (n,) array
        Angles in radians, from 0 on the x axis.
    rise : float
        By how much it rises in a radian, in metres.
    *orders : int
        Which derivatives; 0: the point.

    Returns
    -------
    tuple of (n, 3) float arrays

    Examples
    --------
    >>> point, velocity = turning(2.0, [0.0], 3.0, 0, 1)
    >>> point.tolist(), velocity[:, 1:].tolist()
    ([[2.0, 0.0, 0.0]], [[2.0, 3.0]])
    """
    u = row(u)
    x, y = (radius * part for part in cosines(u))
    left, back = -x, -y
    quarters = (x, y), (back, x), (left, back), (y, left)  # a derivative is a quarter of a turn ahead
    return tuple(placed(*quarters[order % 4], rise * u if order == 0 else rise * (order == 1)) for order in orders)


def placed(x, y, z):
    """The coordinates of points as vectors: (n, 3)."""
    points = columns((len(x), 3))
    points[:, 0], points[:, 1], points[:, 2] = x, y, z
    return points

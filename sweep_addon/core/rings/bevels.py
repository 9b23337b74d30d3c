# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bevels for mitres beyond their limit: their rings fan out from where the inner sides of both legs meet."""

import numpy as np

from ..stations.rotations import turned
from ..trajectories.legs import Cut
from ..vectors import dot, unit

ROUNDING = 1e-6  # of half a bevel: a ring at its end is on it


def on_bevels(stations):
    """The stations on a bevel, and the corner that each stands for: two (k,) int arrays, and where on it, from -1 to 1.

    ``along`` it and to the ``out``side of the corner point two (k, 3) unit vectors.
    """
    path = stations.trajectory
    corner = stations.u.round().astype(int) % len(path.points)
    before, after = (legs[corner] for legs in path.directions)
    along, out = unit(before + after), unit(before - after)
    half = path.setbacks.values[corner] * dot(before, along)
    part = dot(stations.points - path.points.values[corner], along) / np.where(half, half, np.inf)
    on = np.flatnonzero((half > 0) & (np.abs(part) <= 1 + ROUNDING))
    return on, corner[on], part[on], along[on], out[on]


def fanned(stations, rings):
    """Rings (3, n, 3) across the tangents as they stand on the bevels: the stations (k,) and these rings (3, k, 3).

    At both ends a ring is the section of its leg, from the outer edge, square to the corner, to where the inner edges
    of both legs meet, if these have room for that. Between them each column of the bevel goes straight.
    """
    path = stations.trajectory
    if not isinstance(path, Cut):
        return (), rings[:, :0]
    on, corner, part, along, out = on_bevels(stations)
    leg = path.directions[0][corner]
    cosine, sine, slope = dot(leg, along), dot(leg, out), path.setbacks.values[corner] / path.reach
    wider = (cosine + slope * sine - 1)[:, None] * out
    farther = (part * (sine - slope * cosine))[:, None] * along
    square = np.stack([turned(vectors[on], stations.tangent[on], along) for vectors in rings])
    return on, square + np.einsum("aij,ij->ai", square, out)[..., None] * (wider + farther)


def bevels(stations):
    """The corner on whose bevel each station is, or -1: (n,) int array."""
    bevel = np.full(len(stations.u), -1)
    if isinstance(stations.trajectory, Cut):
        on, corner, *_ = on_bevels(stations)
        bevel[on] = corner
    return bevel


def steps_on_bevels(stations):
    """Which steps lead from one station on a bevel to the next: (n - 1,) or (n,) bool."""
    bevel = bevels(stations)
    return (bevel[stations.starts] >= 0) & (bevel[stations.starts] == bevel[stations.onward])

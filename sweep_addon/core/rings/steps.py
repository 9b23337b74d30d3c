# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Steps: how the rings of a sweep follow each other, and what each step gives to the rings at its ends."""

from functools import lru_cache

import numpy as np

from ..declared.parameters import require, spelled
from ..vectors import cross, dot, norms, unit

STEEPEST = np.cos(np.radians(75))  # between a chord and the curve: a mitre is four times as long as the contour


def mitred(vectors, before, after):
    """Vectors (k, n, 3) across the bisectors of legs, stretched by 1 / cos(half the turn) in the plane of the turn.

    So a ring in the bisector plane is the section of both legs, whose unit vectors, (n, 3), are given.
    """
    stretch = 2 / norms(before + after) - 1
    across = unit(after - before)
    return vectors + (stretch * np.einsum("aij,ij->ai", vectors, across))[..., None] * across


def directions(stations):
    """Unit vectors along the steps: (n - 1, 3) or (n, 3)."""
    return unit(stations.steps(stations.points))


def forward(stations, legs):
    """How far legs, a vector for each step, lead along the curve where that is least, at one of their ends: (k,)."""
    return np.minimum(dot(legs, stations.leave[stations.starts]), dot(legs, stations.ended(stations.arrive)))


def require_short(stations, fit):
    """Refuse steps so long that a chord has another direction than the curve where it leaves it.

    Returns
    -------
    (n - 1,) or (n,) float array
        The cosine of the larger of the two angles between each chord and the curve at its ends.
    """
    cosine = forward(stations, directions(stations))
    leg, limit = int(cosine.argmin()), np.degrees(np.arccos(STEEPEST))
    angle = float(np.degrees(np.arccos(np.clip(cosine[leg], -1, 1))))
    sentence = f"must be more if the fit is {spelled(fit)}: a chord may leave the trajectory by {limit:.0f} degrees"
    require(angle <= limit, f"{sentence} at u = {stations.u[leg]:.6g}", round(angle, 1), "samples")
    return cosine


@lru_cache(maxsize=16)
def told_backward(stations):
    """What is to be told where a step goes against the trajectory, so that the sweep is inside out along it."""
    if stations.trajectory.axis and norms(stations.bend[:1]) * stations.lengths.max() < 1:
        return ()  # it bends the same everywhere, by less than a radian in a step
    if forward(stations, stations.steps(stations.points)).min() > 0:
        return ()
    along = forward(stations, directions(stations))
    place = f"from u = {stations.u[along.argmin()]:.4g} on a chord runs against the trajectory"
    return (f"Samples: {place}, and the sweep is inside out there: it takes more contours.",)


def to_both(stations, starts, ends, join):
    """What the steps give to the stations at their starts and at their ends, joined: two (k, ...) to (n, ...)."""
    joined = np.zeros((len(stations.s), *starts.shape[1:]))
    joined[: len(starts)] = starts
    joined[stations.onward] = join(joined[stations.onward], ends)
    return joined


def ahead(stations, axes, turn):
    """The axes (2, n, 3) at the end of each step: a closed sweep ends with the first, turned."""
    later = axes[:, stations.onward]
    if turn:
        later[:, -1] = spun(axes[:, 0], turn)
    return later


def spun(axes, angle):
    """Two axes turned towards each other, the first to the second."""
    x, y = axes
    return np.stack((np.cos(angle) * x + np.sin(angle) * y, np.cos(angle) * y - np.sin(angle) * x))


def handed(stations, axes):
    """1 where y is left of x, seen against the trajectory, -1 where laws mirror the contour."""
    return np.sign(np.einsum("ij,ij->", cross(*axes), stations.tangent))

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Leaps: where a frame turns at once, as Frenet's at an inflection, and a level one at a corner that climbs."""

from functools import lru_cache
from math import tau

import numpy as np

from ..vectors import norms
from . import sampling
from .continuing import PARTS, PLACES, SHORT, amid, evenly, once_round, shortly
from .frames import TOO_FAST, Continuation, FixedUp, Frenet, rotation_minimizing
from .rotations import wrapped

LEAST = 1e-3  # radians: a frame that turns less at a corner wrings nothing that could be seen


@lru_cache(maxsize=16)
def leaps(frame, trajectory):
    """Arc lengths right before and right behind each place where a frame turns at once.

    Contours must stand at both: between others the mesh would wring itself from one to the next, through its own axis.
    A level frame does so at corners alone, where contours stand anyway, and Frenet's at those of legs that bend.

    Parameters
    ----------
    frame : Frenet, FixedUp or any other, which leaps nowhere
    trajectory : Trajectory

    Returns
    -------
    (k, 2) float array
        In metres; that behind the end of a closed trajectory is behind its start.

    Examples
    --------
    >>> from sweep_addon.core.stations.frames import Frenet
    >>> from sweep_addon.core.trajectories import Formula
    >>> turning = Formula("u", "u^3", "0", start=-1.0, end=1.0)
    >>> (leap,) = leaps(Frenet(Continuation.EXACT), turning)
    >>> bool(leap[0] < turning.length() / 2 < leap[1]), leaps(Frenet(), turning).tolist()
    (True, [])
    """
    if isinstance(frame, FixedUp):
        return at_corners(frame, trajectory)
    if not isinstance(frame, Frenet):
        return np.zeros((0, 2))
    s, placed = evenly(trajectory)
    total, corners = s[-1], placed.s[placed.corners]
    before, after = leaping(frame, placed, total * shortly(frame) / PLACES)
    next_to = after == before + 1
    straight = amid(s, before[~next_to], after[~next_to])[:, None] + np.array([-0.5, 0.5]) * total / (PLACES * PARTS)
    found = np.stack((s[before[next_to]], s[before[next_to] + 1]), axis=1)
    if len(found):
        closer = np.unique(np.concatenate(([0.0, total], np.linspace(*found.T, PARTS + 1).ravel())))
        placed = sampling.stations(trajectory, closer[:-1] if trajectory.closed else closer)
        before, after = leaping(frame, placed, SHORT * total / PLACES)
        found = np.stack((closer[before], once_round(closer, after)), axis=1)
    found = np.concatenate((found, straight))
    found = np.where(found < total, found, found - total)
    return np.concatenate((found[~np.isin(found, corners).any(axis=1)], at_corners(frame, trajectory)))


def leaping_steps(frame, stations):
    """Which steps from one station to the next are within a leap: (n - 1,) or (n,) bool."""
    start, close = stations.s[stations.starts, None], 2 * sampling.SHORTEST_STEP * stations.total
    before, after = leaps(frame, stations.trajectory).T - close
    within = (start >= before) & (start < after)
    round_the_seam = (before > after) & ((start >= before) | (start < after))
    return (within | round_the_seam).any(axis=1)


def at_corners(frame, trajectory):
    """Arc lengths right before corners where a frame turns at once, and of these: (k, 2)."""
    s, placed = evenly(trajectory)
    corners = placed.s[placed.corners]
    room = np.diff(corners, prepend=corners[-1:] - s[-1] if trajectory.closed else 0.0)
    before = corners - np.minimum(s[-1] / (PLACES * PARTS), room / 2)
    before = np.where(before < 0, before + s[-1], before)
    ends = placed.s[[0, -1]]  # a corner that comes last would be taken for the end of an open path
    around = sampling.stations(trajectory, np.unique(np.concatenate((ends, before, corners))))
    normals, holonomy = rotation_minimizing(around)
    angles = frame.angles(around, normals, holonomy, 1)[0]
    here, there = np.searchsorted(around.s, before), np.searchsorted(around.s, corners)
    turn = angles[there] - angles[here] - np.where(before > corners, -holonomy, 0.0)
    bends = norms(around.bend[here]) + norms(placed.going_on) > 0  # or Frenet's frame turns along the leg, and not here
    return np.stack((before, corners), axis=1)[(np.abs(wrapped(turn)) > LEAST) & (bends | isinstance(frame, FixedUp))]


def leaping(frame, placed, straight):
    """The stations from which a frame leaps to the next that has a normal, and these, once round: two (k,) int.

    Between two that are farther apart than what is told to be straight it turns evenly.
    """
    normals, holonomy = rotation_minimizing(placed)
    angles, curved = frame.towards(placed, normals)
    here, angles = np.flatnonzero(curved), angles[curved]
    if placed.closed and len(here):
        here, angles = np.append(here, here[0] + len(placed.s)), np.append(angles, angles[0] - holonomy)
    at = once_round(np.append(placed.s, placed.total) if placed.closed else placed.s, here)
    turn = wrapped(np.diff(angles), tau if frame.continuation is Continuation.EXACT else tau / 2)
    leap = (np.abs(turn) > TOO_FAST) & (np.diff(at) <= straight)
    return here[:-1][leap], here[1:][leap]

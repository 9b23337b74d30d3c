# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How a frame that its place decides goes on where it is not defined: evenly, or at once in one place.

It is continued between many places of its own, so that it does not depend on how many contours stand there.
"""

from functools import lru_cache
from math import tau
from typing import NamedTuple

import numpy as np

from ..declared.wording import near
from ..trajectories.arc_length import arc_length
from . import sampling
from .frames import TOO_FAST, FixedUp, Frenet, rotation_minimizing
from .rotations import wrapped
from .spreading import distinct

PLACES = 2049  # where it is looked at how a frame turns, from each of which to the next it is continued
TIE = 1e-6  # radians: where planes of two bends are square to each other, rounding must not choose the side
PARTS = 16  # of a step in which a frame turns fast, that are looked at too: single precision still tells them apart
SHORT = 4  # of them: over a longer stretch without a normal a frame turns evenly,
LONGER = 205  # one that changes its side if it is longer than this, a tenth of the length


@lru_cache(maxsize=16)
def evenly(trajectory):
    """Arc lengths from end to end, even but for the corners, (n,), and the stations there, without a closed end."""
    measure = arc_length(trajectory)
    s = np.concatenate((np.linspace(0.0, measure.total, PLACES), measure.at(trajectory.stops())))
    s = distinct(s.clip(0.0, measure.total), sampling.SHORTEST_STEP * measure.total)
    s[-1] = measure.total
    return s, sampling.stations(trajectory, s[:-1] if trajectory.closed else s)


@lru_cache(maxsize=16)
def closely(frame, trajectory):
    """The same as `evenly`, and more places between those from which a frame turns by more than `TOO_FAST` to the next.

    So a bend that is small beside the path's length, and turns the frame by more than a right angle, is not taken for
    one that brings it to its other side.
    """
    s, placed = evenly(trajectory)
    if not isinstance(frame, Frenet | FixedUp):
        return s, placed
    normals, holonomy = rotation_minimizing(placed)
    found, defined = frame.towards(placed, normals)
    fast = too_fast(placed, found, defined, holonomy, tau / 2)
    if not len(fast):
        return s, placed
    s = np.union1d(s, np.linspace(s[fast], s[fast + 1], PARTS + 1))
    return s, sampling.stations(trajectory, s[:-1] if trajectory.closed else s)


class Continued(NamedTuple):
    """How a frame goes on along a trajectory, however few contours stand there.

    Parameters
    ----------
    s : (n,) float array
        Arc lengths in metres, rising from end to end; twice where a leap ends.
    angles : (n,) float array
        From the rotation-minimizing normals, in radians; 0 where the frame is defined nowhere.
    period : float
        By multiples of which an angle may be off that by definition: half a turn if the frame keeps its side.
    place : str or None
        Where it is first not defined, or turns by more than a right angle at once, as people read it.
    defined : bool
        Whether it is defined anywhere.
    over : (2, k) float array
        Between which places it goes on evenly though it is defined there: it keeps its side where that changes.
    """

    s: np.ndarray
    angles: np.ndarray
    period: float
    place: str | None
    defined: bool
    over: np.ndarray


@lru_cache(maxsize=16)
def continued(frame, trajectory):
    """How a frame, Frenet or FixedUp, goes on along a trajectory: `Continued`."""
    s, placed = closely(frame, trajectory)
    normals, holonomy = rotation_minimizing(placed)
    found, defined = frame.towards(placed, normals)
    if not defined.any():
        return Continued(s, np.zeros(len(s)), tau, lost(placed, defined, None), False, np.zeros((2, 0)))
    flips = flipping(fill(placed, found, defined, holonomy), placed, holonomy)
    flips[placed.corners - 1] = False  # there it is defined on both sides
    angles = fill(placed, found, defined, holonomy, half=frame.keeps_its_side)
    period = tau / 2 if np.cos(angles - found)[defined].min() < 0 else tau  # round a closed path it may not keep it
    if placed.closed:
        angles = np.append(angles, angles[-1] + nearest(angles[0] - holonomy - angles[-1], period))
    over = too_fast(placed, found, defined, holonomy, tau)[: None if frame.keeps_its_side else 0]
    over = np.stack((s[over], s[over + 1]))
    s, angles = leaping_at_once(s, angles, defined, frame, placed.closed)
    place = None if defined.all() and not flips.any() else lost(placed, defined, flips)
    return Continued(s, angles, period, place, True, over)


def leaping_at_once(s, angles, defined, frame, closed):
    """Places and angles (n,) with each leap in one place, so that what has no angle itself is not found halfway round.

    That is where the next angle is or, where there are places without one before that, in the middle of these.
    """
    at = np.flatnonzero(defined)
    known, lap = angles[at], len(angles) - 1
    if closed:
        grown = angles[-1] - angles[0]
        at, known = (
            np.concatenate((each[-1:] - once, each, each[:1] + once)) for each, once in ((at, lap), (known, grown))
        )
    place, steps = once_round(s, at), np.diff(at)
    leap = np.append((np.abs(np.diff(known)) > TOO_FAST) & (np.diff(place) <= s[-1] * shortly(frame) / PLACES), False)
    there = np.append(np.where(steps > 1, amid(s, at[:-1], at[1:]), place[1:]), np.inf)
    before = np.maximum(np.searchsorted(at, np.arange(lap + 1), side="right") - 1, 0)
    after = np.minimum(before + 1, len(at) - 1)
    within = leap[before] & (place[before] < s)
    angles = np.where(within, np.where(s < there[before], known[before], known[after]), angles)
    here = np.flatnonzero(leap & (there >= 0) & (there <= s[-1]))
    index = np.repeat(np.searchsorted(s, there[here]), 2)
    both = np.stack((known[here], known[here + 1]), axis=1).ravel()
    return np.insert(s, index, np.repeat(there[here], 2)), np.insert(angles, index, both)


def amid(s, before, after):
    """The middle of the places between some and others: (k,)."""
    return (once_round(s, before + 1) + once_round(s, after - 1)) / 2


def once_round(s, which):
    """Arc lengths of places, of which those beyond the ends are as far beyond once round: (k,)."""
    lap = len(s) - 1
    return np.where(which == lap, s[-1], s[which % lap] + which // lap * s[-1])


def shortly(frame):
    """How many places a path may be straight where a frame leaps, and does not turn evenly."""
    return SHORT if frame.keeps_its_side else LONGER


def along_path(frame, stations, found, defined):
    """The angles of a frame at stations, (n,), by those of its definition and where there are any, and the place where
    it is `continued` beyond that, or None.
    """
    known = continued(frame, stations.trajectory)
    near_by, (before, behind) = np.interp(stations.s, known.s, known.angles), known.over
    followed = defined & (np.searchsorted(before, stations.s) == np.searchsorted(behind, stations.s, side="right"))
    return np.where(followed, near_by + nearest(found - near_by, known.period), near_by), known.place


def fill(stations, angles, known, holonomy, half=False):
    """Angles made continuous over the stations, those not known taken evenly between their neighbours.

    With `half`, an angle and the one opposite are the same, so that an inflection does not turn the frame round.
    """
    period = tau / 2 if half else tau
    at, found = stations.s[known], angles[known].copy()
    steps = np.diff(found)
    found[1:] += period * np.cumsum(np.round((nearest(steps, period) - steps) / period))
    if stations.closed:  # once round, the same frame stands at an angle that has grown by minus the holonomy
        again = found[0] - holonomy
        again = found[-1] + nearest(again - found[-1], period)
        if abs(wrapped(again - found[0] + holonomy)) > tau / 4:  # the sides changed an odd number of times
            return fill(stations, angles, known, holonomy)
        at, found = np.append(at, at[0] + stations.total), np.append(found, again)
        at, found = np.insert(at, 0, at[-2] - stations.total), np.insert(found, 0, found[-2] - (again - found[0]))
    return np.interp(stations.s, at, found)


def nearest(steps, period):
    """Steps to the nearest of angles that are the same, and forward where one back is as near but for rounding."""
    return wrapped(steps - TIE, period) + TIE


def lost(stations, defined, flips):
    """The first place where a frame is not defined, or amid the first step in which it flips, as people read it."""
    domain = stations.trajectory.domain
    if not defined.all():
        return near(stations.u[np.argmin(defined)], *domain)
    step = np.argmax(flips)
    return near((stations.u[step] + np.append(stations.u, domain[1])[step + 1]) / 2, *domain)


def flipping(angles, stations, holonomy):
    """Where the angle jumps by more than a quarter turn from one station to the next: (n - 1,) or (n,) bool."""
    return np.abs(wrapped(turning(angles, stations, holonomy))) > tau / 4


def too_fast(stations, found, defined, holonomy, period):
    """The steps, (k,), in which an angle that is defined at both ends turns by more than `TOO_FAST`, but for corners.

    Angles that differ by the period are one.
    """
    fast = np.abs(wrapped(turning(found, stations, holonomy), period)) > TOO_FAST
    fast &= defined[stations.starts] & stations.ended(defined)
    fast[stations.corners - 1] = False  # of a closed trajectory the last step leads to the first corner
    return np.flatnonzero(fast)


def turning(angles, stations, holonomy):
    """By how much angles from the rotation-minimizing normals grow from one station to the next: (n - 1,) or (n,)."""
    step = stations.steps(angles)
    if stations.closed:
        step[-1] -= holonomy
    return step

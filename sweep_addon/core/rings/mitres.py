# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Legs between mitres: rings on them lean more and more towards the plane of a mitre that they come near."""

import numpy as np

from ..stations.continuing import PARTS, PLACES
from ..stations.frames import UPRIGHT, FixedUp
from ..stations.transport import transport
from ..trajectories import Polyline
from ..trajectories.legs import Cut
from ..vectors import cross, dot, norms, unit
from .bevels import bevels

ROOM = 2.0  # times what a mitre lies back: its fan leaves of each step at least half, and at most adds as much
BESIDE = (1 + 1e-6) / (PLACES * PARTS)  # of the trajectory's length: no farther before a corner a frame leaps there
FARTHER = 1.05  # times as far the plane of a mitre cuts legs off as its ring reaches: points are on true curves
STRAIGHT = 1e-9  # of the trajectory's length: a station that is no farther off the line of its leg is on it


def legs(stations):
    """The stretches from corner to corner, or an end: the stations at their ends and their lengths, three (k,)."""
    ends = stations.corners
    if stations.closed:
        first, last = ends, np.roll(ends, -1)
    else:
        ends = np.unique(np.concatenate(([0], ends, [len(stations.s) - 1])))
        first, last = ends[:-1], ends[1:]
    lengths = stations.s[last] - stations.s[first]
    return first, last, np.where(lengths > 0, lengths, lengths + stations.total)


def cut_back(arrive, leave, reach):
    """How far along its legs a mitre reaches at most, of a contour that reaches so far, with room to spare: (n,).

    The unit vectors along the legs, (n, 3), are given. The plane cuts off what is so near to the corner, and nothing
    farther along, where a leg that bends may pass it again.
    """
    return FARTHER * reach * norms(leave - arrive) / norms(leave + arrive)


def leans(along, frame, symmetry):
    """Whether it makes a difference that rings lean between mitres.

    It does where laws, tapers or a frame that turns along a leg change the contour there, or a bevel stands for one.
    """
    path = along.trajectory
    if isinstance(path, Cut):
        return True
    if not isinstance(path, Polyline) or path.rounded or not len(path.corners()):
        return False
    if isinstance(frame, FixedUp):
        joints = path.joints()
        level = cross(unit(np.array(frame.up)[None]), path.tangents((joints[1:] + joints[:-1]) / 2))
        return not along.keeps_legs or norms(level).min() <= UPRIGHT
    return not along.keeps_legs or bool(path.closed and frame.grown(transport(path).holonomy, symmetry))


def leaned(stations, rings, reach):
    """Rings that follow each other on all sides of a leg, however near to a mitre they stand.

    Parameters
    ----------
    stations : Stations
    rings : (3, n, 3) float array
        At each station the way off it and the contour's x and y axes, scaled, all of them across the tangent.
    reach : float
        How far the contour's farthest point is from its reference point before any scale, in metres.

    Returns
    -------
    (3, n, 3) float array
        Those on the straight part of a leg sheared along it, so that they are still sections of it. Rings at corners,
        which are to be mitred, and rings far from corners are as they were.

    On its inner side a mitre lies back from the corner, at the contour's farthest point by its steepness times how far
    out that is. Perpendicular rings nearer than this would go through it. A ring at distance d lies back too, and what
    it lies back falls evenly, from what the mitre does to nothing where d is `ROOM` times that: so every point moves
    on along the leg from ring to ring. Where the fans of both ends overlap, as neither has this room, each is spread
    over the whole leg: the rings go from one mitre's plane to the other's, each column is divided as the leg is, and
    it turns back only where the mitres themselves cross.

    A scale that is the same along both axes keeps that exactly. A ring is flat, so where the contour is twisted or
    stretched on the way, its points are those of the place where its middle is: the surface is off by what the law
    changes over the lean, as it is at the mitre, and a twist that turns fast there may still carry points back.
    """
    first, last, lengths = legs(stations)
    if len(first) == len(stations.onward):
        return rings
    inside, starts = np.ones(len(stations.s), bool), np.zeros(len(stations.s), int)
    inside[first] = inside[last] = False
    starts[first] = 1
    leg = np.cumsum(starts) - 1  # before the first corner of a ring it is the last leg
    done = (stations.s - stations.s[first[leg]]) % stations.total

    arrive, leave, size = stations.arrive, stations.leave, extents(rings, reach)
    ends = (first, leave[first], arrive[first], done), (last, arrive[last], leave[last], done - lengths[leg])
    for (corner, way, other, along), (most, fan) in zip(ends, fans(stations, rings, reach), strict=True):
        near = np.flatnonzero(inside & (np.abs(along) < fan[leg]))
        near = straight(stations, near, leg, corner, way, along, fan)
        at = leg[near]
        share = np.where(beside(stations, along[near]), 1.0, 1 - np.abs(along[near]) / fan[at]) * most[at]
        slope = np.divide(share, size[near], out=np.zeros_like(share), where=size[near] > 0)
        lean = slope[:, None] * unit(other - dot(other, way)[:, None] * way)[at]
        rings[:, near] -= np.einsum("aij,ij->ai", rings[:, near], lean)[..., None] * way[at]
    return rings


def fans(stations, rings, reach):
    """How far the mitres at the starts of legs lie back, and how far their fans reach; the same at the ends: (k,) each.

    All that is asked of are the rings at corners and ends; see `leaned`.
    """
    first, last, lengths = legs(stations)
    mitres = steepness(stations) * extents(rings, reach)
    adds = mitres[first], mitres[last]
    crowded = ROOM * sum(adds) > lengths
    return [(most, np.where(crowded, lengths, ROOM * most)) for most in adds]


def steepness(stations):
    """How much the ring at each station leans against its leg: the tangent of half the turn, 0 where there is none.

    A bevel for a mitre beyond its limit takes its setback off the inner side as well.
    """
    steep, bevel = np.zeros(len(stations.s)), bevels(stations)
    arrive, leave = stations.arrive[stations.corners], stations.leave[stations.corners]
    steep[stations.corners] = norms(leave - arrive) / norms(leave + arrive)
    cut = bevel >= 0
    if cut.any():
        path = stations.trajectory
        steep[cut] = path.setbacks.values[bevel[cut]] / path.reach
    return steep


def extents(rings, reach):
    """How far rings (3, n, 3) of a contour that reaches so far get from the trajectory: (n,) in metres."""
    aside, x, y = norms(rings)
    return aside + reach * np.maximum(x, y)


def straight(stations, near, leg, corner, way, along, fan):
    """Those of some stations to which their leg goes straight from a corner; fans end before the first that is not."""
    at = corner[leg[near]]
    line = stations.points[at] + along[near, None] * way[leg[near]]
    off = norms(stations.points[near] - line) > STRAIGHT * stations.total
    off = near[off & ~beside(stations, along[near])]
    np.minimum.at(fan, leg[off], np.abs(along[off]))
    return near[np.abs(along[near]) < fan[leg[near]]]


def beside(stations, along):
    """Which of some ways along legs are so short that a frame leaps over them: there a ring leans as the mitre does."""
    return np.abs(along) <= BESIDE * stations.total

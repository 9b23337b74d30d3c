# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trimming: where a limiting plane cuts the lines that the points of a contour draw, and the rings up to there.

A ring whose points stand at one height of the axis is the contour itself. Towards an oblique plane rings lean, from the
contour to the cut, so that no ring is cut in two, and all faces keep four corners.
"""

from dataclasses import replace

import numpy as np

from ..declared.parameters import ShapeError, at, require
from ..grids.drawn import affine
from ..meshes.mesh import require_few
from ..self_intersection.folds import roots
from ..stations.bending import Rings
from ..stations.spans import Fan, spans
from ..vectors import cross, norms, unit
from .limits import Plane

FARTHEST = 100.0  # lengths and reaches beyond the end, to which a solid may go on
ROOM = 0.5  # of the range of the cuts: how much farther in the first ring stands that does not lean
CLOSEST = 1e-3  # of the mean step: a ring nearer to another would make slivers
SHORTEST = 1e-9  # of the axis, between two planes
ONCE = "must cut the line of every point of the contour once"
NEARBY = 16  # heights, among which a cut is looked for at first: it is near an end of the axis
HALVINGS = 12  # of an edge at most: what is missed falls to a quarter with each
FLAT = 1e-9  # the sine of the angle between a plane and the axis beyond its end: it is never cut there


def trimmed(limits, bending, section, stations, tolerance):
    """The rings of a sweep between its limits, of which one is a plane at least.

    Parameters
    ----------
    limits : tuple of two (Flat, Open or Plane)
    bending : Bending
    section : Section
    stations : Stations
        Where contours would stand if nothing were cut off.
    tolerance : float
        How far from a cut the middle of an edge may be, in metres.

    Returns
    -------
    Rings
        Their section has as many points as the cuts bend.

    Raises
    ------
    ShapeError
        Where a plane does not cut the line of every point once, and where nothing is left.
    """
    whole = spans(bending)
    section, (starts, ends) = followed(limits, whole, section, tolerance)
    left = float((ends - starts).min())
    if left <= SHORTEST * bending.total:
        raise ShapeError(f"must leave something behind the start everywhere, got {left:.6g} m of it", "end")
    require_few(len(section.points) * len(stations.s), "samples")
    between, *fans = ranged(stations.s, starts, ends, [isinstance(limit, Plane) for limit in limits])
    weights = np.concatenate((affine(section.points), np.eye(3)))
    leaning = first, _ = tuple(len(fan.share) for fan in fans)
    heights, lines = np.empty((len(weights), sum(leaning))), np.empty((len(weights), 4, sum(leaning)))
    for fan, there in zip(fans, (slice(first), slice(first, None)), strict=True):
        wide = fan.with_middles()
        heights[:, there] = wide.heights
        whole.lines(weights, heights[:, there], wide, lines[..., there])
    heights, middles, lines, own = heights[:-3], heights[-1], lines[:-3], lines[-3:]
    axis = bending.placed(stations)

    def joined(values, others):
        return np.concatenate((values[:first], others[between], values[first:]))

    axes = np.stack(
        [joined(*pair) for pair in zip(own[:, :3].swapaxes(1, 2), (axis.points, axis.e2, axis.e3), strict=True)]
    )
    outlines = tuple(
        outline(limit, section, lines[..., side], axes[:, side]) if isinstance(limit, Plane) else section
        for limit, side in zip(limits, (0, -1), strict=True)
    )
    u, s = joined(own[0, 3], axis.u), joined(middles, stations.s)
    return Rings(section, u, s, axes, outlines, leaning, heights, lines)


def followed(limits, whole, section, tolerance):
    """A section whose edges are halved until straight ones follow the cuts, and where the lines of its points end.

    Returns
    -------
    section : Section
    ends : (2, m) float array
        Heights along the axis in metres; below 0 and above the total where the solid goes on straight.
    """
    planes = [(side, limit) for side, limit in enumerate(limits) if isinstance(limit, Plane)]
    for halvings in range(HALVINGS, -1, -1):
        ahead = section.following.copy()
        ahead[section.gaps] = section.gaps
        points = np.concatenate((section.points, (section.points + section.points[ahead]) / 2))
        found = np.tile([[0.0], [whole.bending.total]], len(points))
        intervals = []
        for side, plane in planes:
            with at(("start", "end")[side]):
                intervals.append(interval(plane, whole, points, side))
        heights, places = crossings([plane for _, plane in planes], whole, points, np.concatenate(intervals, axis=1))
        found[[side for side, _ in planes]] = heights
        corners, middles = np.split(places, 2, axis=1)
        missed = norms(middles - (corners + corners[:, ahead]) / 2).max(axis=0)
        if missed.max() <= tolerance or not halvings:
            return section, found[:, : len(ahead)]
        section = section.divided(missed > tolerance)


def interval(plane, whole, points, side):
    """Where lines of points (m, 2) first change their side of a plane, coming from the axis's start or end: (4, m).

    Between two heights, of which each line is so far above the plane: two rows, and two.
    """
    looked, most = NEARBY, len(whole.looked_at[0])
    while True:
        z, above = looked_at(plane, whole, points, side, looked)
        higher = above >= 0
        change = higher[:, 1:] != higher[:, :-1]
        missed = ~change.any(axis=1)
        if looked >= most or not missed.any():
            break
        looked *= 4
    if missed.any():
        raise ShapeError(f"{ONCE}, got that of point {np.argmax(missed) + 1} not cut")
    first, every = change.argmax(axis=1), np.arange(len(points))
    again = change[:, : first.max() + 1].sum(axis=1) > 1
    again |= higher[:, 0] != higher[0, 0]
    if again.any():
        raise ShapeError(f"{ONCE}, got that of point {np.argmax(again) + 1} cut again before all others are")
    return np.stack((z[first], z[first + 1], above[every, first], above[every, first + 1]))


def looked_at(plane, whole, points, side, most):
    """Heights from beyond an end of the axis on, (k,), and how far each line is above the plane, (m, k).

    The first height is beyond all cuts that there are beyond the end; not more than so many others follow.
    """
    z, axes = (part[:: -1 if side else 1][:most] for part in whole.looked_at)
    levels = (axes.reshape(-1, 3) @ plane.across).reshape(-1, 3)
    levels[:, 0] += plane.heights(np.zeros(3))
    above = affine(points) @ levels.T
    outward = float(whole.outward[side] @ plane.across)
    if abs(outward) > FLAT:
        total = whole.bending.total
        beyond, most = float((-above[:, 0] / outward).max()), FARTHEST * (total + float(np.abs(points).max()))
        require(beyond <= most, f"must cut within {most:.6g} m of the trajectory's end", beyond)
        far = max(beyond, 0.0) + total
        z = np.concatenate(([z[0] + (far if side else -far)], z))
        above = np.concatenate((above[:, :1] + far * outward, above), axis=1)
    return z, above


def crossings(planes, whole, points, intervals):
    """Where lines of points (m, 2) cross planes, in intervals (4, p m): heights (p, m) and places (p, m, 3)."""
    low, high, at_low, at_high = intervals
    points, middles = np.tile(points, (len(planes), 1)), (low + high) / 2
    which = np.repeat(np.arange(len(planes)), len(points) // len(planes))
    across = np.array([plane.across for plane in planes])
    level = np.array([plane.heights(np.zeros(3)) for plane in planes])[which]
    along = whole.along(across, which, points, middles)
    found = roots(lambda z: along(z) + level, low, high, at_low, at_high)
    return found.reshape(len(planes), -1), whole.line(points, middles)(found).reshape(len(planes), -1, 3)


def ranged(stations, starts, ends, planes):
    """Which stations are left as they are, and the heights of the points of rings before and after them that lean.

    Parameters
    ----------
    stations : (n,) float array
        Arc lengths where contours stand along the axis, both ends included.
    starts, ends : (m,) float array
        Where the line of each point begins and ends.
    planes : sequence of two bool
        Whether a plane is there: the ring in it counts among those that lean.

    Returns
    -------
    between : slice
    before, after : Fan
    """
    low, high = starts.min(), ends.max()
    close = CLOSEST * stations[-1] / len(stations)
    inner = stations[(stations > low + close) & (stations < high - close)]
    upright = np.concatenate(([low], inner, [high]))
    before = upright < starts.max() + ROOM * np.ptp(starts)
    after = upright > ends.min() - ROOM * np.ptp(ends)
    before[0] |= planes[0]
    after[-1] |= planes[1]
    kept = upright[~(before | after)]
    if not len(kept):
        share = (upright - low) / (high - low)
        return slice(0), Fan(starts, ends - starts, share), Fan(ends, ends - starts, share[:0])
    begin = np.searchsorted(stations, kept[0])
    before = Fan(kept[0], starts - kept[0], (upright[before] - kept[0]) / (low - kept[0]))
    after = Fan(kept[-1], ends - kept[-1], (upright[after] - kept[-1]) / (high - kept[-1]))
    return slice(begin, begin + len(kept)), before, after


def outline(plane, section, cut, axes):
    """The section in a limiting plane, seen against the direction of the axis, (m, 2) in metres.

    Its points, (m, 4), are put there to the last bit that rounding leaves.
    """
    cut[:, :3] -= plane.heights(cut[:, :3])[:, None] * plane.across
    middle, e2, e3 = axes
    x = unit(e2 - (e2 @ plane.across) * plane.across)
    y = cross(plane.across, x)
    y *= np.sign(y @ e3)
    return replace(section, points=(cut[:, :3] - middle) @ np.stack((x, y), axis=1))

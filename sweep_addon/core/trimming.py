# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trimming: where a limiting plane cuts the lines that the points of a contour draw, and the rings up to there.

A ring whose points stand at one height of the axis is the contour itself. Towards an oblique plane rings lean, from the
contour to the cut, so that no ring is cut in two, and all faces keep four corners.
"""

from dataclasses import replace

import numpy as np

from .bending import Rings
from .drawn import affine
from .limits import Plane
from .mesh import require_few
from .parameters import ShapeError, at, require
from .self_intersection.folds import roots
from .spans import spans
from .vectors import cross, norms, unit

FARTHEST = 100.0  # lengths and reaches beyond the end, to which a solid may go on
ROOM = 0.5  # of the range of the cuts: how much farther in the first ring stands that does not lean
CLOSEST = 1e-3  # of the mean step: a ring nearer to another would make slivers
SHORTEST = 1e-9  # of the axis, between two planes
ONCE = "must cut the line of every point of the contour once"
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
    section, (starts, ends) = followed(limits, bending, section, tolerance)
    left = float((ends - starts).min())
    if left <= SHORTEST * bending.total:
        raise ShapeError(f"must leave something behind the start everywhere, got {left:.6g} m of it", "end")
    require_few(len(section.points) * len(stations.s), "samples")
    between, before, after = ranged(stations.s, starts, ends, [isinstance(limit, Plane) for limit in limits])
    heights = np.concatenate((before, after), axis=1)
    middles = heights.mean(axis=0)
    weights = np.concatenate((affine(section.points), np.eye(3)))
    lines = spans(bending).lines(weights, np.concatenate((heights, np.tile(middles, (3, 1)))))
    lines, own = lines[:-3], lines[-3:]
    axis = bending.placed(stations)
    known = zip(own[..., :3], (axis.points, axis.e2, axis.e3), strict=True)
    leaning = before.shape[1]

    def inserted(values, others):
        return np.concatenate((values[:leaning], others[between], values[leaning:]))

    axes = np.stack([inserted(*pair) for pair in known])
    outlines = tuple(
        outline(limit, section, lines[:, side], axes[:, side]) if isinstance(limit, Plane) else section
        for limit, side in zip(limits, (0, -1), strict=True)
    )
    u, s = inserted(own[0, :, 3], axis.u), inserted(middles, stations.s)
    rings = np.delete(np.arange(len(s)), slice(leaning, len(s) - after.shape[1]))
    return Rings(section, u, s, axes, outlines, rings, heights, lines)


def followed(limits, bending, section, tolerance):
    """A section whose edges are halved until straight ones follow the cuts, and where the lines of its points end.

    Returns
    -------
    section : Section
    ends : list of two (m,) float arrays
        Heights along the axis in metres; below 0 and above the total where the solid goes on straight.
    """
    for halvings in range(HALVINGS, -1, -1):
        ahead = section.following.copy()
        ahead[section.gaps] = section.gaps
        points = np.concatenate((section.points, (section.points + section.points[ahead]) / 2))
        missed, found = np.zeros(len(ahead)), []
        for key, limit, end in zip(("start", "end"), limits, (0.0, bending.total), strict=True):
            heights = np.full(len(points), end)
            if isinstance(limit, Plane):
                with at(key):
                    heights, places = cuts(limit, bending, points, end > 0)
                corners, middles = np.split(places, 2)
                missed = np.maximum(missed, norms(middles - (corners + corners[ahead]) / 2))
            found.append(heights[: len(ahead)])
        if missed.max() <= tolerance or not halvings:
            return section, found
        section = section.divided(missed > tolerance)


def cuts(plane, bending, points, at_end):
    """Where a plane cuts the lines of points (m, 2), from the axis's start or its end on: heights, places (m, 3)."""
    z, sides = looked_at(plane, bending, points, at_end)
    above = sides >= 0
    change = above[:, 1:] != above[:, :-1]
    missed = ~change.any(axis=1)
    if missed.any():
        raise ShapeError(f"{ONCE}, got that of point {np.argmax(missed) + 1} not cut")
    first, every = change.argmax(axis=1), np.arange(len(points))
    again = change[:, : first.max() + 1].sum(axis=1) > 1
    again |= above[:, 0] != above[0, 0]
    if again.any():
        raise ShapeError(f"{ONCE}, got that of point {np.argmax(again) + 1} cut again before all others are")
    low, high = z[first], z[first + 1]
    line = spans(bending).line(points, (low + high) / 2)
    found = roots(lambda z: plane.heights(line(z)), low, high, sides[every, first], sides[every, first + 1])
    reach = bending.total + float(np.abs(points).max())
    farthest = float(np.abs(found - np.clip(found, 0.0, bending.total)).max())
    require(farthest <= FARTHEST * reach, f"must cut within {FARTHEST * reach:.6g} m of the trajectory's end", farthest)
    return found, line(found)


def looked_at(plane, bending, points, at_end):
    """Heights from beyond an end of the axis to its other end, (k,), and how far each line is above the plane, (m, k).

    The first height is beyond all cuts that there are beyond the end.
    """
    whole = spans(bending)
    z, axes = (part[:: -1 if at_end else 1] for part in whole.looked_at)
    levels = axes @ plane.across
    levels[:, 0] += plane.heights(np.zeros(3))
    sides = affine(points) @ levels.T
    outward = float(whole.outward[int(at_end)] @ plane.across)
    if abs(outward) > FLAT:
        far = max(float((-sides[:, 0] / outward).max()), 0.0) + bending.total
        z = np.insert(z, 0, z[0] + (far if at_end else -far))
        sides = np.column_stack((sides[:, 0] + far * outward, sides))
    return z, sides


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
    before, after : (m, k) float array
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
        return slice(0), starts[:, None] + share * (ends - starts)[:, None], np.empty((len(starts), 0))
    begin = np.searchsorted(stations, kept[0])
    before = kept[0] + np.outer(starts - kept[0], (upright[before] - kept[0]) / (low - kept[0]))
    after = kept[-1] + np.outer(ends - kept[-1], (upright[after] - kept[-1]) / (high - kept[-1]))
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

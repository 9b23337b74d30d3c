# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trimming: where a limiting plane cuts the lines that the points of a contour draw, and the rings up to there.

A ring whose points stand at one height of the axis is the contour itself. Towards an oblique plane rings lean, from the
contour to the cut, so that no ring is cut in two, and all faces keep four corners.
"""

from dataclasses import replace
from math import sqrt

import numpy as np

from ..declared.parameters import ShapeError
from ..grids.drawn import affine
from ..meshes.mesh import require_few
from ..stations.bending import Rings
from ..stations.spans import Fan, spans
from .cutting import followed
from .limits import Plane

ROOM = 0.5  # of the range of the cuts: how much farther in the first ring stands that does not lean
CLOSEST = 1e-3  # of the mean step: a ring nearer to another would make slivers
SHORTEST = 1e-9  # of the axis, between two planes


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
        raise ShapeError(f"must cut the solid off beyond its start everywhere, got {-left:.6g} m before it", "end")
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
    own_axes = own[:, :3].swapaxes(1, 2)
    axes = np.concatenate((own_axes[:, :first], bending.axes(stations)[:, between], own_axes[:, first:]), axis=1)
    outlines = tuple(
        outline(limit, section, lines[..., side], axes[:, side]) if isinstance(limit, Plane) else section
        for limit, side in zip(limits, (0, -1), strict=True)
    )
    u, s = (
        np.concatenate((values[:first], others[between], values[first:]))
        for values, others in ((own[0, 3], stations.u), (middles, stations.s))
    )
    return Rings(section, u, s, axes, outlines, leaning, heights, lines)


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
    low, latest, earliest, high = starts.min(), starts.max(), ends.min(), ends.max()
    close = CLOSEST * stations[-1] / len(stations)
    inner = stations[(stations > low + close) & (stations < high - close)]
    upright = np.concatenate(([low], inner, [high]))
    before = upright < latest + ROOM * (latest - low)
    after = upright > earliest - ROOM * (high - earliest)
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
    places, middle = cut[:, :3], axes[0]
    places -= plane.heights(places)[:, None] * plane.across
    x, y = axes[1:] - (axes[1:] @ plane.across)[:, None] * plane.across
    x /= sqrt(x @ x)
    y -= (y @ x) * x
    y /= sqrt(y @ y)
    return replace(section, points=(places - middle) @ np.stack((x, y), axis=1))

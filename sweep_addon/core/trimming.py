# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trimming: where a limiting plane cuts the lines that the points of a contour draw, and the rings up to there.

A ring whose points stand at one height of the axis is the contour itself. Towards an oblique plane rings lean, from the
contour to the cut, so that no ring is cut in two, and all faces keep four corners.
"""

from dataclasses import replace

import numpy as np

from .parameters import ShapeError, at, require
from .self_intersection.folds import roots
from .vectors import norms, unit

PLACES = 257  # at least, where it is looked at on which side of the plane the lines are
FARTHEST = 100.0  # lengths and reaches beyond the end, to which a solid may go on
ROOM = 0.5  # of the range of the cuts: how much farther in the first ring stands that does not lean
CLOSEST = 1e-3  # of the mean step: a ring nearer to another would make slivers
ONCE = "must cut the line of every point of the contour once"
HALVINGS = 12  # of an edge at most: what is missed falls to a quarter with each
FLAT = 1e-9  # the sine of the angle between a plane and the axis beyond its end: it is never cut there


def cuts(plane, bending, section, at_end):
    """Where a plane cuts the line of each point of a contour, coming from an end of the axis.

    Parameters
    ----------
    plane : Plane
    bending : Bending
    section : Section
    at_end : bool
        Whether that is the axis's end, and not its start.

    Returns
    -------
    (m,) float array
        Heights along the straight axis in metres; below 0 and above the total where the solid goes on straight.

    Raises
    ------
    ShapeError
        Where one of the lines is not cut, or is cut again before the plane has cut all of them.
    """
    z, sides = looked_at(plane, bending, section, at_end)
    above = sides >= 0
    change = above[:, 1:] != above[:, :-1]
    missed = ~change.any(axis=1)
    if missed.any():
        raise ShapeError(f"{ONCE}, got that of point {np.argmax(missed) + 1} not cut")
    first = change.argmax(axis=1)
    again = change[:, : first.max() + 1].sum(axis=1) > 1
    again |= above[:, 0] != above[0, 0]
    if again.any():
        raise ShapeError(f"{ONCE}, got that of point {np.argmax(again) + 1} cut again before all others are")
    found = crossings(plane, bending, section, z[first], z[first + 1])
    reach = bending.total + float(np.abs(section.points).max())
    farthest = float(np.abs(found - np.clip(found, 0.0, bending.total)).max())
    require(farthest <= FARTHEST * reach, f"must cut within {FARTHEST * reach:.6g} m of the trajectory's end", farthest)
    return found


def looked_at(plane, bending, section, at_end):
    """Heights from beyond an end of the axis to its other end, (k,), and how far each line is above the plane, (m, k).

    The first height is beyond all cuts that there are beyond the end.
    """
    z = np.linspace(0.0, bending.total, PLACES)[:: -1 if at_end else 1]
    axis = bending.axis(z)
    across = plane.across
    sides = plane.heights(axis.points) + section.points @ np.stack((axis.e2 @ across, axis.e3 @ across))
    outward = float(axis.e1[0] @ across) * (1 if at_end else -1)
    if abs(outward) > FLAT:
        far = max(float((-sides[:, 0] / outward).max()), 0.0) + bending.total
        z = np.insert(z, 0, z[0] + (far if at_end else -far))
        sides = np.column_stack((sides[:, 0] + far * outward, sides))
    return z, sides


def crossings(plane, bending, section, low, high):
    """Heights between pairs of them, (m,) and (m,), where the line of each point crosses the plane."""

    def above(z):
        return plane.heights(bending.bend(np.column_stack((section.points, z))))

    return roots(above, low, high, above(low), above(high))


def divided(section, planes, bending, tolerance):
    """A section whose edges are halved until straight lines between its points are where planes cut the surface.

    Parameters
    ----------
    section : Section
    planes : sequence of (str, Plane, bool)
        The key of each, and whether it is at the end of the axis.
    bending : Bending
    tolerance : float
        How far from the cut the middle of an edge may be, in metres.

    Returns
    -------
    Section
    """
    for _ in range(HALVINGS):
        ahead = section.following.copy()
        ahead[section.gaps] = section.gaps
        middles = (section.points + section.points[ahead]) / 2
        both, missed = replace(section, points=np.concatenate((section.points, middles))), np.zeros(len(ahead))
        for key, plane, at_end in planes:
            with at(key):
                heights = cuts(plane, bending, both, at_end)
            ends, between = np.split(bending.bend(np.column_stack((both.points, heights))), 2)
            missed = np.maximum(missed, norms(between - (ends + ends[ahead]) / 2))
        if missed.max() <= tolerance:
            break
        section = section.divided(missed > tolerance)
    return section


def ranged(stations, total, starts, ends):
    """The heights of the points of each ring, and which rings lean.

    Parameters
    ----------
    stations : (n,) float array
        Arc lengths where contours stand along the axis, both ends included.
    total : float
    starts, ends : (m,) float array
        Where the line of each point begins and ends.

    Returns
    -------
    heights : (m, k) float array
    leaning : (k,) bool array
        Rings whose heights differ.
    """
    low, high = starts.min(), ends.max()
    inner = stations[(stations > low) & (stations < high)]
    close = CLOSEST * total / len(stations)
    upright = np.concatenate(([low], inner[(inner > low + close) & (inner < high - close)], [high]))
    first, last = starts.max() + ROOM * np.ptp(starts), ends.min() - ROOM * np.ptp(ends)
    kept = upright[(upright >= first) & (upright <= last)]
    if not len(kept):
        share = (upright - low) / (high - low)
        heights = starts[:, None] + share * (ends - starts)[:, None]
        return heights, np.full(len(upright), True)
    heights = np.tile(upright, (len(starts), 1))
    before, after = upright < kept[0], upright > kept[-1]
    squeezed = (kept[0] - starts) / (kept[0] - low) if before.any() else 1.0
    heights[:, before] = kept[0] - np.outer(squeezed, kept[0] - upright[before])
    squeezed = (ends - kept[-1]) / (high - kept[-1]) if after.any() else 1.0
    heights[:, after] = kept[-1] + np.outer(squeezed, upright[after] - kept[-1])
    return heights, before | after


def limited(plane, bending, section, heights, axis, side):
    """The section in a limiting plane.

    Parameters
    ----------
    plane : Plane
    bending : Bending
    section : Section
    heights : (m,) float array
        Where the lines of its points meet the plane.
    axis : Axis
        At the rings, of which that in the plane is the first or the last: ``side`` 0 or -1.

    Returns
    -------
    outline : Section
        Seen against the direction of the axis, in metres.
    edge : (m, 3) float array
        Its points, in the plane to the last bit that rounding leaves.
    """
    edge = bending.bend(np.column_stack((section.points, heights)))
    edge -= plane.heights(edge)[:, None] * plane.across
    e2, e3, across = axis.e2[side], axis.e3[side], plane.across
    x = unit(e2 - (e2 @ across) * across)
    y = np.cross(across, x)
    y *= np.sign(y @ e3)
    return replace(section, points=(edge - axis.points[side]) @ np.stack((x, y), axis=1)), edge


def lean(vertices, bending, section, u, heights, leaning, edges):
    """Put vertices, (m, n, 3), of rings that lean, and of those that have edges known, where they belong.

    Returns
    -------
    (m, n) float array
        The trajectory's parameter at each vertex.
    """
    parameters = np.broadcast_to(u, heights.shape)
    if leaning.any():
        parameters = parameters.copy()
        own = bending.axis(heights[:, leaning].ravel())
        x, y = np.repeat(section.points, np.count_nonzero(leaning), axis=0).T[..., None]
        vertices[:, leaning] = (own.points + x * own.e2 + y * own.e3).reshape(len(heights), -1, 3)
        parameters[:, leaning] = own.u.reshape(len(heights), -1)
    for side, edge in zip((0, -1), edges, strict=True):
        if edge is not None:
            vertices[:, side] = edge
    return parameters

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves and texts of a Blender scene as trajectories and outlines.

A trajectory carries the radius and the tilt of the curve's points; the contour of a curve has neither.
"""

from contextlib import suppress
from functools import lru_cache

import bpy
import numpy as np

from ..core.contours import Mixed, Outline
from ..core.declared.parameters import ShapeError, require
from ..core.later import later
from ..core.stations.cells import bend
from ..core.stations.sampling import Tolerance, place
from ..core.trajectories import Bezier, Nurbs, Polyline
from ..core.trajectories.arc_length import arc_length

filled = later("bridge.filled")

COINCIDENT = 1e-6  # of the size: single precision keeps no less
GENTLE = np.radians(15)  # of a chord of an outline, in which a corner of more than 20 degrees is an edge


def trajectories(ob, depsgraph=None):
    """The trajectories of a curve object, one for each spline, in the object's own space.

    Parameters
    ----------
    ob : bpy.types.Object
        A curve.
    depsgraph : bpy.types.Depsgraph, optional
        Where animated values are read; without it, the object as it stands.
    """

    def read(splines):
        made = [spline_trajectory(spline, spline.use_cyclic_u) for spline in splines]
        return [trajectory for trajectory in made if trajectory]

    found = as_shown(ob, depsgraph, read)
    require(found, "must be a curve with a length", ob.name)
    return found


def contour(ob, depsgraph=None, scaled=True):
    """The contour of a curve or text object whose splines may be of mixed dimension: an outline, or a mixed one.

    Cyclic splines among others lie round areas, the others are curves, and one of a single point is a point.

    Parameters
    ----------
    ob : bpy.types.Object
    depsgraph : bpy.types.Depsgraph, optional
    scaled : bool
        Whether it is scaled as the object is.
    """
    if ob.type != "CURVE":
        return outline(ob, depsgraph, scaled)
    return or_mended(parted, ob, depsgraph, ob.scale[:2] if scaled else 1.0)


def parted(ob, depsgraph, scale):
    """The contour of a curve whose splines are areas, curves and points."""
    loops, lines, points = ([line * scale for line in found] for found in as_shown(ob, depsgraph, spline_parts))
    require(loops or lines or points, "must be a curve or text with an outline", ob.name)
    if points or loops and lines:
        return Mixed(loops, lines, np.reshape(points, (-1, 2)))
    return Outline(loops or lines, closed=bool(loops))


def outline(ob, depsgraph=None, scaled=True):
    """The outline of a curve or text object: its splines in its own xy plane, each closed by a straight line.

    The letters of a text, and their parts, may overlap, as they do in many fonts: it is the outline around all of them.

    Parameters
    ----------
    ob : bpy.types.Object
    depsgraph : bpy.types.Depsgraph, optional
    scaled : bool
        Whether it is scaled as the object is.
    """
    scale = ob.scale[:2] if scaled else 1.0
    if ob.type == "CURVE":
        return or_mended(closed, ob, depsgraph, scale)
    letters, under = as_shown(ob, depsgraph, filled.letters)
    require(letters, "must be a curve or text with an outline", ob.name)
    return filled.around_letters([path * scale for path in letters], under)


def closed(ob, depsgraph, scale):
    """The outline of a curve whose splines are closed."""
    loops = as_shown(ob, depsgraph, spline_loops)
    require(loops, "must be a curve or text with an outline", ob.name)
    return Outline([loop * scale for loop in loops])


def or_mended(read, ob, depsgraph, scale):
    """What is read of a curve; where that is refused, but its splines only cross a little, as those of drawings do that
    were imported, the outline around what they fill."""
    try:
        return read(ob, depsgraph, scale)
    except ShapeError as refusal:
        with suppress(ShapeError):  # of what cannot be mended: the first refusal is the one that says why
            return filled.mended_outline([path * scale for path in as_shown(ob, depsgraph, filled.drawn_paths)])
        raise refusal.changed(of_a_contour) from None


def of_a_contour(refusal):
    """A refusal of the trajectory that a spline is read as: whoever draws a contour knows of none."""
    return refusal.sentence, "" if refusal.key == "trajectory" else refusal.key


def as_shown(ob, depsgraph, read):
    """What is read from the splines of an object, which hooks and shape keys may have moved; of a text, its letters."""
    if ob.type == "CURVE" and not (ob.modifiers or ob.data.shape_keys):
        return read((ob.evaluated_get(depsgraph) if depsgraph else ob).data.splines)
    depsgraph = depsgraph or bpy.context.evaluated_depsgraph_get()
    evaluated = ob.evaluated_get(depsgraph)
    try:
        return read(evaluated.to_curve(depsgraph, apply_modifiers=ob.type == "CURVE").splines)
    finally:
        evaluated.to_curve_clear()


def spline_loops(splines):
    """Splines as loops of points (n, 2)."""
    return [flattened(trajectory) for trajectory in map(closed_trajectory, splines) if trajectory]


def closed_trajectory(spline):
    """A spline of an outline as a trajectory, a straight one closed; None where it has no length."""
    return spline_trajectory(spline, spline.use_cyclic_u or spline.type == "POLY")


def spline_parts(splines):
    """Splines as loops, curves and points: lists of (n, 2) and of (2,) float arrays."""
    loops, lines, points = [], [], []
    for spline in splines:
        trajectory = spline_trajectory(spline, spline.use_cyclic_u)
        if trajectory:
            (loops if trajectory.closed else lines).append(flattened(trajectory))
        else:
            held = spline.bezier_points if spline.type == "BEZIER" else spline.points
            points.append(np.array(held[0].co[:2], dtype=float))
    return loops, lines, points


@lru_cache(maxsize=256)  # while a parameter is dragged, the curve stays
def flattened(trajectory):
    """Points (n, 2) within a thousandth of a spline's size, that keep its joints and turn too little for an edge."""
    measure = arc_length(trajectory)
    size = np.ptp(trajectory.points.values, axis=0).max()

    def turning(s, u, chord):
        return np.linalg.norm(bend(trajectory, u), axis=1) / GENTLE

    tolerance = Tolerance(max(size / 1000, 1e-9))
    points = place(trajectory, tolerance, measure.at(trajectory.joints()), turning).points[:, :2].copy()
    points.flags.writeable = False
    return points


def spline_trajectory(spline, closed):
    """A spline as a trajectory; None where it has no length."""
    if spline.type == "BEZIER":
        return bezier(spline, closed)
    points = coordinates(spline.points, "co", 4)
    if spline.type == "NURBS" and is_nurbs(spline, closed):
        return nurbs(spline, points, closed)
    return polyline(spline, points[:, :3], closed)


def coordinates(points, name, width=3):
    values = np.zeros(len(points) * width, np.float32)
    points.foreach_get(name, values)
    return values.reshape(-1, width).astype(np.float64)


def carried(spline, points, kept=slice(None)):
    """The radii and tilts of the points that are kept, as a trajectory takes them; none where they say nothing."""
    radii, tilts = (coordinates(points, name, 1)[:, 0][kept] for name in ("radius", "tilt"))
    flat = spline.id_data.dimensions == "2D"  # where Blender turns nothing
    return {"radii": radii if (radii != 1).any() else (), "tilts": tilts if tilts.any() and not flat else ()}


def polyline(spline, points, closed):
    """A polyline without doubled points, which an edited curve easily has."""
    size = np.ptp(points, axis=0).max(initial=0.0)
    ahead = np.roll(points, -1, axis=0)
    doubled = np.linalg.norm(ahead - points, axis=1) <= COINCIDENT * size
    doubled[-1:] &= closed
    points = points[~doubled]
    closed = closed and len(points) > 2
    return Polyline(points, closed, **carried(spline, spline.points, ~doubled)) if len(points) > 1 else None


def bezier(spline, closed):
    """A Bezier spline without segments that have no length."""
    segments = closed_cubics(spline)
    size = np.ptp(segments[:, 0], axis=0).max(initial=0.0)
    segments = segments if closed else segments[:-1]
    moving = np.ptp(segments, axis=1).max(axis=1, initial=0.0) > COINCIDENT * size
    segments = segments[moving]
    if not len(segments):
        return None
    chain = segments[:, :3].reshape(-1, 3)
    own = carried(spline, spline.bezier_points, moving if closed else np.append(moving, True))
    return Bezier(chain if closed else np.concatenate((chain, segments[-1:, 3])), closed, **own)


def closed_cubics(spline):
    """The segments of a Bezier spline, the last of which leads back to the first point: (n, 4, 3)."""
    knots, left, right = (coordinates(spline.bezier_points, name) for name in ("co", "handle_left", "handle_right"))
    return np.stack((knots, right, np.roll(left, -1, axis=0), np.roll(knots, -1, axis=0)), axis=1)


def is_nurbs(spline, closed):
    """Whether Blender sees more in a NURBS spline than straight lines between its points."""
    size, order = len(spline.points), spline.order_u
    if spline.use_bezier_u:
        return size % (order - 1) == 0 if closed else size >= order + (not spline.use_endpoint_u)
    return size >= order


def nurbs(spline, points, closed):
    """A NURBS spline with the knots that Blender gives it."""
    if np.ptp(points[:, :3], axis=0).max() == 0:
        return None
    endpoint, bezier = spline.use_endpoint_u, spline.use_bezier_u
    usual = endpoint != closed and not bezier  # those that `Nurbs` has without being told
    knots = () if usual else spaced(len(points), spline.order_u, closed, endpoint, bezier)
    return Nurbs(points[:, :3], points[:, 3], spline.order_u, knots, closed, **carried(spline, spline.points))


def spaced(size, order, closed, endpoint, bezier):
    """The knots of a spline: whole numbers, repeated at its ends, or at each joint as in a chain of Bezier curves.

    Source: Blender's ``bke::curves::nurbs::calculate_knots``.
    """
    inner = order - 1 if bezier else 1
    head = order - closed if endpoint else min(2, inner)
    apart = int(endpoint and closed)  # one knot before those that are repeated
    count = size + (0 if closed or endpoint else order)
    place = np.arange(count - apart + 1)
    repeated = np.where(place < head, 0, 1 + (place - head) // inner) + apart
    first, period = np.concatenate((np.zeros(apart), repeated[:-1])), repeated[-1]
    turn, index = np.divmod(np.arange(size + order + (order - 1 if closed else 0)), count)
    return first[index] + turn * period

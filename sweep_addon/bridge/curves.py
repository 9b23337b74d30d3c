# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves and texts of a Blender scene as trajectories and outlines."""

import bpy
import numpy as np

from ..core.contours import Outline
from ..core.parameters import require
from ..core.sampling import Tolerance, place
from ..core.trajectories import Bezier, Nurbs, Polyline

COINCIDENT = 1e-6  # of the size: single precision keeps no less


def trajectories(ob, depsgraph=None):
    """The trajectories of a curve object, one for each spline, in the object's own space.

    Parameters
    ----------
    ob : bpy.types.Object
        A curve.
    depsgraph : bpy.types.Depsgraph, optional
        Where animated values are read; without it, the object as it stands.
    """
    curve = (ob.evaluated_get(depsgraph) if depsgraph else ob).data
    found = [spline_trajectory(spline, spline.use_cyclic_u) for spline in curve.splines]
    found = [trajectory for trajectory in found if trajectory]
    require(found, "must be a curve with a length", ob.name)
    return found


def outline(ob, depsgraph=None):
    """The outline of a curve or text object: its splines in its own xy plane, scaled as the object is.

    A spline that is not cyclic is closed by a straight line.
    """
    if ob.type == "FONT":
        depsgraph = depsgraph or bpy.context.evaluated_depsgraph_get()
        evaluated = ob.evaluated_get(depsgraph)
        loops = spline_loops(evaluated.to_curve(depsgraph).splines)
        evaluated.to_curve_clear()
    else:
        loops = spline_loops((ob.evaluated_get(depsgraph) if depsgraph else ob).data.splines)
    require(loops, "must be a curve or text with an outline", ob.name)
    return Outline([loop * ob.scale[:2] for loop in loops])


def spline_loops(splines):
    """Splines as closed loops of points (n, 2), curves flattened to a thousandth of the size of all."""
    made = [spline_trajectory(spline, spline.use_cyclic_u or spline.type == "POLY") for spline in splines]
    made = [trajectory for trajectory in made if trajectory]
    if not made:
        return []
    size = np.ptp(np.concatenate([trajectory.points.values for trajectory in made]), axis=0).max()
    return [place(trajectory, Tolerance(max(size / 1000, 1e-9))).points[:, :2] for trajectory in made]


def spline_trajectory(spline, closed):
    """A spline as a trajectory; None where it has no length."""
    if spline.type == "BEZIER":
        return bezier(spline, closed)
    points = coordinates(spline.points, "co", 4)
    if spline.type == "NURBS" and len(points) >= spline.order_u:
        return nurbs(spline, points, closed)
    return polyline(points[:, :3], closed)


def coordinates(points, name, width=3):
    values = np.zeros(len(points) * width, np.float32)
    points.foreach_get(name, values)
    return values.reshape(-1, width).astype(np.float64)


def polyline(points, closed):
    """A polyline without doubled points, which an edited curve easily has."""
    size = np.ptp(points, axis=0).max(initial=0.0)
    ahead = np.roll(points, -1, axis=0)
    doubled = np.linalg.norm(ahead - points, axis=1) <= COINCIDENT * size
    doubled[-1:] &= closed
    points = points[~doubled]
    closed = closed and len(points) > 2
    return Polyline(points, closed) if len(points) > 1 else None


def bezier(spline, closed):
    """A Bezier spline without segments that have no length."""
    knots, left, right = (coordinates(spline.bezier_points, name) for name in ("co", "handle_left", "handle_right"))
    segments = np.stack((knots, right, np.roll(left, -1, axis=0), np.roll(knots, -1, axis=0)), axis=1)
    segments = segments if closed else segments[:-1]
    size = np.ptp(knots, axis=0).max(initial=0.0)
    segments = segments[np.ptp(segments, axis=1).max(axis=1, initial=0.0) > COINCIDENT * size]
    if not len(segments):
        return None
    chain = segments[:, :3].reshape(-1, 3)
    return Bezier(chain if closed else np.concatenate((chain, segments[-1:, 3])), closed)


def nurbs(spline, points, closed):
    """A NURBS spline with the knots that Blender gives it."""
    size, order = len(points), spline.order_u
    knots = ()
    if not closed and not spline.use_endpoint_u:
        knots = np.arange(size + order)
    if np.ptp(points[:, :3], axis=0).max() == 0:
        return None
    return Nurbs(points[:, :3], points[:, 3], order, knots, closed)


def from_trajectory(trajectory, name):
    """A Blender curve of a trajectory: a cubic through its stations, or a polyline's own corners."""
    curve = bpy.data.curves.new(name, "CURVE")
    curve.dimensions = "3D"
    if isinstance(trajectory, Polyline):
        spline = new_poly(curve, trajectory.points.values)
    else:
        spline = curve.splines.new("BEZIER")
        chain = trajectory if isinstance(trajectory, Bezier) else through(trajectory)
        set_bezier(spline, chain)
    spline.use_cyclic_u = trajectory.closed
    return curve


def through(trajectory):
    """A chain of cubics through stations of a trajectory, with its tangents: a step of 1/8 radian, fourth order."""
    stations = place(trajectory, Tolerance(trajectory.length() / 1000))
    onward, here = stations.onward, np.arange(len(stations.onward))
    step = np.diff(np.append(stations.s, stations.total))[: len(onward), None] / 3
    out = stations.points[here] + step * stations.leave[here]
    back = stations.points[onward] - step * stations.arrive[onward]
    chain = np.stack((stations.points[here], out, back), axis=1).reshape(-1, 3)
    return Bezier(chain if stations.closed else np.concatenate((chain, stations.points[-1:])), stations.closed)


def set_bezier(spline, chain):
    """The knots and handles of a chain as a spline; an open chain's outer handles mirror the inner ones."""
    points = chain.points.values
    if chain.closed:
        rows = np.concatenate((points[-1:], points[:-1])).reshape(-1, 3, 3)
    else:
        rows = np.concatenate((2 * points[:1] - points[1:2], points, 2 * points[-1:] - points[-2:-1])).reshape(-1, 3, 3)
    spline.bezier_points.add(len(rows) - 1)
    for i, name in enumerate(("handle_left", "co", "handle_right")):
        spline.bezier_points.foreach_set(name, rows[:, i].ravel())


def new_poly(curve, points):
    spline = curve.splines.new("POLY")
    spline.points.add(len(points) - 1)
    columns = np.zeros((len(points), 4))
    columns[:, : points.shape[1]], columns[:, 3] = points, 1.0
    spline.points.foreach_set("co", columns.ravel())
    return spline


def from_contour(contour, name):
    """A flat Blender curve of a contour, a cyclic polyline for each loop."""
    curve = bpy.data.curves.new(name, "CURVE")
    curve.dimensions = "2D"
    section = contour.section()
    for start, end in zip(section.offsets[:-1], section.offsets[1:], strict=True):
        new_poly(curve, section.points[start:end]).use_cyclic_u = True
    return curve

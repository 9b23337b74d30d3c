# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender curves drawn of trajectories and contours: what `curves` reads them back from."""

import bpy
import numpy as np

from ..core.contours import Fit, all_fitted
from ..core.stations.sampling import Tolerance, place
from ..core.trajectories import Bezier, Polyline
from ..core.trajectories.arc_length import arc_length, subdivided


def from_trajectory(trajectory, name):
    """A Blender curve of a trajectory: a cubic through its stations, or a polyline's own corners."""
    curve = bpy.data.curves.new(name, "CURVE")
    curve.dimensions = "3D"
    if isinstance(trajectory, Polyline):
        spline = new_poly(curve, trajectory.points.values)
        carry(spline.points, trajectory)
    else:
        spline = curve.splines.new("BEZIER")
        chain = trajectory if isinstance(trajectory, Bezier) else through(trajectory)
        set_bezier(spline, chain)
        carry(spline.bezier_points, chain)
    spline.use_cyclic_u = trajectory.closed
    return curve


def from_axes(points, radii, offsets, name):
    """A Blender curve of poly-lines, each a spline whose bevel is as thick as the radii of its points say."""
    curve = bpy.data.curves.new(name, "CURVE")
    curve.dimensions, curve.bevel_depth, curve.use_fill_caps = "3D", 1.0, True
    for start, end in zip(offsets[:-1].tolist(), offsets[1:].tolist(), strict=True):
        new_poly(curve, points[start:end]).points.foreach_set("radius", radii[start:end])
    return curve


def carry(points, trajectory):
    """Write the radii and tilts of a trajectory on the points of its spline."""
    for name, given in (("radius", trajectory.radii), ("tilt", trajectory.tilts)):
        if len(given):
            points.foreach_set(name, given.values)


def through(trajectory):
    """A chain of cubics through stations of a trajectory, with its tangents: a step of 1/8 radian, fourth order.

    What the trajectory carries they have at each of its points and at quarters between them.
    """
    marks = arc_length(trajectory).at(subdivided(trajectory.joints(), 4)) if trajectory.carries else ()
    stations = place(trajectory, Tolerance(trajectory.length() / 1000), marks)
    starts, onward, step = stations.starts, stations.onward, stations.lengths[:, None] / 3
    out = stations.points[starts] + step * stations.leave[starts]
    back = stations.points[onward] - step * stations.arrive[onward]
    chain = np.stack((stations.points[starts], out, back), axis=1).reshape(-1, 3)
    chain = chain if stations.closed else np.concatenate((chain, stations.points[-1:]))
    own = trajectory.carried(stations.u) if trajectory.carries else ()
    return Bezier(chain, stations.closed, *own)


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
    """A flat Blender curve of a contour, a polyline for each loop, which is cyclic, and for each open line."""
    curve = bpy.data.curves.new(name, "CURVE")
    curve.dimensions = "2D"
    for section in all_fitted(contour, Fit.INSCRIBED):
        for points in np.split(section.points, section.offsets[1:-1]):
            new_poly(curve, points).use_cyclic_u = section.closed
    return curve

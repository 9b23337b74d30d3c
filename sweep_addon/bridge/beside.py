# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects beside a trajectory that say where its contours point and what limits them, read in its space.

A curve is a rail, or the guide to which they point. Empties are arrows along their own z axes: one stands for itself
and for the empties that are parented to it. As a limit an empty is a plane across its z axis.
"""

from dataclasses import replace

import numpy as np

from ..core.declared.parameters import ShapeError
from ..core.rings.limits import Plane
from ..core.stations.bending import Bending
from ..core.stations.directions import Arrows, Cubic, Guide
from ..core.stations.pd_curve import joined
from ..core.trajectories import Bezier, Polyline
from ..core.trajectories.arc_length import arc_length
from . import curves
from .drawn_curves import through

SEGMENTS = 16  # at least, of a guide that is made
THIRDS = np.array([[1], [2], [3]]) / 3


def value(ob, p, trajectory, path, number, depsgraph):
    """The direction, the plane or the rail that an object stands for.

    Parameters
    ----------
    ob : bpy.types.Object
        A curve or an empty.
    p : Parameter
        Its kinds say which of them is asked for.
    trajectory : bpy.types.Object or None
        The trajectory, in whose space the value is.
    path : Trajectory
        What it was read as.
    number : int
        Which of its splines that is.
    depsgraph : bpy.types.Depsgraph or None
    """
    if trajectory is None:
        raise ShapeError("must not be an object where the trajectory is none: press Edit Trajectory first")
    into = np.linalg.inv(world(trajectory, depsgraph))
    if Plane in p.kinds:
        place = into @ world(ob, depsgraph)
        return Plane(place[:3, 3].tolist(), place[:3, 2].tolist())
    if ob.type == "CURVE":
        splines = curves.trajectories(ob, depsgraph)
        spline = splines[number] if number < len(splines) else splines[0]
        place = into @ world(ob, depsgraph)
        if Bezier in p.kinds:
            return replace(spline, points=spline.points.values @ place[:3, :3].T + place[:3, 3])
        return Guide(chain(spline) @ place[:3, :3].T + place[:3, 3])
    arrows = [ob, *(child for child in ob.original.children if child.type == "EMPTY")]
    places = np.array([into @ world(arrow, depsgraph) for arrow in arrows])
    return Arrows.at_points(path, places[:, :3, 3], places[:, :3, 2])


def guide(shape):
    """A second curve to which the contour of a shape points as it does now, as far beside the path as it is large.

    Of a PD curve told by Bezier points it has as many segments and is exact; else it is a chain of cubics through
    places evenly spaced in the parameter of the curve that is drawn for the path, so that both have the same one.
    """
    path, told = shape.trajectory, shape.direction
    away = 2 * float(np.linalg.norm(shape.contour.section().points, axis=1).max())
    if isinstance(path, Bezier) and isinstance(told, Cubic) and not path.closed:
        vectors = told.basis.segments(told.values.values)
        if len(vectors) == len(path.segments):
            return Bezier(joined(path.segments + vectors * (away / np.abs(vectors).max())))
    total, drawn = arc_length(path).total, path if isinstance(path, (Bezier, Polyline)) else through(path)
    u = np.linspace(*drawn.domain, 1 + max(SEGMENTS, 2 * len(drawn.joints())))
    h, measure = (u[1] - u[0]) / 100, arc_length(drawn)

    def beside(u):
        axis = Bending(path, told, total).axis(measure.at(u) * (total / measure.total))
        return axis.points + away * axis.e2

    low, high = np.maximum(u - h, u[0]), np.minimum(u + h, u[-1])
    third = (beside(high) - beside(low)) / (high - low)[:, None] * (u[1] - u[0]) / 3
    places = beside(u)
    segments = np.stack((places[:-1], places[:-1] + third[:-1], places[1:] - third[1:], places[1:]), axis=1)
    points = joined(segments)
    return Bezier(points[:-1], True) if path.closed else Bezier(points)


def world(ob, depsgraph):
    """Where an object is: a (4, 4) float array."""
    return np.array((ob.evaluated_get(depsgraph) if depsgraph else ob).matrix_world)


def chain(path):
    """The knots and handles of a trajectory, or of a chain that goes where it goes, from start to end: (n, 3)."""
    if isinstance(path, Polyline):
        legs = np.concatenate((path.points.values, path.points[:1])) if path.closed else path.points.values
        return np.concatenate((legs[:1], (legs[:-1, None] + np.diff(legs, axis=0)[:, None] * THIRDS).reshape(-1, 3)))
    chained = path if isinstance(path, Bezier) else through(path)
    points = chained.points.values
    return np.concatenate((points, points[:1])) if chained.closed else points

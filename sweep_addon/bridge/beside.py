# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects beside a trajectory that say where its contours point and what limits them, read in its space.

A curve is the guide to which they point. Empties are arrows along their own z axes: one stands for itself and for the
empties that are parented to it. As a limit an empty is a plane across its z axis.
"""

import numpy as np

from ..core.directions import Arrows, Guide
from ..core.limits import Plane
from ..core.parameters import ShapeError
from ..core.trajectories import Bezier, Polyline
from . import curves

THIRDS = np.array([[1], [2], [3]]) / 3


def value(ob, p, trajectory, path, number, depsgraph):
    """The direction or the plane that an object stands for.

    Parameters
    ----------
    ob : bpy.types.Object
        A curve or an empty.
    p : Parameter
        Its kinds say whether a plane or a direction is asked for.
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
        guide = chain(splines[number] if number < len(splines) else splines[0])
        place = into @ world(ob, depsgraph)
        return Guide(guide @ place[:3, :3].T + place[:3, 3])
    arrows = [ob, *(child for child in ob.original.children if child.type == "EMPTY")]
    places = np.array([into @ world(arrow, depsgraph) for arrow in arrows])
    return Arrows.at_points(path, places[:, :3, 3], places[:, :3, 2])


def world(ob, depsgraph):
    """Where an object is: a (4, 4) float array."""
    return np.array((ob.evaluated_get(depsgraph) if depsgraph else ob).matrix_world)


def chain(path):
    """The knots and handles of a trajectory, or of a chain that goes where it goes, from start to end: (n, 3)."""
    if isinstance(path, Polyline):
        legs = np.concatenate((path.points.values, path.points[:1])) if path.closed else path.points.values
        return np.concatenate((legs[:1], (legs[:-1, None] + np.diff(legs, axis=0)[:, None] * THIRDS).reshape(-1, 3)))
    chained = path if isinstance(path, Bezier) else curves.through(path)
    points = chained.points.values
    return np.concatenate((points, points[:1])) if chained.closed else points

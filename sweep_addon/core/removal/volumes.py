# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a body visits on a path: exact solids of straight legs, and sweeps of legs that turn."""

from dataclasses import replace

import numpy as np

from ..csg import Placed, RigidMotion, SweptSolid
from ..meshes import booleans
from ..solids import Triangles
from ..trajectories import Arc, Line
from ..vectors import cross, norms
from .legs import poses

CELLS = 48  # across the mesh of a leg that turns
ROUNDING = 1e-12  # of the size of a body: where coordinates differ by less, they are meant to be the same
UPRIGHT = 1e-9  # the sine to the way of faces along it, which may be a thousandth of the body's size


def swept(body, legs):
    """All points that a body visits on legs: for each that does not turn a solid of triangles, for others a sweep."""
    made = [swept_leg(body, leg, pose) for leg, pose in zip(legs, poses(legs)[:-1], strict=True)]
    whole = made[0]
    for other in made[1:]:
        whole = whole | other
    return whole


def swept_leg(body, leg, pose):
    """What a body visits on a leg from a pose; where it turns, a sweep of triangles that is placed there."""
    vertices = pose.of(body.vertices)
    if not leg.turns:
        return Triangles.of(translated(vertices, body.triangles, leg.way))
    # seen from the axis, which is z, a point of it the origin
    axes = about(leg.axis)
    seen, way = (vertices - leg.pivot) @ axes, leg.way @ axes
    if leg.carried:
        motion = RigidMotion(Line(end=tuple(way)), turn_z=f"{leg.angle!r}*t")
    else:  # no trajectory is a point: one that runs around the axis, and what is turned stands on it
        radius = max(float(norms(seen[:, :2]).max()), 1e-9)
        seen = seen - (radius, 0.0, 0.0)
        motion = RigidMotion(Arc(radius, leg.angle), turn_z=f"{leg.angle!r}*t")
    return Placed(SweptSolid(Triangles(seen, body.triangles), motion, CELLS), np.column_stack((axes, leg.pivot)))


def translated(vertices, triangles, way):
    """The mesh of what a body visits on a straight way: the body, and the prisms of all faces that lead.

    What leaves the body leaves it through one of these. It is made where the way is z and what stands upright but for
    rounding does so: prisms as thin as rounding, and walls that meet but for it, are what unions get wrong.
    """
    length = float(norms(way[None])[0])
    axes = about(way / length)
    seen = welded(vertices @ axes)
    ahead = [np.concatenate((corners, corners + (0.0, 0.0, length))) for corners in leading(seen[triangles])]
    made = booleans.mesh_of(booleans.united([booleans.body(seen, triangles), *map(booleans.hull_body, ahead)]))
    return replace(made, vertices=made.vertices @ axes.T)


def welded(points):
    """Points (n, 3) whose coordinates are the same wherever these differ by rounding alone."""
    return np.stack([evened(each, ROUNDING * np.ptp(points)) for each in points.T], axis=1)


def evened(values, least):
    """Numbers (n,), of which those that follow on each other by no more than the least are the first of these."""
    order = np.argsort(values)
    rising = values[order]
    starts = np.concatenate(([True], np.diff(rising) > least))
    made = np.empty_like(values)
    made[order] = rising[starts][np.cumsum(starts) - 1]
    return made


def leading(corners):
    """Those triangles (t, 3, 3) that look up by more than rounding."""
    normals = cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return corners[normals[:, 2] > UPRIGHT * norms(normals)]


def about(axis):
    """A right-handed frame whose third column is a unit axis (3,)."""
    other = np.eye(3)[np.abs(axis).argmin()]
    first = cross(other[None], axis[None])[0]
    first = first / norms(first)
    return np.column_stack((first, cross(axis[None], first[None])[0], axis))

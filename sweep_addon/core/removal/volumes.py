# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a body visits on a path: exact solids of straight legs, and sweeps of legs that turn."""

import numpy as np

from ..csg import Placed, RigidMotion, SweptSolid
from ..meshes import booleans
from ..solids import Triangles
from ..trajectories import Arc, Line
from ..vectors import cross, dot, norms
from .legs import poses

CELLS = 48  # across the mesh of a leg, where any turns


def swept(body, legs):
    """All points that a body visits on legs: a solid of triangles if none of them turns, else a tree of sweeps."""
    if not any(leg.turns for leg in legs):
        return Triangles.of(translated(body, legs))
    made = [swept_leg(body, leg, pose) for leg, pose in zip(legs, poses(legs)[:-1], strict=True)]
    whole = made[0]
    for other in made[1:]:
        whole = whole | other
    return whole


def translated(body, legs):
    """The mesh of what a body visits on straight legs: the body at all ends, and the prisms of all faces that lead."""
    bodies = []
    for leg, pose in zip(legs, poses(legs)[:-1], strict=True):
        vertices = pose.of(body.vertices)
        bodies += [booleans.body(vertices, body.triangles), *leading(vertices[body.triangles], leg.way)]
    bodies.append(booleans.body(poses(legs)[-1].of(body.vertices), body.triangles))
    return booleans.mesh_of(booleans.united(bodies))


def leading(corners, way):
    """The prisms of those triangles (t, 3, 3) that look ahead: what leaves a body leaves it through one of these."""
    normals = cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    ahead = corners[dot(normals, np.broadcast_to(way, normals.shape)) > 0]
    return [booleans.hull_body(np.concatenate((corner, corner + way))) for corner in ahead]


def swept_leg(body, leg, pose):
    """The sweep of a body on a leg from a pose, as a sweep of triangles that is placed there."""
    vertices = pose.of(body.vertices)
    if not leg.turns:
        return SweptSolid(Triangles(vertices, body.triangles), Line(end=tuple(leg.way)), cells=CELLS)
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


def about(axis):
    """A right-handed frame whose third column is a unit axis (3,)."""
    other = np.eye(3)[np.abs(axis).argmin()]
    first = cross(other[None], axis[None])[0]
    first = first / norms(first)
    return np.column_stack((first, cross(axis[None], first[None])[0], axis))

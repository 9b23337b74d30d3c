# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Certificates: that a body touches nothing on a leg, at no moment, and by how much it is clear at least.

Nothing is concluded from samples. What a triangle visits on a straight line is a prism: the surfaces around are out of
it if they cross none of its faces and none of them lies inside. On a leg that turns, where the body is clear by so much
it can go on for as long as its fastest point takes for that.
"""

import numpy as np

from ..vectors import cross, dot
from .touching import Moving

SPARE = 0.25  # of the clearance is kept of a step: the least of these is proven
MOST = 60_000  # steps of a leg: one that takes more is not certified
RAYS = 2_000_000  # pairs of points and triangles at once
ROUNDING = 1e-12  # of the coordinates


def clearance(moving, around, leg, pose):
    """How far a body stays from all surfaces around on the whole of a leg, at least.

    Parameters
    ----------
    moving : Moving
        The body.
    around : Surroundings
    leg : Leg
    pose : Pose
        In which it begins.

    Returns
    -------
    float
        In metres: exact on a straight leg, a bound from below on one that turns; 0 where the body may touch something.

    Source
    ------
    Mirtich: Impulse-based dynamic simulation of rigid body systems, 1996, conservative advancement.
    """
    return (turning if leg.turns else straight)(moving, around, leg, pose)


def straight(moving, around, leg, pose):
    """The clearance on a straight leg: of the prisms of all triangles, their faces and what is inside of these."""
    vertices = pose.of(moving.vertices)
    swept = Moving(*prisms(vertices, moving.triangles, leg.way))
    found = around.clearance(swept.object)
    least = ROUNDING * max(float(np.abs(body.vertices).max()) for body in (moving, *around.bodies))
    if found <= least or any(passed_over(body, vertices[moving.triangles], leg.way) for body in around.bodies):
        return 0.0
    return found


def prisms(vertices, triangles, way):
    """The faces of the prisms that triangles visit: at both ends, and what their edges visit. Vertices, triangles."""
    edges = np.concatenate((triangles[:, :2], triangles[:, 1:], triangles[:, ::2]))
    edges = np.unique(np.sort(edges, axis=1), axis=0)
    there = edges + len(vertices)
    sides = np.concatenate((np.column_stack((edges, there[:, 0])), np.column_stack((edges[:, 1], there[:, ::-1]))))
    return np.concatenate((vertices, vertices + way)), np.concatenate((triangles, triangles + len(vertices), sides))


def passed_over(body, corners, way):
    """Whether a surface of a body may lie within what triangles (t, 3, 3) visit: one point of each surface tells."""
    points = body.vertices[np.unique(body.shells)]
    together = max(RAYS // len(corners), 1)
    return any(hit(points[start : start + together], corners, -way) for start in range(0, len(points), together))


def hit(points, corners, way):
    """Whether the way of any of points (n, 3) meets any of triangles (t, 3, 3); a graze counts.

    Source
    ------
    Moeller, Trumbore: Fast, minimum storage ray-triangle intersection, 1997.
    """
    origin, first, second = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    across = cross(np.broadcast_to(way, second.shape), second)
    volume = dot(first, across)
    level = np.abs(volume) <= ROUNDING * np.abs(across).max(initial=0.0)
    scale = 1.0 / np.where(level, 1.0, volume)
    away = points[:, None] - origin
    u = np.einsum("ntk,tk->nt", away, across) * scale
    turned = cross(away, np.broadcast_to(first, away.shape))
    v, t = (turned @ way) * scale, np.einsum("ntk,tk->nt", turned, second) * scale
    near = (np.minimum(u, v) >= -ROUNDING) & (u + v <= 1 + ROUNDING) & (t >= -ROUNDING) & (t <= 1 + ROUNDING)
    return bool((near & ~level).any())


def turning(moving, around, leg, pose):
    """A bound of the clearance on a leg that turns, by conservative advancement."""
    speed = leg.speed(pose.of(moving.vertices))
    part, least = 0.0, np.inf
    for _ in range(MOST):
        here = around.clearance(moving.at(leg.pose(part).after(pose)))
        least = min(least, SPARE * here)
        step = (1 - SPARE) * here / speed
        if part + step <= part:  # so near that it does not get on
            return 0.0
        part += step
        if part >= 1.0:
            return least
    return 0.0

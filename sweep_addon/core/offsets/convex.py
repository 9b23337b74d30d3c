# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The offset of a convex solid: the hull of its faces moved out, arcs around its edges and domes on its vertices."""

import numpy as np

from ..meshes.booleans import arrays, body, hull_body
from ..meshes.components import components
from ..vectors import cross, dot, norms, unit
from .sphere import spread

ROUNDING = 1e-9  # of the size: what a corner may stick out of the plane of a face beside it
DIGITS = 12  # of planes: those that differ in none are one
NEAR = 0.71  # of a step: no direction of a dome is farther from one of its places, nor of a vertex that has one place
SPECK = 1e-15  # of the solid's volume: less is rounding of what has gone
AT_ONCE = 2**16  # products of directions and vertices: so few stay in a cache, and OpenBLAS takes one thread


def convex_offset(vertices, triangles, radius, step):
    """The surface at a distance from a convex solid, outside.

    Parameters
    ----------
    vertices : (n, 3) float array
        In metres.
    triangles : (f, 3) int array
        Counter-clockwise from outside.
    radius : float
        In metres.
    step : float
        The largest angle between neighbours on arcs and domes, in radians.

    Returns
    -------
    vertices, triangles
        All vertices are at that distance, up to rounding.

    The volume is right to the second order of the step, and never larger than it should be.
    """
    corners = vertices[triangles]
    normals = unit(cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
    means, least = around_vertices(vertices, triangles, normals)
    smooth = least >= np.cos(NEAR * step)  # one place stands for all of its faces: hulls take time by their points
    flat = (corners + radius * normals[:, None])[~smooth[triangles]]
    points = (
        vertices[smooth] + radius * means[smooth],
        flat,
        arcs(vertices, triangles, normals, radius, step, smooth),
        domes(vertices, radius, step, smooth) if (least < np.cos(step)).any() else flat[:0],
    )
    return arrays(hull_body(np.concatenate(points)))[:2]


def convex_inset(vertices, triangles, radius):
    """What of a convex solid is farther than a radius from its surface: between its faces moved inwards.

    Returns
    -------
    vertices, triangles
        Exact up to rounding; empty where nothing is left.
    """
    corners = vertices[triangles]
    normals = unit(cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
    planes = np.column_stack((normals, dot(corners[:, 0], normals)))
    _, first = np.unique(planes.round(DIGITS), axis=0, return_index=True)
    left = body(vertices, triangles)
    for *normal, height in planes[first]:
        left = left.trim_by_plane([-x for x in normal], radius - height)
    if left.volume() <= SPECK * body(vertices, triangles).volume():
        return np.zeros((0, 3)), np.zeros((0, 3), dtype=int)
    return arrays(left)[:2]


def is_convex(vertices, triangles):
    """Whether a closed mesh bounds one convex solid: it is of one piece like a ball, and no edge is hollow."""
    edges = shared_edges(triangles)
    used = np.unique(triangles)
    if len(used) - len(edges) + len(triangles) != 2 or np.ptp(components(len(vertices), edges[:, :2])[used]):
        return False
    corners = vertices[triangles]
    normals = unit(cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
    opposite = vertices[triangles[edges[:, 3]].sum(axis=1) - edges[:, 0] - edges[:, 1]]
    height = dot(opposite - vertices[edges[:, 0]], normals[edges[:, 2]])
    return bool((height <= ROUNDING * np.ptp(vertices, axis=0).max()).all())


def shared_edges(triangles):
    """Both ends of each edge of a closed mesh, and the triangles to its left and to its right: (e, 4) int array.

    Edges rise by their ends, and each runs from its lower end.
    """
    start, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    face = np.repeat(np.arange(len(triangles)), 3)
    size = int(triangles.max()) + 1
    keys = (np.minimum(start, end).astype(np.int64) * size + np.maximum(start, end)) * 2 + (start > end)
    left, right = np.argsort(keys).reshape(-1, 2).T
    return np.stack((start[left], end[left], face[left], face[right]), axis=1)


def around_vertices(vertices, triangles, normals):
    """The mean normal of each vertex, and the least cosine of a normal around it to that: (n, 3), (n,)."""
    corner, face = triangles.ravel(), np.repeat(np.arange(len(triangles)), 3)
    means = unit(np.stack([np.bincount(corner, part[face], len(vertices)) for part in normals.T], axis=1))
    least = np.ones(len(vertices))
    np.minimum.at(least, corner, dot(normals[face], means[corner]))
    return means, np.where(means.any(axis=1), least, -1.0)


def arcs(vertices, triangles, normals, radius, step, smooth):
    """Places around the ends of each edge that are not smooth, between the normals of its faces, alike at both ends."""
    start, end, left, right = shared_edges(triangles).T
    a, b = normals[left], normals[right]
    angle = np.arctan2(norms(cross(a, b)), dot(a, b))
    count = np.maximum(np.ceil(angle / step).astype(int) - 1, 0)
    edge = np.repeat(np.arange(len(count)), count)
    part = (np.arange(len(edge)) - np.repeat(np.cumsum(count) - count, count) + 1) / (count[edge] + 1)
    whole = angle[edge]
    weights = np.sin((1 - part) * whole) / np.sin(whole), np.sin(part * whole) / np.sin(whole)
    directions = radius * (weights[0][:, None] * a[edge] + weights[1][:, None] * b[edge])
    ends = [(vertices[each[edge]] + directions)[~smooth[each[edge]]] for each in (start, end)]
    return np.concatenate(ends)


def domes(vertices, radius, step, smooth):
    """Places around vertices that are not smooth: in directions spread over the sphere, each from the farthest one."""
    directions = spread(step)
    chunks = np.array_split(directions, len(directions) * len(vertices) // AT_ONCE + 1)
    farthest = np.concatenate([(chunk @ vertices.T).argmax(axis=1) for chunk in chunks])
    return (vertices[farthest] + radius * directions)[~smooth[farthest]]

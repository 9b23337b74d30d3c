# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Facets: the triangles into which the faces of a mesh are cut, whatever their form."""

import numpy as np

from ..vectors import dot
from .triangulate import triangulate

BENT = 1e-3  # of a face's size: how far its diagonals are from each other if it is bent


def facets(mesh):
    """The triangles of a mesh.

    Parameters
    ----------
    mesh : Mesh

    Returns
    -------
    triangles : (t, 3) int32 array
        The vertices of each, counter-clockwise from outside.
    face : (t,) int array
        The face that each is a part of.

    A face of four corners is cut along the diagonal that leaves both halves its own side, the shorter one of two; a
    larger one in fans if it is convex, and else by its ears.

    Examples
    --------
    >>> from sweep_addon.core.contours import Star
    >>> from sweep_addon.core.shapes.translational_sweep import TranslationalSweep
    >>> triangles, face = facets(TranslationalSweep(Star(points=5)).mesh())
    >>> len(triangles), np.bincount(face).tolist()
    (36, [2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 8, 8])
    """
    sizes, start = np.diff(mesh.offsets), mesh.offsets[:-1].copy()
    start[sizes == 4] += over_the_other(mesh, start[sizes == 4])
    bent = np.flatnonzero(~convex(mesh, sizes))
    sizes[bent] = 2  # no fan: their ears are cut instead
    face = np.repeat(np.arange(len(sizes)), sizes - 2)
    step = np.arange(len(face)) - np.repeat(np.cumsum(sizes - 2) - (sizes - 2), sizes - 2)
    first, end = mesh.offsets[face], mesh.offsets[face + 1]
    turn = np.stack((0 * step, step + 1, step + 2), axis=1) + start[face, None]
    fans = mesh.corners[np.where(turn >= end[:, None], turn - (end - first)[:, None], turn)]
    ears = [eared(mesh, number) for number in bent.tolist()]
    triangles = np.concatenate([fans, *ears])
    return triangles, np.concatenate((face, np.repeat(bent, [len(found) for found in ears])))


def bent_facets(mesh):
    """The triangles of a mesh, of bent faces of four corners four each, about a vertex in their middle.

    Parameters
    ----------
    mesh : Mesh

    Returns
    -------
    vertices : (n, 3) float array
        Those of the mesh, and these middles.
    triangles : (t, 3) int array
        Counter-clockwise from outside.

    Four hold as much as the bilinear patch through the corners, and are four times as near to it as two. On a twisted
    bar the shorter diagonals are all outside: cut along these it is too thick everywhere.

    Examples
    --------
    >>> from sweep_addon.core.contours import Rectangle
    >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
    >>> mesh = GeneralizedCylinder(Rectangle(1.0, 1.0), twist="t").mesh()
    >>> vertices, triangles = bent_facets(mesh)
    >>> a, b, c = vertices[triangles].swapaxes(0, 1)
    >>> bool(np.isclose(dot(np.cross(a, b), c).sum() / 6, mesh.volume(), rtol=1e-12))
    True
    """
    return cut(mesh)[:2]


def cut(mesh):
    """Those vertices and triangles, and the face that each is a part of: (n, 3), (t, 3) and (t,) arrays."""
    triangles, face = facets(mesh)
    bent, corners, _ = bent_faces(mesh.vertices, mesh.corners, mesh.offsets)
    if not len(bent):
        return mesh.vertices, triangles, face
    middle = np.broadcast_to(len(mesh.vertices) + np.arange(len(corners))[:, None], corners.shape)
    fans = np.stack((corners, np.roll(corners, -1, axis=1), middle), axis=-1).reshape(-1, 3)
    vertices = np.concatenate((mesh.vertices, mesh.vertices[corners].mean(axis=1)))
    flat = ~np.isin(face, bent)
    return vertices, np.concatenate((triangles[flat], fans)), np.concatenate((face[flat], np.repeat(bent, 4)))


def bent_faces(vertices, corners, offsets):
    """The bent ones among faces, of those of four corners.

    Parameters
    ----------
    vertices : (n, 3) float array
    corners : (c,) int array
    offsets : (f + 1,) int array
        As those of a `Mesh`.

    Returns
    -------
    numbers : (k,) int array
    corners : (k, 4) int array
        Their vertices.
    bulge : (k,) float array
        The volume between the two ways to cut each along a diagonal in cubic metres, positive where the one from its
        second corner to its last is outside.
    """
    four = np.flatnonzero(np.diff(offsets) == 4)
    corners = corners[offsets[four, None] + np.arange(4)]
    a, b, c, d = vertices[corners].swapaxes(0, 1)
    across = np.cross(c - a, d - b)
    rise = dot(b - a, across)
    bent = np.abs(rise) > BENT * dot(across, across) ** 0.75
    return four[bent], corners[bent], rise[bent] / 6


def over_the_other(mesh, start):
    """1 for each face of four corners that is to be cut from its second corner to its last, else 0."""
    a, b, c, d = (mesh.vertices[mesh.corners[start + i]] for i in range(4))
    one, other = sound(a, b, c, d), sound(b, c, d, a)
    shorter = dot(d - b, d - b) < dot(c - a, c - a)
    return (np.where(one == other, shorter, other)).astype(mesh.offsets.dtype)


def sound(a, b, c, d):
    """Whether both triangles of the diagonal from a to c look where the face a, b, c, d does: (n,) bool array."""
    normal = np.cross(c - a, d - b)
    halves = np.cross(b - a, c - a), np.cross(c - a, d - a)
    return (dot(halves[0], normal) > 0) & (dot(halves[1], normal) > 0)


def convex(mesh, sizes):
    """Which faces may be cut in fans: those of up to four corners, and those that turn left at every corner."""
    large = np.repeat(sizes > 4, sizes)
    if not large.any():
        return np.full(len(sizes), True)
    corners = np.flatnonzero(large)
    face = np.repeat(np.arange(len(sizes)), sizes)[corners]
    before = np.empty(len(mesh.corners), dtype=int)
    before[mesh.topology.following] = np.arange(len(mesh.corners))
    here, ahead, behind = (
        mesh.vertices[mesh.corners[which]] for which in (corners, mesh.topology.following[corners], before[corners])
    )
    turn = dot(np.cross(here - behind, ahead - here), mesh.normals[face])
    return np.bincount(face, turn < 0, len(sizes)) == 0


def eared(mesh, number):
    """The triangles of one face, flat as seen along the axis that its normal is nearest to: (t, 3) int array."""
    corners = mesh.corners[mesh.offsets[number] : mesh.offsets[number + 1]]
    normal = mesh.normals[number]
    axis = int(np.abs(normal).argmax())
    across = [(axis + 1) % 3, (axis + 2) % 3][:: 1 if normal[axis] > 0 else -1]
    return corners[triangulate(mesh.vertices[corners][:, across], [np.arange(len(corners))])]

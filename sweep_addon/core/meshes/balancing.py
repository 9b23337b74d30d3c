# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Balancing: along which diagonals bent faces are cut where no vertex may be added."""

import numpy as np

from .facets import bent_faces, facets, sound


def balanced_facets(mesh):
    """The triangles of a mesh, of its own vertices, which together hold about what its faces do.

    Parameters
    ----------
    mesh : Mesh

    Returns
    -------
    (t, 3) int32 array
        The vertices of each, counter-clockwise from outside.

    On a twisted bar the shorter diagonals are all outside: it would be too thick everywhere. Of two bent faces with a
    common edge one is cut along its outer diagonal and one along its inner, as a chessboard is black and white: where
    they are of one size, what is too much on one is too little on the other.

    Examples
    --------
    >>> from sweep_addon.core.contours import Rectangle
    >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
    >>> mesh = GeneralizedCylinder(Rectangle(1.0, 1.0), twist="t").mesh()
    >>> a, b, c = mesh.vertices[balanced_facets(mesh)].swapaxes(0, 1)
    >>> bool(np.isclose(np.einsum("ij,ij->", np.cross(a, b), c) / 6, mesh.volume(), rtol=1e-12))
    True
    """
    triangles, face = facets(mesh)
    bent, corners, bulge = bent_faces(mesh.vertices, mesh.corners, mesh.offsets)
    a, b, c, d = mesh.vertices[corners].swapaxes(0, 1)
    free = sound(a, b, c, d) & sound(b, c, d, a)
    if not free.any():
        return triangles
    second = ((bulge > 0) ^ colours(mesh, bent))[free]  # whether from the second corner to the last
    corners = np.where(second[:, None], np.roll(corners[free], -1, axis=1), corners[free])
    halves = np.stack((corners[:, [0, 1, 2]], corners[:, [0, 2, 3]]), axis=1).reshape(-1, 3)
    return np.concatenate((triangles[~np.isin(face, bent[free])], halves))


def colours(mesh, faces):
    """One of two colours for each of some faces, different ones across an edge wherever that can be: bool array.

    Every face follows its first neighbour, if that comes before it, and takes the other colour: how many steps are
    between it and the end of its chain is counted in doubled strides, not one by one.
    """
    number = np.full(len(mesh.offsets) - 1, -1)
    number[faces] = np.arange(len(faces))
    owner = number[np.repeat(np.arange(len(number)), np.diff(mesh.offsets))]
    used, owner = mesh.topology.corner_edges[owner >= 0], owner[owner >= 0]
    order = np.argsort(used, kind="stable")
    used, owner = used[order], owner[order]
    one, other = owner[:-1][used[1:] == used[:-1]], owner[1:][used[1:] == used[:-1]]
    ahead = np.arange(len(faces))
    np.minimum.at(ahead, np.maximum(one, other), np.minimum(one, other))
    odd = ahead != np.arange(len(faces))
    while (ahead[ahead] != ahead).any():
        odd ^= odd[ahead]
        ahead = ahead[ahead]
    return odd

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Solid or sheet: which faces of a mesh of mixed dimension bound a solid, and which are a surface and no more.

A face of a solid has the inside at its back. Round each of its edges the next face on that side bounds the same inside:
it shows its back too. Where it shows its front, or where no other is, what lies between is outside, and one of the two
is a sheet. How many faces meet at an edge does not matter.
"""

import numpy as np

from .components import components
from .runs import run_of


def partners(mesh):
    """Which faces bound a solid together.

    Parameters
    ----------
    mesh : Mesh

    Returns
    -------
    (c,) int array
        For the edge that starts at each corner of a face, the corner from which the next face round the solid runs
        along it, the other way; -1 at all corners of a sheet.

    Examples
    --------
    >>> from ..shapes.translational_sweep import TranslationalSweep
    >>> for end in ("flat", "open"):
    ...     found = partners(TranslationalSweep(end=end).mesh())
    ...     print((found >= 0).sum(), "of", len(found))
    24 of 24
    0 of 20
    """
    face = run_of(mesh.offsets)
    edges, forward = mesh.topology.corner_edges, mesh.topology.forward
    faces = len(mesh.offsets) - 1
    solid = np.full(faces, True)
    while True:
        corners = np.flatnonzero(solid[face])
        order, last = round_edges(mesh, corners)
        partner = np.full(len(face), -1)
        following = np.roll(order, -1)
        following[last] = order[np.append(0, last[:-1] + 1)] if len(last) else order[:0]
        meet = ~forward[order] & forward[following]
        partner[order[meet]], partner[following[meet]] = following[meet], order[meet]
        loose = face[corners[partner[corners] < 0]]
        if not len(loose):
            return partner
        patch, sheet = components(faces, face[in_pairs(edges, corners)]), np.full(faces, False)
        sheet[patch[loose]] = True
        solid &= ~sheet[patch]


def round_edges(mesh, corners):
    """Corners in the order of the edges that start there, and of the faces round each; and which are the last ones."""
    edges = mesh.topology.corner_edges[corners]
    many = np.bincount(edges, minlength=len(mesh.edges))[edges] > 2
    angle = np.zeros(len(corners))
    angle[many] = angles(mesh, corners[many])
    order = np.lexsort((angle, edges))
    edges = edges[order]
    return corners[order], np.flatnonzero(np.append(edges[1:] != edges[:-1], True)[: len(edges)])


def angles(mesh, corners):
    """Where the face of each corner lies round the edge that starts there: (k,) float array, rising to its front."""
    start, end = mesh.vertices[mesh.edges[mesh.topology.corner_edges[corners]]].swapaxes(0, 1)
    axis = (end - start) / np.linalg.norm(end - start, axis=1, keepdims=True)
    normal = mesh.normals[run_of(mesh.offsets)[corners]]
    into = np.cross(normal, axis) * np.where(mesh.topology.forward[corners], 1, -1)[:, None]
    x = np.cross(axis, np.eye(3)[np.abs(axis).argmin(axis=1)])
    y = np.cross(axis, x)
    return np.arctan2(np.einsum("ij,ij->i", into, y), np.einsum("ij,ij->i", into, x))


def in_pairs(edges, corners):
    """(p, 2) int array: the two corners of each edge that just two of some corners have."""
    order = corners[np.argsort(edges[corners], kind="stable")]
    first = np.flatnonzero(np.bincount(edges[order])[edges[order]] == 2)[::2]
    return np.stack((order[first], order[first + 1]), axis=1)


def shells(mesh, partner):
    """The number of the shell of each face, as `components` counts, and (f,) bools: which have none, the sheets."""
    face = run_of(mesh.offsets)
    corners = np.flatnonzero(partner >= 0)
    shell = components(len(mesh.offsets) - 1, face[np.stack((corners, partner[corners]), axis=1)])
    sheet = np.full(len(shell), True)
    sheet[face[corners]] = False
    return shell, sheet

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of any faces, whose edges are searched: those that no grid of rings and columns lays."""

import numpy as np

from ..vectors import unit
from .mesh import Mesh, Topology
from .runs import following, run_of

CREASE = np.cos(np.radians(30))  # faces that turn more than this meet in an edge


class Bare:
    """The chart of a mesh without texture coordinates and attributes."""

    keys, rings = ("", "", ""), 0

    def uv(self, dtype=np.float64, empty=np.empty):
        return None

    def along(self, dtype=np.float64, but=(), rooms=None):
        return {}

    across = along


def polyhedron(vertices, corners, offsets=None, material=None, told=()):
    """A mesh of any faces; edges at which they turn by more than 30 degrees are sharp.

    Parameters
    ----------
    vertices : (n, 3) float array
    corners : (c,) or (f, k) int array
        The vertices of each face, counter-clockwise from outside; of k each where there are no offsets.
    offsets : (f + 1,) int array, optional
        Where each face starts.
    material : (f,) int array, optional
        The material slot of each face, by default the first.
    told : tuple of str
        Sentences for people.

    Returns
    -------
    Mesh

    Examples
    --------
    >>> tetrahedron = polyhedron(np.eye(4, 3), [(0, 2, 1), (0, 3, 2), (0, 1, 3), (1, 2, 3)])
    >>> tetrahedron.euler_characteristic(), len(tetrahedron.boundary_edges()), len(tetrahedron.edges)
    (2, 0, 6)
    """
    corners = np.asarray(corners, dtype=np.int32)
    if offsets is None:
        offsets = np.arange(0, corners.size + 1, corners.shape[1])
    corners, offsets = corners.ravel(), np.asarray(offsets, dtype=np.int32)
    ends = np.stack((corners, corners[following(offsets)]), axis=1)
    low, high = ends.min(axis=1).astype(np.int64), ends.max(axis=1)
    _, first, edge = np.unique(low * (len(vertices) + 1) + high, return_index=True, return_inverse=True)
    topology = Topology(
        corners=corners,
        offsets=offsets,
        edges=ends[first],
        corner_edges=edge.ravel().astype(np.int32),
        sharp=np.zeros(len(first), dtype=bool),
        material=np.zeros(len(offsets) - 1, np.int32) if material is None else np.asarray(material, dtype=np.int32),
    )
    mesh = Mesh(vertices, topology, Bare(), tuple(told))
    topology.sharp[:] = turns(mesh)
    return mesh


def turns(mesh):
    """Which edges turn by more than a crease, or are not of two faces: (e,) bool array."""
    topology = mesh.topology
    face = run_of(topology.offsets)
    shared = [np.bincount(topology.corner_edges, axis[face], len(topology.edges)) for axis in unit(mesh.normals).T]
    uses = np.bincount(topology.corner_edges, minlength=len(topology.edges))
    # of two unit normals the sum is 2 cos of half the angle long
    return (uses != 2) | (sum(axis**2 for axis in shared) < 2 + 2 * CREASE)

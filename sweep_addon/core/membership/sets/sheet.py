# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes without an inside as sets of points: surfaces, and edges and points that hang on them or stand alone."""

import numpy as np

from ...distance import Tree, nearest
from ...meshes.facets import bent_facets
from ...vectors import dot, norms
from ..labels import ON, OUT

CHUNK = 1 << 18  # pairs of points and edges at a time


class SheetBody:
    """The faces of a mesh, its loose edges and its loose vertices: points are on them or out.

    Parameters
    ----------
    mesh : Mesh
    """

    is_sheet, overlaps = True, False

    def __init__(self, mesh):
        vertices = np.asarray(mesh.vertices, dtype=np.float64)
        self.tree = None
        if len(mesh.corners):
            places, triangles = bent_facets(mesh)
            self.tree = Tree.of(np.asarray(places, dtype=np.float64)[triangles])
        edges = mesh.edges[np.bincount(mesh.topology.corner_edges, minlength=len(mesh.edges)) == 0]
        alone = np.setdiff1d(np.arange(len(vertices)), mesh.edges)
        lines = np.concatenate((edges, np.stack((alone, alone), axis=1)))
        self.starts, self.ways = vertices[lines[:, 0]], vertices[lines[:, 1]] - vertices[lines[:, 0]]
        self.box = np.stack((vertices.min(axis=0), vertices.max(axis=0)))

    def labels(self, points, tolerance):
        """ON or OUT for points (n, 3): (n,) int8."""
        far = nearest(self.tree, points).distances if self.tree else np.full(len(points), np.inf)
        if len(self.starts):
            size = max(CHUNK // len(self.starts), 1)
            for start in range(0, len(points), size):
                some = slice(start, start + size)
                far[some] = np.minimum(far[some], self.from_lines(points[some]))
        return np.where(far <= tolerance, ON, OUT).astype(np.int8)

    def from_lines(self, points):
        """How far points (n, 3) are from the nearest loose edge or vertex: (n,)."""
        way, squares = points[:, None] - self.starts, dot(self.ways, self.ways)
        share = np.clip(dot(way, self.ways) / np.where(squares > 0, squares, 1.0), 0.0, 1.0)
        return norms(way - share[..., None] * self.ways).min(axis=1)

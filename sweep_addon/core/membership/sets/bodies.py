# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies known by their distance: balls, closed meshes, offsets and canals."""

import numpy as np

from ...declared.options import Side
from ...declared.parameters import require
from ...distance import PseudoNormals, Tree, nearest
from ...meshes.facets import bent_facets
from ...vectors import norms
from ..labels import IN, ON, OUT

CHUNK = 1 << 15


class Body:
    """A set of points told by a signed distance: ``distance(points)``, negative inside, and ``box``."""

    is_sheet = overlaps = False

    def labels(self, points, tolerance):
        """IN, ON or OUT for points (n, 3): (n,) int8."""
        return told(self.distance(points), tolerance)


def told(distance, tolerance):
    """The labels of points so far from a boundary, negative inside: (n,) int8."""
    return np.where(np.abs(distance) <= tolerance, ON, np.where(distance < 0, IN, OUT)).astype(np.int8)


class BallBody(Body):
    """A ball about the origin."""

    def __init__(self, ball):
        self.radius = ball.radius
        self.box = np.array([[-ball.radius] * 3, [ball.radius] * 3])

    def distance(self, points):
        """How far points (n, 3) are from the sphere, negative inside: (n,)."""
        return norms(points) - self.radius


class MeshBody(Body):
    """The solid that a closed mesh bounds: exact for its faces."""

    def __init__(self, mesh):
        wrong = len(mesh.non_manifold_edges()) + len(mesh.boundary_edges())
        require(not wrong, "must be closed and manifold", f"{wrong} edges without two faces")
        vertices, triangles = bent_facets(mesh)
        vertices = np.asarray(vertices, dtype=np.float64)
        triangles = triangles if mesh.volume() > 0 else triangles[:, ::-1]
        self.tree, self.normals = Tree.of(vertices[triangles]), PseudoNormals.of(vertices, triangles)
        self.box = np.stack((vertices.min(axis=0), vertices.max(axis=0)))

    def distance(self, points):
        """How far points (n, 3) are from the mesh, negative inside: (n,)."""
        found = nearest(self.tree, points, normals=self.normals)
        return np.where(self.normals.outside_of(self.tree, points, found), found.distances, -found.distances)


class OffsetBody(Body):
    """What a ball visits that moves over the surface of a solid, on its sides, and the solid.

    Parameters
    ----------
    body : member
        With a ``distance``.
    radius : float
    side : Side
    """

    def __init__(self, body, radius, side):
        self.body, self.radius, self.side = body, radius, side
        out = 0.0 if side is Side.INSIDE else radius
        self.box = body.box + np.array([[-out], [out]])

    def distance(self, points):
        """How far points (n, 3) are from the offset, or less, negative inside: (n,)."""
        from_surface = self.body.distance(points)
        return {
            Side.OUTSIDE: from_surface - self.radius,
            Side.INSIDE: from_surface + self.radius,
            Side.SHELL: np.abs(from_surface) - self.radius,
        }[self.side]

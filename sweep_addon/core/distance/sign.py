# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""On which side of a closed mesh points are, told by the normal where the mesh is nearest."""

import numpy as np

from ..declared.frozen import individual
from ..vectors import cross, dot, norms, unit
from .triangles import EDGE, VERTEX


@individual
class PseudoNormals:
    """A normal of each part of each triangle, that tells the sides of the mesh apart.

    Parameters
    ----------
    parts : (f, 7, 3) float array
        Unit normals of the triangle, its three edges and its three corners.

    Source
    ------
    Baerentzen, Aanaes: Signed distance computation using the angle weighted pseudonormal, IEEE TVCG 11(3), 2005: at an
    edge the sum of both normals, at a vertex the sum of all, each weighted by the angle of its corner.

    Examples
    --------
    >>> corners = np.array([(0.0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)])
    >>> faces = np.array([(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])
    >>> PseudoNormals.of(corners, faces).parts[0, 4].round(3).tolist()
    [-0.577, -0.577, -0.577]
    """

    parts: np.ndarray

    @classmethod
    def of(cls, vertices, triangles):
        """The normals of vertices (n, 3) and triangles (f, 3), counter-clockwise from outside."""
        corners = vertices[triangles]
        sides = np.roll(corners, -1, axis=1) - corners
        normals = unit(cross(sides[:, 0], sides[:, 1]))
        angles = np.arctan2(norms(cross(sides, -np.roll(sides, 1, axis=1))), dot(sides, -np.roll(sides, 1, axis=1)))
        weighted = (angles[:, :, None] * normals[:, None]).reshape(-1, 3)
        at_vertices = np.stack([np.bincount(triangles.ravel(), w, len(vertices)) for w in weighted.T], axis=1)
        parts = np.empty((len(triangles), 7, 3))
        parts[:, 0] = normals
        parts[:, EDGE:VERTEX] = unit(across_edges(triangles, len(vertices), normals))
        parts[:, VERTEX:] = unit(at_vertices)[triangles]
        return cls(parts)

    def at(self, found):
        """(n, 3) float array: the normals where a mesh is nearest, of a `Nearest`."""
        return self.parts[found.faces, found.parts]

    def outside(self, points, found):
        """(n,) bool array: whether points are on the outer side of where the mesh is nearest, or on it."""
        return dot(points - found.places, self.at(found)) >= 0


def across_edges(triangles, count, normals):
    """(f, 3, 3) float array: for each edge of each triangle the sum of the normals of all that share it."""
    ahead = np.roll(triangles, -1, axis=1)
    keys = (np.minimum(triangles, ahead) * count + np.maximum(triangles, ahead)).ravel()
    _, edge = np.unique(keys, return_inverse=True)
    edge = edge.ravel()
    repeated = np.repeat(normals, 3, axis=0)
    sums = np.stack([np.bincount(edge, part) for part in repeated.T], axis=1)
    return sums[edge].reshape(-1, 3, 3)

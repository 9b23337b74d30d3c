# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""On which side of a mesh points are, told by the normal where the mesh is nearest.

A closed mesh may be folded into its solid, with nothing between both sides, as where solids were united that meet but
for rounding. Beside such a slit no normal tells it; but the ball up to it is free of the mesh, and so all on one side.
"""

from functools import cached_property

import numpy as np

from ..declared.frozen import individual
from ..vectors import cross, dot, norms, unit
from .nearest_points import nearest
from .triangles import EDGE, VERTEX

BLUNT = 1e-9  # what is left of normals that cancel out, where both sides of a slit meet
STRIDE = 0.99  # of the way to the mesh
STEPS = 64  # each doubles the distance at first: more than there are from rounding to the size of a mesh


@individual
class PseudoNormals:
    """A normal of each part of each triangle, that tells the sides of the mesh apart.

    Parameters
    ----------
    parts : (f, 7, 3) float array
        Unit normals of the triangle, its three edges and its three corners; zero where the mesh folds back on itself.

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
        parts[:, EDGE:VERTEX] = told(across_edges(triangles, len(vertices), normals))
        parts[:, VERTEX:] = told(at_vertices)[triangles]
        return cls(parts)

    def at(self, found):
        """(n, 3) float array: the normals where a mesh is nearest, of a `Nearest`."""
        return self.parts[found.faces, found.parts]

    @cached_property
    def has_folds(self):
        return not self.parts[:, EDGE:].any(axis=-1).all()

    def outside(self, points, found):
        """(n,) bool array: whether points are on the outer side of where the mesh is nearest, or on it."""
        return dot(points - found.places, self.at(found)) >= 0

    def outside_of(self, tree, points, found):
        """The same of a closed mesh whose tree is given, beside slits too; it was searched with these normals."""
        outside = self.outside(points, found)
        left = self.untold(found)
        random, aside = np.random.default_rng(0), np.zeros(3)
        places, reach, points = found.places[left], found.distances[left], points[left]
        for _ in range(STEPS if len(left) else 0):
            points = points + STRIDE * reach[:, None] * unit(unit(points - places) + aside)
            found = nearest(tree, points, normals=self)
            far = norms(points - tree.middle) > 2 * tree.size
            outside[left] = self.outside(points, found) | far
            again = self.untold(found)
            again = again[~far[again]]
            if not len(again):
                break
            left, points, places, reach = (each[again] for each in (left, points, found.places, found.distances))
            aside = unit(random.normal(size=points.shape))  # or it would go to and fro between two slits
        return outside

    def untold(self, found):
        """The points of which what is nearest does not tell the side: (k,) ints."""
        untold = found.torn | ~self.at(found).any(axis=1) if self.has_folds else found.torn
        return np.flatnonzero(untold & (found.faces >= 0))


def told(sums):
    """Unit normals of sums of normals (..., 3); zero where they cancel out."""
    return unit(np.where(norms(sums)[..., None] > BLUNT, sums, 0.0))


def across_edges(triangles, count, normals):
    """(f, 3, 3) float array: for each edge of each triangle the sum of the normals of all that share it."""
    ahead = np.roll(triangles, -1, axis=1)
    keys = (np.minimum(triangles, ahead) * count + np.maximum(triangles, ahead)).ravel()
    _, edge = np.unique(keys, return_inverse=True)
    edge = edge.ravel()
    repeated = np.repeat(normals, 3, axis=0)
    sums = np.stack([np.bincount(edge, part) for part in repeated.T], axis=1)
    return sums[edge].reshape(-1, 3, 3)

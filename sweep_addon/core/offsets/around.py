# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The field around a closed mesh: how much farther than a radius a point is from it, outside or inside."""

import numpy as np

from ..distance import PseudoNormals, Tree, nearest
from ..vectors import dot, norms
from .interval import distance_interval

TOUCHING = 1e-9  # of the radius: nearer points are told outward by the mesh's normal and not by their own place


class Around:
    """The signed distance to a closed mesh, less a radius; hints are points of the mesh.

    Parameters
    ----------
    vertices : (n, 3) float array
    triangles : (f, 3) int array
        Counter-clockwise from outside.
    radius : float
        In metres.
    outward : bool
        Whether the field grows towards the outside; else it grows towards the inside of the mesh.
    step : float
        The side of the cells in which it is asked, in metres.
    """

    ridges = False

    def __init__(self, vertices, triangles, radius, outward, step):
        self.tree = Tree.of(vertices[triangles], largest=4 * step)
        self.pseudo = PseudoNormals.of(vertices, triangles)
        self.radius, self.side, self.near = radius, 1 if outward else -1, 2 * step

    def evaluate(self, points, hints=None):
        found = nearest(self.tree, points, hints)
        sign = np.where(self.pseudo.outside(points, found), self.side, -self.side)
        return sign * found.distances - self.radius, found.places

    def inside(self, points, hints):
        """A hint within the radius is enough; and what is beyond it from the mesh is on the side that its hint is on.

        A way from there to the other side would lead through the mesh, and be longer than a cell's.
        """
        inside = norms(points - hints) < self.radius
        asked = np.flatnonzero(~inside)
        if self.radius < self.near:
            inside[asked] = self.evaluate(points[asked], hints[asked])[0] < 0
        else:
            inside[asked] = nearest(self.tree, points[asked], limit=self.radius).distances < self.radius
        return inside

    def normals(self, points, hints=None):
        found = nearest(self.tree, points, hints)
        own = self.pseudo.at(found) * self.side
        away = points - found.places
        sign = np.where(dot(away, own) >= 0, 1.0, -1.0)
        far = found.distances > TOUCHING * self.radius
        own[far] = (sign / np.where(far, found.distances, 1))[far, None] * away[far]
        return sign * found.distances - self.radius, own, found.places

    def interval(self, surface):
        """Bounds of the distance from the mesh on each triangle of a `Surface`, in metres: two (t,) arrays."""
        vertices = surface.vertices
        distances = np.abs(vertices.values + self.radius)
        return distance_interval(vertices.places, surface.triangles, distances, vertices.hints)

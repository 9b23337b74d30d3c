# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The field around a closed mesh: how much farther than a radius a point is from it, outside or inside."""

import numpy as np

from ..distance import PseudoNormals, Tree, nearest
from ..vectors import dot, norms, unit
from .any_field import AnyField
from .interval import distance_interval
from .vertices import Vertices

TOUCHING = 1e-9  # of the radius: nearer points are told outward by the mesh's normal and not by their own place
LEFT = 3  # balls at most that are left on a way
SETTLED = 0.01  # of a way: where it leaves a ball no farther on than it left the last one, no other is asked about


class Around(AnyField):
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

    def evaluate(self, points, hints=None, reach=np.inf):
        values, places = np.full(len(points), -np.inf), np.zeros((len(points), 3))
        asked = np.arange(len(points))
        if hints is not None:  # of points nearer to their hints no search tells more than that they are deep
            asked = np.flatnonzero(norms(points - hints) >= self.radius - reach)
        found = nearest(
            self.tree, points[asked], None if hints is None else hints[asked], self.radius + reach, self.pseudo
        )
        sign = np.where(self.pseudo.outside_of(self.tree, points[asked], found), self.side, -self.side)
        values[asked] = np.where(found.faces >= 0, sign * found.distances - self.radius, np.inf)
        places[asked] = found.places
        return values, places

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

    def leaving(self, within, outside, hints):
        """Where ways leave the balls about the mesh: each of them that of the nearest place, from one to the next."""
        if self.radius < self.near:
            return super().leaving(within, outside, hints)
        way, about, part = outside - within, hints.copy(), np.zeros(len(within))
        asked = np.arange(len(within))
        for _ in range(LEFT):
            part[asked] = np.maximum(part[asked], leaving_ball(within[asked] - about[asked], way[asked], self.radius))
            at = within[asked] + part[asked, None] * way[asked]
            about[asked] = nearest(self.tree, at, about[asked]).places
            on = leaving_ball(within[asked] - about[asked], way[asked], self.radius)
            asked = asked[on > part[asked] + SETTLED]
        places = within + np.maximum(part, leaving_ball(within - about, way, self.radius))[:, None] * way
        normals = unit(places - about)
        return places, about + self.radius * normals, normals

    def at_feet(self, vertices, places):
        """A place on the way to where the mesh is nearest has the same nearest one, and is not asked about."""
        known = (vertices.values >= 0) & (places == vertices.foot).all(axis=1)
        asked = np.flatnonzero(~known)
        moved = Vertices(places, np.zeros(len(places)), vertices.normals, vertices.hints)
        return moved.replaced(asked, vertices.some(asked).at(self, places[asked]))

    def interval(self, surface):
        """Bounds of the distance from the mesh on each triangle of a `Surface`, in metres: two (t,) arrays."""
        vertices = surface.vertices
        distances = np.abs(vertices.values + self.radius)
        return distance_interval(vertices.places, surface.triangles, distances, vertices.hints)


def leaving_ball(start, way, radius):
    """The last parts of ways (n, 3) that are in a ball, from starts as seen from its centre: (n,), 0 where none is."""
    length, along = dot(way, way), dot(start, way)
    left = along**2 - length * (dot(start, start) - radius**2)
    part = (np.sqrt(np.maximum(left, 0)) - along) / length
    return np.where((left > 0) & (part > 0) & (part <= 1), part, 0)

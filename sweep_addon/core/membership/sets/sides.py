# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sheets of triangles that have two sides and a rim: how far points are from them, on which side, and from the rim."""

from typing import NamedTuple

import numpy as np

from ...distance import PseudoNormals, Tree, nearest
from ...distance.triangles import INTERIOR, VERTEX
from ...meshes.facets import bent_facets
from ...vectors import dot, norms, unit
from ..motion.boxes import APART, from_box
from ..motion.changes import ASIDE
from ..motion.linear import LEAST, solved


class Seen(NamedTuple):
    """A sheet as points see it, in its own space."""

    depth: np.ndarray  # how far it is, negative behind it: (n,)
    face: np.ndarray  # the nearest triangle, -1 where it is far: (n,)
    part: np.ndarray  # which part of it, as `distance.triangles` numbers them: (n,)
    foot: np.ndarray  # the nearest place: (n, 3)


class Sided:
    """The triangles of a mesh with a boundary.

    Parameters
    ----------
    mesh : Mesh
        Whose faces look the same way wherever they meet; vertices at one place count as one.
    """

    overlaps = False

    def __init__(self, mesh):
        vertices, triangles = bent_facets(mesh)
        places = np.asarray(vertices, dtype=np.float64)[triangles].reshape(-1, 3)
        vertices, triangles = np.unique(places, axis=0, return_inverse=True)
        triangles = triangles.reshape(-1, 3)
        triangles = triangles[(triangles != np.roll(triangles, 1, axis=1)).all(axis=1)]
        self.tree, self.normals = Tree.of(vertices[triangles]), PseudoNormals.of(vertices, triangles)
        self.beside = across(triangles, len(vertices))
        start, end = (vertices[ends[self.beside < 0]] for ends in (triangles, np.roll(triangles, -1, axis=1)))
        self.rim = Tree.of(np.stack((start, end, end), axis=1)) if len(start) else None
        self.box = np.stack((vertices.min(axis=0), vertices.max(axis=0)))
        self.size = float(norms(self.box[1] - self.box[0]))

    def seen(self, points):
        """The sheet as points (n, 3) see it; from far away its box."""
        depth = from_box(points, *self.box)
        face, part, foot = np.full(len(points), -1), np.zeros(len(points), dtype=int), points.copy()
        near = np.flatnonzero(depth <= APART * self.size)
        found = nearest(self.tree, points[near])
        outside = self.normals.outside(points[near], found)
        depth[near] = np.where(outside, found.distances, -found.distances)
        face[near], part[near], foot[near] = found.faces, found.parts, found.places
        return Seen(depth, face, part, foot)

    def from_rim(self, points, maps=None):
        """How far points (n, 3) are from the rim, as maps (n, 3, 3) have both if they are given: (n,)."""
        if self.rim is None:
            return np.full(len(points), np.inf)
        found = nearest(self.rim, points)
        return from_parts(self.rim.corners[found.faces], found.parts, points - found.places, maps)

    def mapped(self, points, seen, maps):
        """How far points (n, 3) are from where they see the sheet to be nearest, as maps (n, 3, 3) have both: (n,).

        Of a face that is its plane, of an edge its line.
        """
        found = from_parts(self.tree.corners[seen.face], seen.part, points - seen.foot, maps)
        steep = norms(solved(maps.swapaxes(1, 2), self.normals.parts[seen.face, 0], ASIDE))
        return np.where(seen.part == INTERIOR, np.abs(seen.depth) / np.maximum(steep, LEAST), found)

    def between(self, one, other):
        """How far a way along the sheet from one foot to another leads from the first, where it is known.

        Known are ways within a triangle, and into one beside it.

        Parameters
        ----------
        one, other : Seen

        Returns
        -------
        (n,) float array
            Infinite where it is not known.
        """
        far = norms(other.foot - one.foot)
        met, known = np.nonzero((self.beside[one.face] == other.face[:, None]) & (other.face >= 0)[:, None])
        corners = self.tree.corners[one.face[met]]
        start, end = corners[np.arange(len(met)), known], corners[np.arange(len(met)), (known + 1) % 3]
        way, middle = end - start, (one.foot[met] + other.foot[met]) / 2
        share = np.clip(dot(middle - start, way) / np.maximum(dot(way, way), LEAST), 0.0, 1.0)
        detour = np.maximum(far[met], norms(start + share[:, None] * way - one.foot[met]))
        same = (one.face == other.face) & (one.face >= 0)
        found = np.where(same, far, np.inf)
        found[met] = detour
        return found


def from_parts(corners, parts, away, maps=None):
    """How long ways to parts of triangles are as maps have them; those to a side lead to its nearest place."""
    if maps is None:
        return norms(away)
    side = np.maximum(parts - 1, 0) % 3
    rows = np.arange(len(parts))
    along = corners[rows, (side + 1) % 3] - corners[rows, side]
    along, away = (np.einsum("nij,nj->ni", maps, part) for part in (along, away))
    along = unit(np.where(((parts == INTERIOR) | (parts >= VERTEX))[:, None], 0.0, along))
    return norms(away - dot(away, along)[:, None] * along)


def across(triangles, count):
    """The triangle on the other side of each edge i, from corner i to the next, or -2 at the rim: (f, 3) int array."""
    ahead = np.roll(triangles, -1, axis=1).astype(np.int64)
    keys, others = (triangles * np.int64(count) + ahead).ravel(), (ahead * count + triangles).ravel()
    order = np.argsort(keys, kind="stable")
    place = np.minimum(np.searchsorted(keys, others, sorter=order), len(keys) - 1)
    found = order[place]
    return np.where(keys[found] == others, found // 3, -2).reshape(triangles.shape)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A field: the signed distance from a solid, kept on a lattice about it, for when many points ask roughly."""

from functools import cached_property

import numpy as np

from ..declared.frozen import individual
from ..distance import PseudoNormals, Tree, nearest
from ..meshes.facets import bent_facets
from ..vectors import unit

MOST = 300_000  # nodes of the lattice
LARGER = 1.1  # times is a cell, until there are no more
NEAR = 4  # cells from the surface: farther nodes are taken from every other one
AROUND = 8  # cells that the lattice reaches beyond it
ROUNDING = 1e-6  # of a cell: nearer to the surface the way to it is no normal


@individual
class Field:
    """The signed distance from a closed mesh, negative inside.

    Parameters
    ----------
    tree : Tree
    normals : PseudoNormals
    low : (3,) float array
        The least corner of the lattice in metres.
    step : float
        The side of its cells.
    values : (i, j, k) float32 array
        The distances at its nodes.
    """

    tree: object
    normals: object
    low: np.ndarray
    step: float
    values: np.ndarray

    @classmethod
    def of(cls, mesh, step):
        """The field of a closed `Mesh`, with cells of that side, or larger ones where there would be too many."""
        vertices, triangles = bent_facets(mesh)
        vertices = np.asarray(vertices, dtype=np.float64)
        low, high = vertices.min(axis=0), vertices.max(axis=0)
        while (counts := np.ceil((high - low) / step).astype(int) + 1 + 2 * AROUND).prod() > MOST:
            step *= LARGER
        tree, normals = Tree.of(vertices[triangles]), PseudoNormals.of(vertices, triangles)
        field = cls(tree, normals, low - AROUND * step, step, np.empty(0))
        counts += counts % 2 == 0  # every other node is one of a lattice of twice the step
        nodes = np.stack(np.meshgrid(*map(np.arange, counts), indexing="ij"), axis=-1)
        coarse = field.exact(field.low + step * nodes[::2, ::2, ::2].reshape(-1, 3))[0].reshape(counts // 2 + 1)
        values = doubled(coarse)
        near = np.abs(values) <= NEAR * step
        values[near] = field.exact(field.low + step * nodes[near])[0]
        return cls(tree, normals, field.low, step, values.astype(np.float32))

    @property
    def error(self):
        """How far `rough` is from the distance at most, within the lattice: as a cell's middle is from its corners."""
        return self.step * np.sqrt(3) / 2

    def box(self, parts):
        """Points of the box around the solid, so many along each side: (k, 3) float array."""
        high = self.low + self.step * (np.array(self.values.shape) - 1)
        sides = np.linspace(self.low + AROUND * self.step, high - AROUND * self.step, parts).T
        return np.stack(np.meshgrid(*sides, indexing="ij"), axis=-1).reshape(-1, 3)

    def exact(self, points, hints=None):
        """The distance of points (n, 3), and the normals where the solid is nearest: (n,), (n, 3) float arrays.

        The search is quicker with a place of the surface near each.
        """
        values, found = self.signed(points, hints)
        away = np.sign(values)[:, None] * unit(points - found.places)
        on = np.flatnonzero(found.distances <= ROUNDING * self.step)
        away[on] = self.normals.at(found)[on]
        return values, away

    def signed(self, points, hints=None):
        """The distance of points (n, 3), (n,), and where the solid is nearest, a `Nearest`."""
        found = nearest(self.tree, points, hints, normals=self.normals)
        return np.where(self.normals.outside_of(self.tree, points, found), found.distances, -found.distances), found

    def rough(self, points):
        """(n,) float array: the distance of points (n, 3) by interpolation; beyond the lattice from the solid's box."""
        place = (points - self.low) / self.step
        last = np.array(self.values.shape) - 1
        inner = np.clip(place, 0, last * (1 - 1e-7))
        core = np.clip(place, AROUND, last - AROUND)  # the box around the solid
        outside = (place != inner).any(axis=1)
        beyond = np.sqrt(((place - core) ** 2).sum(axis=1)) * self.step
        cell = inner.astype(np.intp)
        x, y, z = (inner - cell).astype(np.float32).T
        strides = np.array([last[1] + 1, 1]) * (last[2] + 1)
        flat = cell[:, 0] * strides[0] + cell[:, 1] * strides[1] + cell[:, 2]
        v = self.flat
        i, j, k = int(strides[0]), int(strides[1]), 1

        def along(at):
            return v[at] + z * (v[at + k] - v[at])

        near, far = along(flat), along(flat + i)
        near = near + y * (along(flat + j) - near)
        far = far + y * (along(flat + i + j) - far)
        found = near + x * (far - near)
        return np.where(outside, beyond, found)

    @cached_property
    def flat(self):
        return self.values.ravel()


def doubled(values):
    """Values at nodes, and amid them, along each axis."""
    for axis in range(3):
        values = np.moveaxis(values, axis, 0)
        between = np.empty((2 * len(values) - 1, *values.shape[1:]))
        between[::2], between[1::2] = values, (values[1:] + values[:-1]) / 2
        values = np.moveaxis(between, 0, axis)
    return values

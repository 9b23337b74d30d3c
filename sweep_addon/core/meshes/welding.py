# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Welding: sweeps of several sections as one mesh, in which what they have in common is there once."""

from dataclasses import replace

import numpy as np

from ..declared.frozen import individual
from .joining import joined
from .mesh import Mesh, Topology


@individual
class Selected:
    """The chart of some vertices and corners of another one's mesh, some of them perhaps several times.

    Parameters
    ----------
    chart : Chart
    vertices, corners : (n,) and (c,) int arrays
        The vertex and the corner there that each one is.
    """

    chart: object
    vertices: np.ndarray
    corners: np.ndarray

    @property
    def keys(self):
        return self.chart.keys

    @property
    def rings(self):
        return self.chart.rings

    def uv(self, dtype=np.float64, empty=np.empty):
        whole = self.chart.uv(dtype)
        return None if whole is None else whole[self.corners]

    def along(self, dtype=np.float64, but=(), rooms=None):
        return {name: values[self.vertices] for name, values in self.chart.along(dtype, but).items()}

    def across(self, dtype=np.float64):
        return {name: values[self.vertices] for name, values in self.chart.across(dtype).items()}


def welded(meshes, points):
    """One mesh of several sweeps with equal stations, their vertices at one point of the plane joined.

    Parameters
    ----------
    meshes : sequence of Mesh
        Each drawn on a grid of its own.
    points : sequence of (m, 2) float arrays
        Where the columns of each grid are in the plane: the same place, the same numbers.

    Returns
    -------
    Mesh
    """
    mesh = joined(meshes)
    _, first, which = np.unique(labels([m.chart.grid for m in meshes], points), return_index=True, return_inverse=True)
    kept = np.sort(first)
    number = np.searchsorted(kept, first)[which.ravel()].astype(np.int32)
    topology = mesh.topology
    ends = np.sort(number[topology.edges].astype(np.int64), axis=1)
    _, edge, merged = np.unique(ends[:, 0] * len(kept) + ends[:, 1], return_index=True, return_inverse=True)
    sharp = np.bincount(merged.ravel(), topology.sharp, minlength=len(edge)) > 0
    topology = Topology(
        corners=number[topology.corners],
        offsets=topology.offsets,
        edges=number[topology.edges[edge]],
        corner_edges=merged.ravel()[topology.corner_edges].astype(np.int32),
        sharp=sharp,
        material=topology.material,
    )
    chart = Selected(mesh.chart, kept, np.arange(len(topology.corners)))
    return Mesh(mesh.vertices[kept], topology, chart, mesh.told)


def finished(mesh, mixed, regularize, fewer, turned=0):
    """A mesh with its parts by dimension told, if it may be of mixed dimension, or its solid part alone.

    The same sweep of few contours, beside those that its turn takes, is made by that function: `dimensions.told`.
    """
    if regularize:
        from .regularizing import regularized  # few ask

        return regularized(mesh)
    if not mixed:
        return mesh
    from .dimensions import told  # few sweeps are

    return replace(mesh, told=(*mesh.told, f"Parts: {told(mesh, fewer, turned)}."))


def labels(grids, points):
    """A number for each vertex of some grids: the same for the same point of the plane at the same station."""
    places = np.concatenate([p[:, 0] + 1j * p[:, 1] for p in points])
    _, place = np.unique(places, return_inverse=True)
    found, tips, stations = [], 0, max(grid.rings for grid in grids)
    for grid, columns in zip(grids, np.split(place.ravel(), np.cumsum([len(p) for p in points])[:-1]), strict=True):
        first = columns * stations
        tips += len(grid.tips)
        alone = np.arange(-tips, -tips + len(grid.tips))
        found += [(first[grid.lines, None] + grid.whole).ravel(), alone, first[list(grid.poles)]]
    return np.concatenate(found)

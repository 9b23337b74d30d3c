# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Putting vertices back until no two triangles of a dual surface cross."""

import numpy as np

from ..vectors import cross, dot, unit
from .crossings import crossing_pairs

ROUNDS = 4
FLAT = 0.3  # the least cosine between the triangles about a cell and their mean, of which none can cross another


def untangled(stages, triangles, corner_cells, cell):
    """The last stage of vertices, those that make triangles cross or turn over put back to an earlier one.

    Parameters
    ----------
    stages : sequence of Vertices
        Where vertices began, ..., and where they are.
    triangles : (t, 3) int array
    corner_cells : (t, 4) int array
        The cells that each triangle does not leave: those at the corners of its face.
    cell : (n,) int array
        The cell of each vertex.

    Returns
    -------
    vertices : Vertices
    crossing : (k, 2) int array
        Pairs of triangles that still cross after four rounds.
    """
    vertices = stages[-1]
    stage = np.full(len(vertices.places), len(stages) - 1)
    for number in range(ROUNDS + 1):
        normals = unit(facing(vertices.places, triangles))
        crossing = crossing_pairs(
            vertices.places, triangles, corner_cells, doubtful(normals, corner_cells, np.bincount(cell) > 1)
        )
        over = dot(normals, vertices.normals[triangles].sum(axis=1)) < 0
        wrong = np.unique(triangles[np.append(crossing.ravel(), np.flatnonzero(over & (number == 0)))])
        if not len(wrong) or number == ROUNDS:
            return vertices, crossing
        stage[wrong] = np.maximum(stage[wrong] - 1, 0)
        for back, earlier in enumerate(stages[:-1]):
            which = wrong[stage[wrong] == back]
            vertices = vertices.replaced(which, earlier.some(which))


def facing(places, triangles):
    a, b, c = places[triangles].swapaxes(0, 1)
    return cross(b - a, c - a)


def doubtful(normals, cells, crowded):
    """Which triangles are in a cell of several vertices, or whose triangles do not all look the same way: (t,) bool.

    Seen along the mean of their normals those of any other cell are a fan about its vertex, and cannot cross.
    """
    count = len(crowded)
    sums = [np.bincount(cells.ravel(), np.repeat(part, cells.shape[1]), count) for part in normals.T]
    means = unit(np.stack(sums, axis=1))
    bent = crowded.copy()
    bent[cells[np.einsum("ti,tci->tc", normals, means[cells]) < FLAT]] = True
    return bent[cells].any(axis=1)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Putting vertices back until no two triangles of a dual surface cross, and no two vertices are at one place."""

import numpy as np

from ..vectors import cross, dot, unit
from .crossings import crossing_pairs

ROUNDS = 4
FLAT = 0.3  # the least cosine between the triangles about a cell and their mean, of which none can cross another


def untangled(stages, triangles, corner_cells, cell):
    """The last stage of vertices, of which those are put back to an earlier one that make triangles cross or turn over.

    Those that are where another is are put back too: places far off the zero end at one corner of their cell.

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
        wrong = triangles[np.append(crossing.ravel(), np.flatnonzero(over & (number == 0)))]
        wrong = np.unique(np.append(wrong, doubled(vertices.places)))
        if not len(wrong) or number == ROUNDS:
            return vertices, crossing
        stage[wrong] = np.maximum(stage[wrong] - 1, 0)
        for back, earlier in enumerate(stages[:-1]):
            which = wrong[stage[wrong] == back]
            vertices = vertices.replaced(which, earlier.some(which))


def doubled(places):
    """The numbers of places (n, 3) that are others too in single precision: (k,) int array.

    >>> doubled(np.array([(1.0, 2, 3), (1, 2, 4), (0, 0, 0), (1 + 1e-9, 2, 3)])).tolist()
    [0, 3]
    """
    x, y, _ = (places.astype(np.float32) + 0.0).view(np.uint32).T.astype(np.uint64)  # there is one 0
    keys = x << np.uint64(32) | y
    order = np.argsort(keys)
    same = np.flatnonzero(keys[order[1:]] == keys[order[:-1]])
    some = np.union1d(order[same], order[same + 1])
    _, which, count = np.unique(places[some].astype(np.float32), axis=0, return_inverse=True, return_counts=True)
    return some[count[which.ravel()] > 1]


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

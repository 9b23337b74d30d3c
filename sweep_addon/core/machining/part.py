# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The desired part: how high it is at the places of a lattice, seen from above."""

import numpy as np

from ..meshes.facets import bent_facets
from .cells import cells, shares

AWAY = 1e-9  # of the size of a triangle: so far beside it a place still counts as on it


def top_of(vertices, triangles, lattice, shift=(0.0, 0.0)):
    """The height of the highest point of triangles above each place of a lattice.

    Parameters
    ----------
    vertices : (v, 3) float array
        In metres.
    triangles : (t, 3) int array
    lattice : Lattice
    shift : tuple of 2 floats
        By which all places are moved.

    Returns
    -------
    (n, m) float array
        -inf where there is none.

    Examples
    --------
    >>> from sweep_addon.core.machining.lattice import Lattice
    >>> slope = np.array([(0.0, 0.0, 0.0), (2.0, 0.0, 2.0), (0.0, 2.0, 0.0)])
    >>> top_of(slope, np.array([[0, 1, 2]]), Lattice.across((0.0, 0.0), (2.0, 1.0), 1.0)).tolist()
    [[0.0, 0.0], [1.0, 1.0], [2.0, -inf]]
    """
    found = np.full(lattice.size[0] * lattice.size[1], -np.inf)
    corners = vertices[triangles] - (*shift, 0.0)
    first, last = boxes(corners, lattice)
    counts = np.prod(np.maximum(last - first + 1, 0), axis=1)
    for some in shares(counts):
        lift(found, corners[some], first[some], last[some], lattice)
    return found.reshape(lattice.size)


def seen_from_above(mesh):
    """The vertices of a mesh and the triangles that its highest points are on: of a closed one those that look up.

    One that is inside out, as a mirrored object may be, is taken for what it bounds.
    """
    vertices, triangles = bent_facets(mesh)
    vertices = np.asarray(vertices, dtype=np.float64)
    if len(mesh.boundary_edges()):
        return vertices, triangles
    x, y = np.moveaxis(vertices[triangles][:, :, :2], 2, 0)
    one, other = (np.stack((x[:, k] - x[:, 0], y[:, k] - y[:, 0])) for k in (1, 2))
    upward = one[0] * other[1] - one[1] * other[0]
    return vertices, triangles[upward > 0 if mesh.volume() > 0 else upward < 0]


def boxes(corners, lattice):
    """The first and last place along each axis that triangles may be above: two (t, 2) int arrays."""
    low, high = corners[:, :, :2].min(axis=1), corners[:, :, :2].max(axis=1)
    slack = AWAY * (high - low).max(axis=1, keepdims=True)
    first = np.ceil((low - slack - lattice.low) / lattice.step)
    last = np.floor((high + slack - lattice.low) / lattice.step)
    most = np.array(lattice.size) - 1
    return np.clip(first, 0, most + 1).astype(np.int64), np.clip(last, -1, most).astype(np.int64)


def lift(found, corners, first, last, lattice):
    """Raise heights to those of some triangles."""
    row, i, j = cells(*(last - first + 1).T)
    i, j = i + first[row, 0], j + first[row, 1]
    x = lattice.low[0] + lattice.step[0] * i - corners[row, 0, 0]
    y = lattice.low[1] + lattice.step[1] * j - corners[row, 0, 1]
    one, other = (corners[:, k] - corners[:, 0] for k in (1, 2))
    area = one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]
    upright = np.abs(area) <= 1e-300
    safe = np.where(upright, 1.0, area)[row]
    along_one = (x * other[row, 1] - y * other[row, 0]) / safe
    along_other = (one[row, 0] * y - one[row, 1] * x) / safe
    inside = (along_one >= -AWAY) & (along_other >= -AWAY) & (along_one + along_other <= 1 + AWAY) & ~upright[row]
    height = corners[row, 0, 2] + along_one * one[row, 2] + along_other * other[row, 2]
    np.maximum.at(found, (i * lattice.size[1] + j)[inside], height[inside])

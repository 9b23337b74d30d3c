# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Vertices of cells that a ridge or a valley passes, from where the surface crosses the edges of the cells.

The tangent planes there are those of the sheets themselves; those at the vertices of neighbours may be of a sheet that
does not come into the cell, or off where these are.
"""

import numpy as np

from ..vectors import norms
from .band import CORNERS
from .creases import TURN, meeting_places
from .cycles import EDGES


def where_edges_cross(field, band, dual, which):
    """Places in some cells where the tangent planes of the surface at their edges meet best.

    Parameters
    ----------
    field : object
    band : Band
    dual : Dual
    which : (k,) int array
        The vertices that are asked about.

    Returns
    -------
    places : (k, 3) float array
        Within the vertices' cells, in metres.
    bent : (k,) bool array
        Whether the planes turn: else all are of one sheet, and tell nothing of where it ends.

    Source
    ------
    Ju, Losasso, Schaefer, Warren: Dual contouring of Hermite data, 2002.

    Examples
    --------
    A cube's corner is in one cell, of which no more is known than where three edges leave the cube.

    >>> from .band import narrow_band
    >>> from .dual import dual_surface
    >>> from .implicit import Implicit
    >>> cube = Implicit(lambda points: np.abs(points).max(axis=1) - 1)
    >>> band = narrow_band(cube, (-1, -1, -1), (1, 1, 1), 0.3)
    >>> dual = dual_surface(band)
    >>> where_edges_cross(cube, band, dual, np.array([0]))[0].round(6)
    array([[-1., -1., -1.]])
    """
    number = np.full(len(dual.cell), -1)
    number[which] = np.arange(len(which))
    asked = number[dual.vertex] >= 0
    own, cell, edge = number[dual.vertex[asked]], dual.cell[dual.vertex[asked]], dual.edge[asked]
    first, crossing = apart(band, cell, edge)
    places, feet, normals = crossings(field, band, cell[first], edge[first])
    count = np.bincount(own, minlength=len(which))[:, None]
    means = np.stack([np.bincount(own, part[crossing], len(which)) for part in places.T], axis=1) / count
    found = meeting_places(means, own, feet[crossing], normals[crossing])
    low = band.low + band.step * band.cells[dual.cell[which]]
    mean = np.stack([np.bincount(own, part[crossing], len(which)) for part in normals.T], axis=1) / count
    bent = np.bincount(own, norms(normals[crossing] - mean[own]) > TURN / 2, len(which)) > 0
    return np.clip(found, low, low + band.step), bent


def apart(band, cell, edge):
    """Of edges of cells (p,) one of each of the lattice, and which of these each is: two int arrays."""
    start = band.cells[cell] + CORNERS[EDGES[edge, 0]]
    shape = band.cells.max(axis=0) + 2
    key = ((edge // 4 * shape[0] + start[:, 0]) * shape[1] + start[:, 1]) * shape[2] + start[:, 2]
    _, first, which = np.unique(key, return_index=True, return_inverse=True)
    return first, which.reshape(-1)


def crossings(field, band, cell, edge):
    """Where the surface crosses edges of cells (p,), just outside: places, and a foot and a normal of it near each."""
    ends = band.low + band.step * (band.cells[cell][:, None] + CORNERS[EDGES[edge]])
    swapped = band.inside[cell] >> EDGES[edge, 0] & 1 == 0
    ends[swapped] = ends[swapped, ::-1]
    within, outside = ends.swapaxes(0, 1)
    return field.leaving(within, outside, band.hints[cell])

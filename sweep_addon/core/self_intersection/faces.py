# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which faces of a mesh are at the places where a sweep meets itself."""

import numpy as np

from ..grids.laying import kinds


def faces_of(chart, places):
    """The faces at places: those that cross, of a fold or a leg all between its parameters, of an end its cap.

    Parameters
    ----------
    chart : Chart
        Of the mesh whose faces are asked for.
    places : iterable of Place

    Returns
    -------
    (k,) int array
        Numbers of faces, rising.

    Examples
    --------
    >>> from sweep_addon.core.contours import Circle
    >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
    >>> from sweep_addon.core.stations.sampling import Count
    >>> from sweep_addon.core.trajectories import Arc
    >>> bend = GeneralizedCylinder(Circle(0.5, points=8), Arc(radius=0.3), Count(5))
    >>> len(faces_of(bend.mesh().chart, bend.self_intersections()))
    32
    """
    grid = chart.grid
    bands = len(grid.bands()[0])
    u = np.append(chart.u, np.inf) if grid.closed else chart.u
    marked, caps = np.zeros((grid.columns, bands), bool), np.zeros(2, bool)
    for place in places:
        if len(place.cells):
            mark(marked, np.asarray(place.cells))
        else:
            for a, b in place.parameters:
                marked[:, between(u, a, b)] = True
        if place.kind in ("global", "ends"):  # what meets the rim meets the face
            caps |= np.isin(chart.u[[0, -1]], np.array(place.parameters))
    return numbers(grid, marked, caps)


def mark(marked, cells):
    """Set what cells (k, 3), from one ring to another on a column, cover of columns and bands (m, b)."""
    change = np.zeros((marked.shape[0], marked.shape[1] + 1), int)
    first, last, column = cells.T
    np.add.at(change, (column, first), 1)
    np.add.at(change, (column, last), -1)
    marked |= np.cumsum(change, axis=1)[:, :-1] > 0


def between(u, a, b):
    """Which bands are between parameters, or, where the first is larger, beyond them: (n - 1,) bool."""
    start, end = u[:-1], u[1:]
    inside = (start < b, end > a) if a != b else (start <= b, end >= a)
    return inside[0] & inside[1] if a <= b else inside[0] | inside[1]


def numbers(grid, marked, caps):
    """The numbers of the faces of columns and bands (m, b), and of caps at the start and the end (2,)."""
    _, below, above = grid.bands()
    plain, *poles = grid.strips
    sides = [marked[np.ix_(plain, bands)].ravel() for bands in kinds(below, above)]
    sides.extend(marked[strips].ravel() for strips in poles)
    ends = [np.full(len(cap[1]) - 1, chosen) for cap, chosen in zip(grid.caps, caps, strict=True) if cap is not None]
    return np.flatnonzero(np.concatenate((*sides, *ends)))

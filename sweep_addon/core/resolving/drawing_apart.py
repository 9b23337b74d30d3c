# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawing apart: where a surface touches itself in a point, each side has a vertex of its own there."""

import numpy as np

from ..vectors import norms, unit
from .equal_rows import mixed
from .stars import Stars, touching


def drawn_apart(vertices, triangles, far, fixed):
    """Move vertices that single precision does not tell apart towards their neighbours, all but one of each group.

    Parameters
    ----------
    vertices : (n, 3) float array
    triangles : (t, 3) int array
        A closed manifold without short edges.
    far : float
        In metres.
    fixed : (n,) bool array
        The vertices that are to stay.

    Returns
    -------
    (n, 3) float array

    A tip goes back into what it is the tip of, be that full or a cavity; so the flattest vertex of each group stays.
    Of several tips one goes farther than the other, for they may point the same way.

    Examples
    --------
    Two tetrahedra that touch in a point:

    >>> one, sides = np.eye(4, 3), np.array([(0, 2, 1), (0, 3, 2), (0, 1, 3), (1, 2, 3)])
    >>> vertices, sides = np.concatenate((one, 2 * one[0] - one)), np.concatenate((sides, 4 + sides[:, ::-1]))
    >>> moved = drawn_apart(vertices, sides, 1e-6, np.full(8, False))
    >>> [len(np.unique(places.astype(np.float32), axis=0)) for places in (vertices, moved)]
    [7, 8]
    """
    used = np.full(len(vertices), False)
    used[triangles] = True
    used = np.flatnonzero(used)
    place = mixed(vertices[used].astype(np.float32).astype(np.float64))
    known = np.sort(place)
    again = np.isin(place, known[1:][known[1:] == known[:-1]])
    if not again.any():
        return vertices
    used, place = used[again], place[again]
    stars = Stars(triangles[touching(triangles, used, len(vertices))], len(vertices))
    number, neighbour = stars.around(used[:, None])
    ways = unit(vertices[neighbour] - vertices[used[number]])
    mean = np.stack([np.bincount(number, axis) for axis in ways.T], axis=1) / np.bincount(number)[:, None]
    order = np.lexsort((np.where(fixed[used], -1.0, norms(mean)), place))
    first = np.append(True, place[order[1:]] != place[order[:-1]])
    rank = np.arange(len(order)) - np.maximum.accumulate(np.where(first, np.arange(len(order)), 0))
    kept = (rank > 0) & ~fixed[used[order]]
    moved, rank = order[kept], rank[kept]
    vertices = vertices.copy()
    vertices[used[moved]] += far * rank[:, None] * unit(mean[moved])
    return vertices

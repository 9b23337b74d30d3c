# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tidying: vertices that a boolean has left so close to each other that single precision does not tell them apart."""

import numpy as np

from ..components import components
from ..vectors import norms

CLOSE = 1e-7  # of the size of a mesh
ATTEMPTS = 4


def tidied(vertices, triangles):
    """Draw together vertices that edges join which are next to nothing, where the surface stays a closed manifold.

    Parameters
    ----------
    vertices : (n, 3) float array
    triangles : (t, 3) int array
        A closed manifold.

    Returns
    -------
    triangles : (t, 3) int array
        With the first of each such vertices instead of all of them.
    kept : (t,) bool array
        Which triangles are still some: two of their corners may be one now.

    Examples
    --------
    Four faces of a pyramid whose tip was split in two:

    >>> vertices = np.array([(1, 1, 0), (-1, 1, 0), (-1, -1, 0), (1, -1, 0), (0, 0, 1), (0, 1e-9, 1)])
    >>> sides = [(0, 1, 5), (1, 4, 5), (1, 2, 4), (2, 3, 4), (3, 0, 4), (0, 5, 4), (0, 2, 1), (0, 3, 2)]
    >>> triangles, kept = tidied(vertices, np.array(sides))
    >>> int(kept.sum()), len(np.unique(triangles[kept]))
    (6, 5)
    """
    edges = np.concatenate((triangles[:, :2], triangles[:, 1:], triangles[:, ::2]))
    edges = edges[edges[:, 0] < edges[:, 1]]
    lengths = norms(vertices[edges[:, 0]] - vertices[edges[:, 1]])
    close = edges[lengths < CLOSE * np.ptp(vertices, axis=0).max()]
    for _ in range(ATTEMPTS if len(close) else 0):
        first = components(len(vertices), close)
        drawn = first[triangles]
        kept = (drawn != np.roll(drawn, 1, axis=1)).all(axis=1)
        wrong = torn(len(vertices), drawn[kept], triangles)
        if not wrong.any():
            return drawn, kept
        close = close[~wrong[first[close[:, 0]]]]
    return triangles, np.full(len(triangles), True)


def torn(count, drawn, before):
    """The vertices at which a surface is no closed manifold any longer: (count,) bool array.

    Each directed edge must be there once, and once the other way. Where a disc is drawn together, twice as many
    triangles go as vertices.
    """
    start, end = drawn.ravel(), np.roll(drawn, -1, axis=1).ravel()
    keys, back = start * np.int64(count) + end, end * np.int64(count) + start
    order, times = np.unique(keys, return_counts=True)
    place = np.searchsorted(order, back).clip(0, max(len(order) - 1, 0))
    bad = (order[place] != back) | (times[np.searchsorted(order, keys)] > 1)
    wrong = np.full(count, False)
    wrong[start[bad]] = wrong[end[bad]] = True
    lost = len(np.unique(before)) - len(np.unique(drawn))
    if not bad.any() and len(before) - len(drawn) != 2 * lost:
        wrong[:] = True
    return wrong

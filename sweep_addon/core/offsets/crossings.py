# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which triangles of a dual surface cross each other."""

from functools import reduce

import numpy as np

from ..contours.ranges import ranges
from ..vectors import cross, dot, norms

ROUNDING = 1e-9  # of its distance: a corner that is not farther from another triangle's plane lies in that plane


def crossing_pairs(vertices, triangles, cells, asked=None):
    """Pairs of triangles that cross, other than at vertices or an edge that they share.

    Parameters
    ----------
    vertices : (n, 3) float array
    triangles : (t, 3) int array
    cells : (t, 4) int array
        The cells of a lattice that each triangle does not leave: two triangles that cross do so in one of both.
    asked : (t,) bool array, optional
        Pairs of which neither is asked about are passed over.

    Returns
    -------
    (k, 2) int array
        Numbers of triangles, the lower first.
    """
    pairs = neighbours(cells, np.ones(len(triangles), dtype=bool) if asked is None else asked)
    found = [pairs[:0]]
    for some in np.array_split(pairs, max(len(pairs) // 200_000, 1)):
        one, other = triangles[some].swapaxes(0, 1)
        low, high = (np.stack([reduce(part, vertices[t.T]) for t in (one, other)]) for part in (np.minimum, np.maximum))
        near = ((low[0] <= high[1]) & (low[1] <= high[0])).all(axis=1)
        some, one, other = some[near], one[near], other[near]
        shared = one[:, :, None] == other[:, None, :]
        first = pierced(vertices[one], vertices[other], shared.any(axis=2))
        found.append(some[first | pierced(vertices[other], vertices[one], shared.any(axis=1))])
    return np.concatenate(found)


def neighbours(cells, asked):
    """Pairs of triangles with a cell in common of which one is asked about: (p, 2) int array."""
    triangle = np.repeat(np.arange(len(cells)), cells.shape[1])
    order = np.argsort(cells.ravel(), kind="stable")
    cell, triangle = cells.ravel()[order], triangle[order]
    starts = np.flatnonzero(np.append(True, cell[1:] != cell[:-1]))
    sizes = np.diff(np.append(starts, len(cell)))
    wanted = np.flatnonzero(asked[triangle])
    group = np.searchsorted(starts, wanted, side="right") - 1
    keys = [np.zeros(0, dtype=np.int64)]
    for place, other in ranges(starts[group], sizes[group]):
        one, other = triangle[wanted[place]], triangle[other]
        differ = one != other
        low, high = np.minimum(one, other)[differ], np.maximum(one, other)[differ]
        keys.append(each_once(low.astype(np.int64) * len(cells) + high))
    keys = each_once(np.concatenate(keys))
    return np.stack((keys // len(cells), keys % len(cells)), axis=1)


def each_once(keys):
    """The same numbers, rising: of a million `numpy.unique` of NumPy 2.3 and later takes twenty times as long."""
    keys = np.sort(keys)
    return keys[np.append(True, keys[1:] != keys[:-1])[: len(keys)]]


def pierced(one, other, shared):
    """Whether an edge of one triangle passes through the inside of the other.

    Parameters
    ----------
    one, other : (p, 3, 3) float arrays
    shared : (p, 3) bool array
        Which corners of the first are corners of the second.

    Returns
    -------
    (p,) bool array
    """
    a, b, c = other.swapaxes(0, 1)
    normals = cross(b - a, c - a)
    heights = np.stack([dot(one[:, i] - a, normals) for i in range(3)], axis=1)
    lengths = norms(one - a[:, None]) * norms(normals)[:, None]
    heights[shared | (np.abs(heights) <= ROUNDING * lengths)] = 0
    found = np.zeros(len(one), dtype=bool)
    for i in range(3):
        apart = np.flatnonzero(heights[:, i] * heights[:, i - 2] < 0)
        start, way = one[apart, i], one[apart, i - 2] - one[apart, i]
        spans = [other[apart, k] - start for k in range(3)]
        turns = np.stack([dot(way, cross(spans[k], spans[k - 2])) for k in range(3)], axis=1)
        found[apart] |= (turns > 0).all(axis=1) | (turns < 0).all(axis=1)
    return found

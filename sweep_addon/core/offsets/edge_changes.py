# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Edges of a closed triangle mesh split or flipped, many at once, none of which makes triangles cross.

An edge is a row (a, b, c, d, one, other): it runs from a to b in triangle `one`, (a, b, c), and back in triangle
`other`, (b, a, d).
"""

import numpy as np

from .crossings import crossing_pairs


def edges_of(triangles):
    """The edges of a closed mesh of triangles (t, 3), each once: (e, 6) int array."""
    start, end, apex = (np.roll(triangles, -turn, axis=1).ravel() for turn in range(3))
    low, high = np.minimum(start, end), np.maximum(start, end)
    order = np.lexsort((start, high, low))  # of both ways along an edge the one from its lower end is first
    one, other = order[::2], order[1::2]
    return np.stack((start[one], end[one], apex[one], apex[other], one // 3, other // 3), axis=1)


def independent(edges, ranks):
    """Which of edges (e, 6) to take so that no triangle is of two of them, those of the highest ranks first: (k,) int.

    Each takes part until it is taken or one beside it is: one is taken that outranks all of those beside it.
    """
    left, taken = np.argsort(-ranks, kind="stable"), [np.zeros(0, dtype=int)]
    while len(left):
        sides = edges[left, 4:]
        best = np.full(edges[:, 4:].max() + 1, len(left))
        place = np.arange(len(left))
        for side in sides.T:
            np.minimum.at(best, side, place)
        wins = (best[sides] == place[:, None]).all(axis=1)
        taken.append(left[wins])
        busy = np.zeros(len(best), dtype=bool)
        busy[sides[wins]] = True
        left = left[~busy[sides].any(axis=1)]
    return np.sort(np.concatenate(taken))


def split(edges, new):
    """The four triangles of each edge (k, 6) that is split at a new vertex (k,): (4, k, 3) int array."""
    a, b, c, d = edges[:, :4].T
    return np.stack([np.stack(t, axis=1) for t in ((a, new, c), (b, new, d), (new, b, c), (new, a, d))])


def flipped(edges):
    """The two triangles of each edge (k, 6) that is flipped: (2, k, 3) int array."""
    a, b, c, d = edges[:, :4].T
    return np.stack([np.stack(t, axis=1) for t in ((a, d, c), (d, b, c))])


def without_crossings(places, triangles, edges, made):
    """Which changes of edges may be made together so that none of their triangles crosses another: (k,) int array.

    Parameters
    ----------
    places : (n, 3) float array
    triangles : (t, 3) int array
    edges : (k, 6) int array
        No two with a triangle in common.
    made : (2 or 4, k, 3) int array
        The triangles that take the place of the two at each edge.
    """
    kept = np.arange(len(edges))
    while len(kept):
        after = changed(triangles, edges[kept], made[:, kept])
        owner = np.full(len(after), -1)
        owner[edges[kept, 4:].T] = np.arange(len(kept))
        owner[len(triangles) :] = np.tile(np.arange(len(kept)), len(made) - 2)
        near, cells = about(places[after], owner >= 0)
        pairs = crossing_pairs(places, after[near], cells, owner[near] >= 0)
        wrong = np.unique(owner[near[pairs]])
        wrong = wrong[wrong >= 0]
        if not len(wrong):
            break
        kept = np.delete(kept, wrong)
    return kept


def changed(triangles, edges, made):
    """Triangles (t, 3) of which those at edges are replaced by the first two of each, the others put at the end."""
    triangles = triangles.copy()
    triangles[edges[:, 4:].T] = made[:2]
    return np.concatenate((triangles, made[2:].reshape(-1, 3)))


def about(corners, asked):
    """The triangles near those that are asked about, (k,) int, and the cells that each of them may pass, (k, 8) int.

    Cells are as large as the largest triangle, so that it is within those of the corners of its box.
    """
    low, high = corners.min(axis=1), corners.max(axis=1)
    side = (high - low).max()
    low, high = (np.floor((part - low.min(axis=0)) / side).astype(int) for part in (low, high))
    shape = high.max(axis=0) + 1
    ends = np.stack((low, high))
    x, y, z = (ends[:, :, axis] for axis in range(3))
    keys = (x[:, None, None] * shape[1] + y[None, :, None]) * shape[2] + z[None, None, :]
    keys = keys.reshape(8, -1).T
    near = np.flatnonzero(np.isin(keys, keys[asked]).any(axis=1))
    return near, np.unique(keys[near], return_inverse=True)[1].reshape(-1, 8)


def joining(triangles, pairs):
    """Which pairs of vertices (k, 2) are no edge of a closed mesh yet, nor told before: (k,) bool."""
    count = triangles.max() + 1
    start, end = triangles.ravel().astype(np.int64), np.roll(triangles, -1, axis=1).ravel()
    keys = pairs.min(axis=1) * count + pairs.max(axis=1)
    first = np.zeros(len(keys), dtype=bool)
    first[np.unique(keys, return_index=True)[1]] = True
    return first & ~np.isin(keys, start * count + end)


def sheets(edges):
    """The two triangles at each edge (k, 6): (2, k, 3) int array."""
    a, b, c, d = edges[:, :4].T
    return np.stack([np.stack(t, axis=1) for t in ((a, b, c), (b, a, d))])

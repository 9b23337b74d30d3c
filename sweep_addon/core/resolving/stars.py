# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Stars: the triangles at each vertex of a closed surface, and the vertices to which edges join it."""

import numpy as np

from .sewing import corners_of


class Stars:
    """What is round each vertex.

    Parameters
    ----------
    triangles : (t, 3) int array
        Those of a closed manifold at all vertices that are asked about.
    count : int
        Of vertices.
    """

    def __init__(self, triangles, count):
        start, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
        self.corners = np.argsort(start, kind="stable")
        self.neighbours = end[self.corners]
        self.sizes = np.bincount(start, minlength=count)
        self.offsets = np.concatenate(([0], np.cumsum(self.sizes)))

    def around(self, ends):
        """The neighbours of the ends of edges (e, 2), these among them: the edge's number, and the vertex."""
        number = np.repeat(np.arange(len(ends)), self.sizes[ends].sum(axis=1))
        return number, self.neighbours[corners_of(self.offsets, ends.ravel())]

    def at(self, vertices):
        """The corners of the triangles at vertices (k,): the number of the vertex among these, and the corner."""
        number = np.repeat(np.arange(len(vertices)), self.sizes[vertices])
        return number, self.corners[corners_of(self.offsets, vertices)]

    def common(self, ends):
        """How many vertices are neighbours of both ends of edges: (e,) int array."""
        number, vertex = self.around(ends)
        keys = np.sort(number * np.int64(len(self.sizes)) + vertex)
        return np.bincount(keys[1:][keys[1:] == keys[:-1]] // len(self.sizes), minlength=len(ends))


def rim(triangles, count):
    """Which of so many vertices are on the boundary of a part of a closed surface: (count,) bool array."""
    start, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    alone = ~np.isin(start * np.int64(count) + end, end * np.int64(count) + start)
    found = np.full(count, False)
    found[start[alone]] = found[end[alone]] = True
    return found


def touching(triangles, vertices, count):
    """Which triangles are at some of so many vertices: (t,) bool array."""
    some = np.full(count, False)
    some[vertices] = True
    return some[triangles].any(axis=1)

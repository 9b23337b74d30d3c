# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Absorbing: a corner of a thin triangle goes into its neighbour, be that far, where the surface stays in place."""

import numpy as np

from ..vectors import cross, dot, norms, unit
from .contracting import drawn_in, together
from .heights import OTHER, heights
from .stars import Stars, rim


def absorbed(vertices, triangles, thin, fixed):
    """Contract sides of thin triangles along which a vertex may move without moving the surface by more than that.

    Parameters
    ----------
    vertices : (n, 3) float array
        They stay where they are.
    triangles : (t, 3) int array
        A closed manifold, or a part of one, at whose boundary nothing changes.
    thin : float
        Triangles that are less high above their longest side are thin, in metres: so far the surface may move.
    fixed : (n,) bool array
        The vertices that are to stay.

    Returns
    -------
    triangles : (t, 3) int array
        With the vertices that are left; the same array where nothing could be done.
    kept : (t,) bool array
        Which triangles are still some.

    Examples
    --------
    The fifth vertex of this tetrahedron is next to the edge from the first to the second, and flat on both sides of it:

    >>> vertices = np.array([(0, 0, 0), (2, 0, 0), (0, 2, 0), (0, 0, 2), (1, 0, 1e-9)])
    >>> sides = np.array([(0, 2, 1), (0, 3, 2), (1, 2, 3), (0, 1, 4), (0, 4, 3), (4, 1, 3)])
    >>> triangles, kept = absorbed(vertices, sides, 1e-6, np.full(5, False))
    >>> int(kept.sum()), len(np.unique(triangles[kept]))
    (4, 4)
    """
    kept, outer = np.full(len(triangles), True), rim(triangles, len(vertices))
    while True:
        going, staying = sides_of_thin(vertices, triangles[kept], thin)
        may = ~(fixed[going] | outer[going] | outer[staying])
        going, staying = going[may], staying[may]
        good = in_place(vertices, triangles[kept], going, staying, thin)
        going, staying = going[good], staying[good]
        chosen = together(triangles[kept], going, staying, len(vertices))
        if not len(chosen):
            return triangles, kept
        triangles, kept = drawn_in(triangles, going[chosen], staying[chosen], len(vertices))


def sides_of_thin(vertices, triangles, thin):
    """The sides of thin triangles, either way round, the shortest first: from which vertex to which."""
    bad = triangles[heights(vertices, triangles)[0] < thin]
    going = np.concatenate((bad, bad)).ravel()
    staying = np.concatenate((bad[:, OTHER], np.roll(bad, 1, axis=1))).ravel()
    order = np.argsort(norms(vertices[going] - vertices[staying]), kind="stable")
    return going[order], staying[order]


def in_place(vertices, triangles, going, staying, thin):
    """Whether the triangles at vertices that go stay in their planes, look the same way, and none becomes thin."""
    number, corner = Stars(triangles, len(vertices)).at(going)
    before = triangles[corner // 3]
    lasting = (before != staying[number, None]).all(axis=1)
    number, corner, before = number[lasting], corner[lasting], before[lasting]
    after = before.copy()
    after[np.arange(len(after)), corner % 3] = staying[number]
    low, high = heights(vertices, before)[0], heights(vertices, after)[0]
    normal, turned = normals(vertices, before), normals(vertices, after)
    moved = np.abs(dot(normal, vertices[staying[number]] - vertices[going[number]]))
    good = (low < thin) | ((moved <= thin) & (dot(normal, turned) > 0))  # of a thin one the normal is rounding
    good &= high >= np.minimum(low, thin)
    return np.bincount(number, ~good, len(going)) == 0


def normals(vertices, triangles):
    """The unit normals of triangles: (t, 3) float array."""
    a, b, c = vertices[triangles].swapaxes(0, 1)
    return unit(cross(b - a, c - a))

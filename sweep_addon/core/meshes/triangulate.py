# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangles that fill polygons with holes, from their own points: many ears are cut at once."""

import numpy as np

from ..contours.ranges import ranges
from ..vectors import dot
from .boundary import Boundary

FLAT = 1e-7  # of its longest side: a triangle of less height is none in Blender's single precision
FEW = 32  # where a round cuts less than this part of the nodes, dividing what is left is quicker


def triangulate(points, loops):
    """Fill polygons with holes by triangles whose corners are the given points.

    Parameters
    ----------
    points : (m, 2) float array
        Different points.
    loops : sequence of (n,) int arrays
        Outer loops counter-clockwise and holes clockwise, as indices of points; loops neither cross nor touch.

    Returns
    -------
    (t, 3) int array
        Counter-clockwise triangles: points + 2 x holes - 2 of them for one outer loop. Each edge of the loops is an
        edge of one triangle, any other edge of two, so that a cap closes the tube it lies on. Points in the middle of
        a straight side are kept, and no triangle is flat.

    Raises
    ------
    ShapeError
        For loops that are no boundary of an area.

    Source
    ------
    Meisters: Polygons have ears, 1975. Ears whose tips are not neighbours do not overlap, so all of them can be cut
    at once; a polygon is used up in few rounds of array operations.

    Examples
    --------
    >>> square = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    >>> len(triangulate(square, [np.arange(4)]))
    2
    >>> ring = np.concatenate([3 * square, 1 + square[::-1]])
    >>> len(triangulate(ring, [np.arange(4), np.arange(4, 8)]))
    8
    """
    boundary = Boundary(np.asarray(points, dtype=np.float64), loops)
    boundary.join_holes()
    found, divided = [], np.inf
    while left := boundary.left.sum():
        found.append(boundary.cut(far_apart(boundary, *ears(boundary))))
        if len(found[-1]) * FEW < left < divided / 2:
            boundary.divide()
            divided = left
    return np.concatenate(found)


def ears(boundary):
    """The nodes that can be cut, and the squared length of the side that takes each one's place.

    A corner is an ear where it turns left and its triangle, edges included, holds no other corner of the boundary; it
    is enough to look at those that do not turn left. Where no triangle is clearly an ear, a doubtful one will do.
    """
    nodes = np.flatnonzero(boundary.left)
    corners = boundary.point[np.stack([boundary.before[nodes], nodes, boundary.after[nodes]], axis=1)]
    a, b, c = boundary.points[corners].swapaxes(0, 1)
    height, side = heights(a, c, b), dot(c - a, c - a)
    for flat in (FLAT, 0.0):
        convex = -height > flat
        blocking = np.unique(corners[~convex, 1])
        free = np.flatnonzero(convex)
        free = free[~occupied(boundary.points, corners[free], blocking, flat)]
        if len(free):
            return nodes[free], side[free]
    doubtful = height.argmin(keepdims=True)
    return nodes[doubtful], side[doubtful]


def heights(a, b, places):
    """(n,) float array: how far places lie to the left of the lines from a to b, as a part of the longest side."""
    u, v = b - a, places - a
    longest = np.maximum(dot(u, u), dot(v, v))
    return (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / np.where(longest, longest, 1)


def occupied(points, triangles, others, margin):
    """(t,) bool array: which (t, 3) triangles, edges included, hold one of the other points that is no corner."""
    others = others[np.argsort(points[others, 0], kind="stable")]
    corners = points[triangles]
    low, high = corners.min(axis=1), corners.max(axis=1)
    room = margin * (high - low).max(axis=1, keepdims=True)
    low, high = low - room, high + room
    first = np.searchsorted(points[others, 0], low[:, 0], side="left")
    count = np.searchsorted(points[others, 0], high[:, 0], side="right") - first
    found = np.zeros(len(triangles), dtype=bool)
    for t, v in ranges(first, count):
        v = others[v]
        near = (points[v, 1] >= low[t, 1]) & (points[v, 1] <= high[t, 1]) & (triangles[t] != v[:, None]).all(axis=1)
        t, v = t[near], v[near]
        for i in range(3):
            inner = heights(corners[t, i - 1], corners[t, i], points[v]) >= -margin
            t, v = t[inner], v[inner]
        found[t] = True
    return found


def far_apart(boundary, nodes, length):
    """Of the ears those with short new sides, without neighbours; which of two neighbours is by a fixed dice."""
    nodes = nodes[length <= np.median(length)]
    rank = np.full(len(boundary.left), -1, dtype=np.int64)
    rank[nodes] = (nodes * 2654435761) % (1 << 32) * len(rank) + nodes
    after, before = boundary.after[nodes], boundary.before[nodes]
    opposite = boundary.after[after]
    rival = np.maximum(rank[after], rank[before])
    rival = np.where(opposite == boundary.before[before], np.maximum(rival, rank[opposite]), rival)
    return nodes[rank[nodes] > rival]

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The nearest point of a mesh, for many points at once, by one descent of the tree for all of them."""

import numpy as np

from ..declared.frozen import individual
from ..vectors import dot, norms
from .tree import FAN
from .triangles import nearest_places, squared_distances

CHUNK = 1024  # points whose pairs with nodes, of eighteen numbers each, fit into a processor's own cache
RELATIVE, ABSOLUTE = 4e-6, 1e-6  # of distances and of the size: rounding in single precision, with room
SAME = 1e-12  # of the size: what is no farther apart has nothing between


@individual
class Nearest:
    """Where a mesh is nearest to some points.

    Parameters
    ----------
    places : (n, 3) float array
        The nearest points of the mesh, in metres.
    distances : (n,) float array
        How far they are, in metres.
    faces : (n,) int array
        The triangles they lie on; -1 where nothing is within the limit: then the distance is the limit.
    parts : (n,) int array
        The part of the triangle, as `triangles.closest` numbers them.
    torn : (n,) bool array
        Whether another place is as near and the point on its other side, as beside a slit with nothing between; told
        where the normals were given.
    """

    places: np.ndarray
    distances: np.ndarray
    faces: np.ndarray
    parts: np.ndarray
    torn: np.ndarray


def nearest(tree, points, hints=None, limit=np.inf, normals=None):
    """Find the nearest point of a mesh to each of some points.

    Parameters
    ----------
    tree : Tree
    points : (n, 3) float array
    hints : (n, 3) float array, optional
        A point of the mesh for each of them: the search is quicker where it is not much farther than the nearest one.
    limit : float
        What is farther does not count, in metres.
    normals : PseudoNormals, optional
        Tell where the sides of the mesh are.

    Returns
    -------
    Nearest

    The search is in single precision with room for its rounding, and the triangles that may be nearest after it are
    compared in double precision: the result is exact but for that one's rounding.

    Examples
    --------
    >>> from .tree import Tree
    >>> floor = Tree.of(np.array([[(0.0, 0.0, 0.0), (4.0, 0.0, 0.0), (0.0, 4.0, 0.0)]]))
    >>> nearest(floor, np.array([(1.0, 1.0, 2.0), (-3.0, 0.0, 4.0)])).distances.tolist()
    [2.0, 5.0]
    """
    found = unfound(len(points), limit)
    for start in range(0, len(points), CHUNK):
        here = slice(start, start + CHUNK)
        parts = searched(tree, points[here], None if hints is None else hints[here], limit, normals)
        for whole, part in zip(found, parts, strict=True):
            whole[here] = part
    return Nearest(*found)


def unfound(count, limit):
    """The arrays of a `Nearest` of so many points that are near nothing."""
    found = np.zeros((count, 3)), np.full(count, limit, dtype=float), np.full(count, -1)
    return *found, np.zeros(count, dtype=int), np.zeros(count, dtype=bool)


def searched(tree, points, hints, limit, normals):
    """The arrays of what `nearest` finds, for so few points that all pairs fit into memory at once."""
    near = np.ascontiguousarray((points - tree.middle).T, dtype=np.float32)
    room = np.float32(ABSOLUTE * max(tree.size, float(np.abs(near).max(initial=0))))
    bound = np.full(len(points), min(limit, 1e18), dtype=np.float32)
    if hints is not None:
        bound = np.minimum(bound, norms(points - hints).astype(np.float32))
    bound = bound * np.float32(1 + RELATIVE) + room
    point, leaf = leaves(tree, near, bound, room)
    each = tree.order.shape[1]
    owner = np.repeat(point, each)
    squares = squared_distances(near.take(owner, axis=1), runs(tree.rows, each, leaf))
    best = lowest(squares, point, len(points))
    reach = np.minimum(np.sqrt(best) * np.float32(1 + RELATIVE) + room, bound)
    kept = np.flatnonzero(squares <= (reach * reach).take(owner))
    return compared(tree, points, owner.take(kept), tree.order.ravel().take(within(leaf, each, kept)), limit, normals)


def leaves(tree, near, bound, room):
    """Pairs of points and leaves, among whose triangles is the nearest one of each: two (p,) arrays, points rising."""
    count, each = near.shape[1], tree.levels[-1].shape[1]
    point, node = np.arange(count), np.zeros(count, dtype=np.int64)  # all below one root
    for boxes in reversed(tree.levels):
        owner = np.repeat(point, each)
        places = near.take(owner, axis=1)
        centre, first, second, third, half, sample = runs(boxes, each, node).reshape(6, 3, -1)
        sample -= places
        upper = lowest(inner(sample, sample), point, count)
        bound = np.minimum(bound, np.sqrt(upper) * np.float32(1 + RELATIVE) + room)
        centre -= places
        beyond = [np.abs(inner(centre, axis)) - size for axis, size in zip((first, second, third), half, strict=True)]
        x, y, z = (np.maximum(part, 0, out=part) for part in beyond)
        kept = np.flatnonzero(x * x + y * y + z * z <= (bound * bound).take(owner))
        point, node, each = owner.take(kept), within(node, each, kept), FAN
    return point, node


def inner(a, b):
    """The products of vectors with one another, (3, n) twice to (n,)."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def runs(rows, each, which):
    """Some of the runs of so many columns: (k, each n) and (p,) to (k, each p); each is looked up as a whole."""
    return rows.reshape(len(rows), -1, each).take(which, axis=1).reshape(len(rows), -1)


def within(runs, each, which):
    """The numbers of columns in all, of those that are some in runs (p,) one after the other: (k,)."""
    run = which // each
    return each * runs.take(run) + which - each * run


def lowest(values, point, count):
    """The lowest of the values of each point, as many for each of (p,), points rising; infinite where there are none.

    Returns
    -------
    (count,) array
    """
    found = np.full(count, np.inf, dtype=values.dtype)
    if len(values):
        first = np.flatnonzero(np.append(True, point[1:] != point[:-1]))
        found[point[first]] = np.minimum.reduceat(values, len(values) // len(point) * first)
    return found


def compared(tree, points, point, face, limit, normals):
    """The nearest of the triangles that pairs name, points rising, in double precision; of equally near the first."""
    there = points.take(point, axis=0)
    places, parts = nearest_places(there, tree.exact.take(face))
    distances = norms(there - places)
    least = lowest(distances, point, len(points)).take(point)
    found = *_, torn = unfound(len(points), limit)
    if normals is not None:
        room = SAME * (tree.size + least)
        level = np.flatnonzero((distances <= least + room) & (least > room))
        outside = dot((there - places)[level], normals.parts[face[level], parts[level]]) >= 0
        torn[on_both_sides(point[level], outside)] = True
    best = np.flatnonzero(distances == least)
    if (point[best[1:]] == point[best[:-1]]).any():
        best = best[np.lexsort((face[best], point[best]))]
        best = best[np.append(True, point[best[1:]] != point[best[:-1]])]
    best = best[distances[best] <= limit]
    where = point[best]
    for whole, part in zip(found, (places, distances, face, parts), strict=False):
        whole[where] = part[best]
    return found


def on_both_sides(point, outside):
    """The points, rising, that some of their pairs have outside and some not."""
    differ = (point[1:] == point[:-1]) & (outside[1:] != outside[:-1])
    return point[:-1][differ]

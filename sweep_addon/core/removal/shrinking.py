# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shrinking: a body drawn in by a hair, for parts that touch each other as they stand.

No point of the surface moves farther than the contact tolerance. On its straight way it passes all points of the body
that the drawn in one has lost, each no farther from where it ends than that. So were a point of the body deeper in
another one than the tolerance, a point of the drawn in body would be in it too; and that one touches nothing.
"""

import numpy as np

from ..vectors import cross, dot, norms, unit
from .bodies import Body

ROUNDS = 64  # of the search for the direction that looks along all faces around a vertex
HALVINGS = 12  # of how far a vertex of a thin part moves
BEYOND, SHALLOW = 1.5, 0.5  # so many times as far in, no other face is to be nearer than this part of its own ones
AGAINST = 1e-3  # cosine: a vertex around which faces look all ways stays where it is


def drawn_in(body, by):
    """A body whose vertices have moved into it by a length in metres, each away from all faces around it.

    Where it is thin they move less far: so that they do not come to where those of its other side were to go.
    """
    (outward, least), lengths = outward_directions(body), np.full(len(body.vertices), float(by))
    left = np.flatnonzero(norms(outward) > 0) if by else np.zeros(0, dtype=int)
    for _ in range(HALVINGS):
        reached = BEYOND * lengths[left]
        depths = body.depths(body.vertices[left] - reached[:, None] * outward[left])
        left = left[depths < SHALLOW * least[left] * reached]
        if not len(left):
            break
        lengths[left] /= 2
    return Body(body.name, body.vertices - lengths[:, None] * outward, body.triangles)


def outward_directions(body):
    """Unit vectors that look along the normals of all faces around each vertex, as far as one can.

    Returns
    -------
    (n, 3) float array, (n,) float array
        The vectors, and the least of their products with those normals; both are 0 where none looks along all.

    Source
    ------
    Gilbert: An iterative procedure for computing the minimum of a quadratic form on a convex set, SIAM J. Control 4(1),
    1966: the point of the hull of the normals that is nearest to zero has the largest least product with all of them.
    """
    a, b, c = body.corners.swapaxes(0, 1)
    normals = unit(cross(b - a, c - a))
    vertex = body.triangles.T.ravel()
    order = np.argsort(vertex, kind="stable")
    vertex, around = vertex[order], np.tile(normals, (3, 1))[order]
    first = np.flatnonzero(np.append(True, vertex[1:] != vertex[:-1]))
    which = np.repeat(np.arange(len(first)), np.diff(np.append(first, len(vertex))))
    found = unit(np.add.reduceat(around, first, axis=0))
    for _ in range(ROUNDS):
        products = dot(around, found[which])
        least = np.minimum.reduceat(products, first)
        worst = np.full(len(first), len(vertex))
        np.minimum.at(worst, which, np.where(products <= least[which], np.arange(len(vertex)), len(vertex)))
        way = around[worst] - found
        squares = dot(way, way)
        part = np.clip(-dot(found, way) / np.where(squares > 0, squares, 1.0), 0.0, 1.0)
        found = found + part[:, None] * way
    least = np.minimum.reduceat(dot(around, found[which]), first)
    found[(least <= AGAINST * norms(found)) | (norms(found) < AGAINST)] = 0.0
    made, products = np.zeros_like(body.vertices), np.zeros(len(body.vertices))
    made[vertex[first]] = unit(found)
    products[vertex[first]] = np.minimum.reduceat(dot(around, unit(found)[which]), first)
    return made, products

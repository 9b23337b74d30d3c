# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Between which distances from a mesh each triangle lies: proved, whatever the mesh."""

import numpy as np

from ..distance.triangles import closest
from ..vectors import cross, dot, norms

THIN = 1e-6  # of the square of its sides is twice the area of a triangle, squared: with less its centre is not told
FAR = 100.0  # sides from a triangle a centre may be


def distance_interval(places, triangles, distances, nearest):
    """Bounds of the distance from a mesh on each triangle, from the distances of its corners.

    Parameters
    ----------
    places : (n, 3) float array
        In metres.
    triangles : (t, 3) int array
    distances : (n,) float array
        How far each place is from the mesh, in metres.
    nearest : (n, 3) float array
        Where the mesh is nearest to it.

    Returns
    -------
    lower, upper : (t,) float arrays
        No point of the triangle is nearer, or farther, in metres.

    Lower: the square of a place less the square of its distance is convex, as the largest of many linear functions, and
    so at most what is linear between the corners: `least`. Upper: no point is farther than from the nearest point of
    any one corner, and so than their mean, in squares, by any weights. By the weights that make the point of the
    corners the squares come to those of the corners and, for each two, the product of both weights times how much
    farther apart, in squares, the nearest points are than the ways to them; and such products sum to a third at most.

    Examples
    --------
    One triangle of an octahedron about a single point: from its corners at 1 m down to its middle at 0.577 m.

    >>> lower, upper = distance_interval(np.eye(3), np.array([(0, 1, 2)]), np.ones(3), np.zeros((3, 3)))
    >>> lower.round(3).tolist(), upper.tolist()
    ([0.577], [1.0])

    A triangle of two equal sides of 3 m, 4 m above a plane: what is known of the corners allows √(4² + 18/3) m.

    >>> triangle = np.array([(0.0, 0.0, 4.0), (3.0, 0.0, 4.0), (0.0, 3.0, 4.0)])
    >>> lower, upper = distance_interval(triangle, np.array([(0, 1, 2)]), np.full(3, 4.0), triangle * (1, 1, 0))
    >>> lower.round(3).tolist(), upper.round(3).tolist()
    ([3.391], [4.69])
    """
    corners, origins = places[triangles], nearest[triangles]
    squares = distances[triangles] ** 2
    farthest = norms(corners[:, :, None] - origins[:, None]).max(axis=1).min(axis=1)
    apart = [part - np.roll(part, -1, axis=1) for part in (origins, corners - origins)]
    more = np.maximum(dot(apart[0], apart[0]) - dot(apart[1], apart[1]), 0).max(axis=1) / 3
    mean = np.sqrt(squares.max(axis=1) + more)
    return np.sqrt(np.maximum(least(corners, squares), 0)), np.minimum(farthest, mean)


def least(corners, squares):
    """The least on triangles (t, 3, 3) of what is `squares` (t, 3) at their corners and rises as the square of a way.

    It is the square of the way from one centre, and a constant. Where that centre is too far for rounding it is put at
    the lowest corner less the square of the radius of the smallest circle around the triangle, which is less.
    """
    one, two = (corners[:, i] - corners[:, 0] for i in (1, 2))
    a, b, c = dot(one, one), dot(one, two), dot(two, two)
    right = [(length + squares[:, 0] - squares[:, i]) / 2 for i, length in ((1, a), (2, c))]
    area = a * c - b * b
    far = area <= THIN * a * c
    area[far] = 1.0
    weights = (c * right[0] - b * right[1]) / area, (a * right[1] - b * right[0]) / area
    centres = corners[:, 0] + weights[0][:, None] * one + weights[1][:, None] * two
    far |= np.abs(weights).max(axis=0) > FAR
    centres[far] = corners[far, 0]
    away = centres - closest(centres, corners)[0]
    found = squares[:, 0] - norms(centres - corners[:, 0]) ** 2 + dot(away, away)
    return np.where(far, squares.min(axis=1) - enclosing(corners) ** 2, found)


def enclosing(corners):
    """The radii of the smallest circles around triangles (t, 3, 3), in metres: (t,) float array."""
    one, two = (corners[:, i] - corners[:, 0] for i in (1, 2))
    a, b, c = (dot(side, side) for side in (one, two, two - one))
    longest = np.maximum(np.maximum(a, b), c)
    area = norms(cross(one, two))
    acute = longest < a + b + c - longest
    circle = np.sqrt(a * b * c) / np.where(acute, 2 * area, 1)
    return np.where(acute, circle, np.sqrt(longest) / 2)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Between which distances from a mesh each triangle lies: proved, whatever the mesh."""

import numpy as np

from ..vectors import cross, dot, norms


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

    Lower: the square of a place less the square of its distance is convex, as the largest of many linear functions. So
    on a triangle the square of the distance is at least the smallest at a corner less the square of the radius of the
    smallest circle around it. Upper: no point is farther than from the nearest point of any one corner, and that
    distance is convex.

    Examples
    --------
    One triangle of an octahedron about a single point: from its corners at 1 m down to its middle at 0.577 m.

    >>> lower, upper = distance_interval(np.eye(3), np.array([(0, 1, 2)]), np.ones(3), np.zeros((3, 3)))
    >>> lower.round(3).tolist(), upper.tolist()
    ([0.577], [1.0])
    """
    corners, origins = places[triangles], nearest[triangles]
    squares = (distances[triangles] ** 2).min(axis=1) - enclosing(corners) ** 2
    farthest = norms(corners[:, :, None] - origins[:, None]).max(axis=1).min(axis=1)
    return np.sqrt(np.maximum(squares, 0)), farthest


def enclosing(corners):
    """The radii of the smallest circles around triangles (t, 3, 3), in metres: (t,) float array."""
    sides = np.roll(corners, -1, axis=1) - corners
    squares = np.sort(dot(sides, sides), axis=1)
    area = norms(cross(sides[:, 0], sides[:, 1]))
    acute = squares[:, 2] < squares[:, 0] + squares[:, 1]
    circle = np.sqrt(squares.prod(axis=1)) / np.where(acute, 2 * area, 1)
    return np.where(acute, circle, np.sqrt(squares[:, 2]) / 2)

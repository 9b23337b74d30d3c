# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A point and a triangle: how far apart they are, roughly and quickly, or exactly, and which part is nearest."""

import numpy as np

from ..declared.frozen import individual
from ..stations.rotations import any_normal
from ..vectors import cross, dot, norms, unit

INTERIOR, EDGE, VERTEX = (
    0,
    1,
    4,
)  # parts of a triangle: edge i from corner i to the next is EDGE + i, corner i VERTEX + i
THIN = 1e-12  # of its longest side: a triangle of less height is its longest side


def placed(corners):
    """Each triangle in its own plane, with its longest side along the first axis.

    Parameters
    ----------
    corners : (m, 3, 3) float array

    Returns
    -------
    (18, m) float array
        An end of the longest side, both axes and the normal of the plane, and the length of that side; of the sides
        from both of its ends to the third corner the direction in the plane and the length.
    """
    lengths = norms(np.roll(corners, -1, axis=1) - corners)
    order = (lengths.argmax(axis=1)[:, None] + np.arange(3)) % 3
    a, b, c = np.take_along_axis(corners, order[:, :, None], axis=1).swapaxes(0, 1)
    x = unit(b - a)
    x[~x.any(axis=1)] = (1.0, 0.0, 0.0)
    along = dot(c - a, x)
    across = c - a - along[:, None] * x
    flat = norms(across) <= THIN * norms(b - a)
    across[flat] = any_normal(x[flat])
    y = unit(across)
    length, height = dot(b - a, x), np.where(flat, 0.0, dot(c - a, y))
    sides = [np.stack((along - start, height), axis=1) for start in (length, 0.0)]
    directions = [np.append(unit(side), norms(side)[:, None], axis=1) for side in sides]
    return np.concatenate((a, x, y, cross(x, y), length[:, None], *directions), axis=1).T


def squared_distances(points, triangles):
    """Squared distances of points (3, n) from as many placed triangles (18, n), in the precision of these.

    Components are rows: arithmetic on whole rows takes a quarter of the time that it takes on columns.
    """
    px, py, pz = points
    ax, ay, az, xx, xy, xz, yx, yy, yz, zx, zy, zz, length, *sides = triangles
    dx, dy, dz = px - ax, py - ay, pz - az
    p, q = dx * xx + dy * xy + dz * xz, dx * yx + dy * yy + dz * yz
    height = dx * zx + dy * zy + dz * zz
    base = p - np.minimum(np.maximum(p, 0), length)
    found = base * base + q * q
    outside = q <= 0  # on a side is near enough to that side, and a flat triangle has no inside
    for start, (ux, uy, far), turn in ((p - length, sides[:3], 1), (p, sides[3:], -1)):
        t = np.minimum(np.maximum(start * ux + q * uy, 0), far)
        u, v = start - t * ux, q - t * uy
        found = np.minimum(found, u * u + v * v)
        outside |= turn * (ux * q - uy * start) <= 0
    return found * outside + height * height


def closest(points, corners):
    """The nearest point of triangles, and which part of each it lies on.

    Parameters
    ----------
    points : (n, 3) float array
    corners : (n, 3, 3) float array
        A triangle for each point.

    Returns
    -------
    places : (n, 3) float array
    part : (n,) int array
        0 inside the triangle, 1 + i on the edge from corner i to the next, 4 + i at corner i.

    Examples
    --------
    >>> triangle = np.array([[(0.0, 0.0, 0.0), (4.0, 0.0, 0.0), (0.0, 4.0, 0.0)]])
    >>> closest(np.array([(1.0, 1.0, 5.0)]), triangle)
    (array([[1., 1., 0.]]), array([0]))
    >>> closest(np.array([(3.0, 3.0, 5.0)]), triangle)
    (array([[2., 2., 0.]]), array([2]))
    """
    return nearest_places(points, Exact.of(corners))


@individual
class Exact:
    """Triangles in double precision, with what finding the nearest place of each takes; components are rows.

    Parameters
    ----------
    corners, sides : (3, 3, m) float arrays
        Component by component each corner, and the way from it to the next.
    squares : (3, m) float array
        Of the lengths of the sides; 1 for a side without length.
    normals : (3, m) float array
        As long as twice the area.
    area : (m,) float array
        The square of that; 0 for a triangle that is hardly more than its longest side.
    """

    corners: np.ndarray
    sides: np.ndarray
    squares: np.ndarray
    normals: np.ndarray
    area: np.ndarray

    @classmethod
    def of(cls, corners):
        """Those of corners (m, 3, 3)."""
        corners = np.ascontiguousarray(corners.transpose(2, 1, 0))
        sides = np.roll(corners, -1, axis=1) - corners
        squares = product(sides, sides)
        (ax, ay, az), (bx, by, bz) = sides[:, 0], sides[:, 1]
        normals = np.stack((ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx))
        area = product(normals, normals)
        area[area <= (THIN * squares.max(axis=0)) ** 2] = 0.0
        return cls(corners, sides, np.where(squares > 0, squares, 1.0), normals, area)

    def take(self, which):
        """Some of them, one for each of (n,)."""
        return Exact(*(getattr(self, name).take(which, axis=-1) for name in self.__dataclass_fields__))


def nearest_places(points, triangles):
    """What `closest` finds, of points (n, 3) and as many `Exact` triangles."""
    points, corners, sides = points.T[:, None], triangles.corners, triangles.sides
    away = points - corners
    t = np.minimum(np.maximum(product(away, sides) / triangles.squares, 0.0), 1.0)
    on_edges = corners + t * sides
    off = points - on_edges
    edge = product(off, off).argmin(axis=0)
    row = np.arange(len(edge))
    places, t = on_edges[:, edge, row], t[edge, row]
    ahead, (nx, ny, nz) = (edge + 1) % 3, triangles.normals
    part = np.where(t <= 0, VERTEX + edge, np.where(t < 1, EDGE + edge, VERTEX + ahead))
    (x, y, z), (u, v, w) = sides, away
    within = ((y * w - z * v) * nx + (z * u - x * w) * ny + (x * v - y * u) * nz > 0).all(axis=0)
    inside = np.flatnonzero(within & (triangles.area > 0))
    normals = triangles.normals[:, inside]
    height = product(away[:, 0, inside], normals) / triangles.area[inside]
    places[:, inside] = points[:, 0, inside] - height * normals
    part[inside] = INTERIOR
    return places.T, part


def product(a, b):
    """The products of vectors whose components are rows: (3, ...) twice to (...)."""
    return a[0] * b[0] + a[2] * b[2] + a[1] * b[1]  # in the order of `dot`

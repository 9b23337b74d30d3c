# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rotations of normals about tangents, row by row: (n, 3) float arrays of unit vectors, angles in radians."""

from math import tau

import numpy as np

from ..turns import cosines
from ..vectors import cross, dot, unit


def any_normal(tangents):
    """A unit vector across each tangent, from the axis it is least aligned with."""
    axis = np.eye(3)[np.abs(tangents).argmin(axis=1)]
    return unit(cross(tangents, axis))


def reflect(vectors, normals):
    """Mirror each vector in the plane across its normal; a zero normal mirrors nothing."""
    squared = dot(normals, normals)
    factor = 2 * dot(vectors, normals) / np.where(squared, squared, 1.0)
    return vectors - factor[:, None] * normals


def turned(vectors, start, end):
    """Turn each vector by the least rotation that takes one unit vector to another."""
    return reflect(reflect(vectors, start), start + end)


def signed_angle(start, end, axis):
    """The angle that turns each start onto the projection of its end, about a unit axis."""
    sine = dot(cross(axis, start), end)
    return np.arctan2(sine, dot(start, end))


def rotated(normals, axis, angle):
    """Turn unit normals about the unit axes they are perpendicular to."""
    if not angle.any():
        return normals.copy("K")
    cosine, sine = cosines(angle)
    found, across = cosine[:, None] * normals, cross(axis, normals)
    across *= sine[:, None]
    found += across
    return found


def wrapped(angle, period=tau):
    """An angle between minus and plus half a turn, or half of another period."""
    return (angle + period / 2) % period - period / 2

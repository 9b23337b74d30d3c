# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rotations as quaternions of two complex numbers.

A quaternion a + bi + cj + dk is z + wj with z = a + bi and w = c + di. It turns the axes x, y, z to the turtle's
heading, its left and its up.
"""

import numpy as np


def unit(degrees):
    """(n,) complex array: cosine and sine of angles in degrees, exact for quarters of a turn."""
    degrees = np.asarray(degrees, dtype=np.float64)
    quarter = np.rint(degrees / 90)
    angle = np.radians(degrees - 90 * quarter)
    found = np.empty(angle.shape, dtype=complex)
    found.real, found.imag = np.cos(angle), np.sin(angle)
    return found * QUARTERS[np.mod(quarter, 4).astype(np.intp)]


QUARTERS = np.array([1, 1j, -1, -1j])


def rotation(axis, degrees):
    """The quaternions that turn about an axis: 0 is the heading, 1 the left, 2 up."""
    half = unit(np.asarray(degrees, dtype=np.float64) / 2)
    if axis == 0:
        return half, np.zeros_like(half)
    return half.real + 0j, half.imag * (1 + 0j if axis == 1 else 1j)


def product(first, second):
    """The quaternions that turn by the second in the axes of the first."""
    (z1, w1), (z2, w2) = first, second
    return z1 * z2 - w1 * np.conj(w2), z1 * w2 + w1 * np.conj(z2)


def heading(z, w):
    """The first axis: its x, and y + iz."""
    return z.real**2 + z.imag**2 - w.real**2 - w.imag**2, -2j * z * w


def axes(z, w):
    """(n, 3, 3) float array: heading, left and up as rows."""
    a, b, c, d = z.real, z.imag, w.real, w.imag
    rows = [
        [a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)],
        [2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)],
        [2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d],
    ]
    return np.array(rows).transpose(2, 0, 1)


def taken(pair, places):
    return pair[0].take(places), pair[1].take(places)

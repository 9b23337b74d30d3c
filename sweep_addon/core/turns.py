# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cosines and sines of many angles, which are mostly evenly spaced: along arcs and helices, and of what turns there."""

from math import isqrt

import numpy as np

MANY = 4096  # angles, from which on it takes less time, with the look whether they are evenly spaced
EVEN = 4 * np.finfo(float).eps  # of the largest angle: what rounding makes of evenly spaced ones


def cosines(angles):
    """The cosines and sines of angles in radians, (n,) each; of many that are evenly spaced in half of the time.

    Those are the products of the ones of every so many angles with the ones of the steps between, by the theorem of
    addition: as exact as the angles themselves.

    Examples
    --------
    >>> angles = np.linspace(0.0, 30.0, 5001)
    >>> cosine, sine = cosines(angles)
    >>> bool(np.abs(cosine - np.cos(angles)).max() < 1e-14 and np.abs(sine - np.sin(angles)).max() < 1e-14)
    True
    """
    if len(angles) < MANY or not are_even(angles):
        return np.cos(angles), np.sin(angles)
    width = isqrt(len(angles))
    step = (angles[-1] - angles[0]) / (len(angles) - 1)
    (a, b), (c, d) = ((np.cos(each), np.sin(each)) for each in (angles[::width, None], step * np.arange(width)))
    return tuple(found.ravel()[: len(angles)] for found in (a * c - b * d, b * c + a * d))


def are_even(angles):
    """Whether angles are evenly spaced but for rounding; most that are not are told by one of them."""
    first, last, third = angles[0], angles[-1], len(angles) // 3
    step, slack = (last - first) / (len(angles) - 1), EVEN * max(abs(first), abs(last))
    if not abs(angles[third] - first - third * step) <= slack:
        return False
    return bool(np.abs(angles - first - step * np.arange(len(angles))).max() <= slack)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cosines and sines of many angles, which are mostly evenly spaced: along arcs and helices, and of what turns there."""

from math import isqrt

import numpy as np

MANY = 256  # angles, from which on it takes less time to look whether they are evenly spaced
EVEN = 4 * np.finfo(float).eps  # of the largest angle: what rounding makes of evenly spaced ones


def cosines(angles):
    """The cosines and sines of angles in radians, (n,) each; of evenly spaced ones in a third of the time.

    Those are the products of the ones of every so many angles with the ones of the steps between, by the theorem of
    addition: as exact as the angles themselves.

    Examples
    --------
    >>> angles = np.linspace(0.0, 30.0, 1001)
    >>> cosine, sine = cosines(angles)
    >>> bool(np.abs(cosine - np.cos(angles)).max() < 1e-14 and np.abs(sine - np.sin(angles)).max() < 1e-14)
    True
    """
    if len(angles) < MANY:
        return np.cos(angles), np.sin(angles)
    steps = np.arange(len(angles)) * ((angles[-1] - angles[0]) / (len(angles) - 1))
    off = np.abs(angles - angles[0] - steps).max()
    if not off <= EVEN * max(abs(angles[0]), abs(angles[-1])):
        return np.cos(angles), np.sin(angles)
    width = isqrt(len(angles))
    far, near = angles[::width, None], steps[:width]
    (a, b), (c, d) = ((np.cos(each), np.sin(each)) for each in (far, near))
    return tuple(found.ravel()[: len(angles)] for found in (a * c - b * d, b * c + a * d))

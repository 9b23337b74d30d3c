# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Directions: points of the unit sphere."""

import numpy as np


def spread(step):
    """Directions about a step apart everywhere, (n, 3) float array: on circles about the z axis.

    Examples
    --------
    >>> spread(np.pi / 2).round(9).tolist()
    [[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [-0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]
    """
    circles = int(np.ceil(np.pi / step - 1e-9)) + 1
    latitude = np.linspace(-np.pi / 2, np.pi / 2, circles)
    count = np.maximum(np.ceil(2 * np.pi * np.cos(latitude) / step - 1e-9).astype(int), 1)
    on = np.repeat(np.arange(circles), count)
    angle = 2 * np.pi * (np.arange(len(on)) - np.repeat(np.cumsum(count) - count, count)) / count[on]
    z, out = np.sin(latitude)[on], np.cos(latitude)[on]
    out[[0, -1]] = 0.0
    return np.stack((out * np.cos(angle), out * np.sin(angle), z), axis=1)


def globe(sides):
    """The corners of a ball of as many meridians, a multiple of four: (n, 3) float array.

    Its circles of latitude are as far apart as its meridians at the equator. Balls with the same axis share facets,
    which a union of many of them needs.

    Examples
    --------
    >>> len(globe(4)), len(globe(16))
    (6, 114)
    """
    latitude = np.pi * np.arange(1, sides // 2) / (sides // 2) - np.pi / 2
    longitude = 2 * np.pi * np.arange(sides) / sides
    out = np.cos(latitude)[:, None]
    circles = np.stack(np.broadcast_arrays(out * np.cos(longitude), out * np.sin(longitude), np.sin(latitude)[:, None]))
    return np.concatenate(([(0.0, 0.0, -1.0)], circles.reshape(3, -1).T, [(0.0, 0.0, 1.0)]))

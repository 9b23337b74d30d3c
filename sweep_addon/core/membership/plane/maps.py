# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What linear maps of the plane make of lengths; they are (n, 2, 2), lower left 0."""

import numpy as np


def slopes(outward, maps):
    """By what a distance that grows along directions (n, 2) grows where maps take all: (n,)."""
    a, b, d = maps[:, 0, 0], maps[:, 0, 1], maps[:, 1, 1]
    first = outward[:, 0] / a
    return np.hypot(first, (outward[:, 1] - b * first) / d)


def narrowest(maps):
    """How much maps (n, 2, 2) stretch at least: (n,)."""
    return maps[:, 0, 0] * maps[:, 1, 1] / widest(maps)


def widest(maps):
    """How much they stretch at most: (n,)."""
    squares, product = (maps**2).sum(axis=(1, 2)), maps[:, 0, 0] * maps[:, 1, 1]
    return np.sqrt((squares + np.sqrt(np.maximum(squares**2 - 4 * product**2, 0.0))) / 2)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Boxes along the axes: their corners, places scattered in them, and how far points are from them."""

import numpy as np

from ...vectors import norms

APART = 0.5  # of a body's size: what is farther from its box is as far from the body, or farther
SPREAD = 1.25  # of the box: so far places are scattered, and those beyond it are moved to its sides


def corners(box):
    """The corners of a box (2, 3): (8, 3)."""
    return np.stack(np.meshgrid(*box.T, indexing="ij"), axis=-1).reshape(-1, 3)


def scattered(box, count):
    """Places in a box, its corners and others by Kronecker's sequence, some of them on its sides: (count, 3).

    Source
    ------
    Roberts: The unreasonable effectiveness of quasirandom sequences, 2018: the steps are powers of the root of
    x^4 = x + 1.
    """
    root = 1.2207440846057596
    parts = (0.5 + np.arange(1, count - 7)[:, None] / root ** np.arange(1, 4)) % 1.0
    parts = np.clip(0.5 + SPREAD * (parts - 0.5), 0.0, 1.0)
    return np.concatenate((corners(box), box[0] + parts * (box[1] - box[0])))


def from_box(points, low, high):
    """How far points (n, 3) are from a box, or each from its own, 0 inside: (n,)."""
    return norms(np.maximum(np.maximum(low - points, points - high), 0.0))

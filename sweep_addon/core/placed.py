# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The vertices of a sweep in the order of its grid."""

import numpy as np


def placed(grid, weights, rings, dtype=np.float64):
    """The vertices, column by column, then tips, then poles: one matrix product of the section with the rings.

    Parameters
    ----------
    grid : Grid
    weights : (m, k) float array
        Of each point of the section: 1 and its coordinates, or what else its place is made of.
    rings : (k, n, 3) float array
        At each station what has these weights: the place of the section's origin and its axes.
    dtype : numpy dtype

    Returns
    -------
    (v, 3) array
    """
    weights, rings = weights.astype(dtype), rings.astype(dtype)
    whole = rings[:, grid.whole].reshape(len(rings), -1)
    tips = rings[0, list(grid.tips)]
    return np.concatenate(((weights @ whole).reshape(-1, 3), tips)) if len(tips) else (weights @ whole).reshape(-1, 3)

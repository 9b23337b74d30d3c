# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Linear maps of space, and the way back through them, also where they are flat."""

import numpy as np

SINGULAR = 1e-12  # a determinant of less turns no way back, of a map whose largest number is 1
LEAST = 1e-300


def solved(maps, vectors, aside=SINGULAR):
    """What linear maps take to vectors, nearly so where they are flat.

    Parameters
    ----------
    maps : (..., 3, 3) float array
    vectors : (..., 3) float array
    aside : float
        How much is added to maps that are flat, as a part of their size.

    Returns
    -------
    (..., 3) float array

    Examples
    --------
    >>> solved(np.diag((2.0, 1.0, 0.5)), np.ones(3)).tolist()
    [0.5, 1.0, 2.0]
    """
    maps = np.nan_to_num(maps)
    size = np.abs(maps).max(axis=(-2, -1), initial=0.0, keepdims=True)
    flat = np.abs(np.linalg.det(maps / np.where(size > 0, size, 1.0))) < SINGULAR
    maps = np.where(flat[..., None, None], maps + (aside * size + LEAST) * np.eye(3), maps)
    return (np.linalg.inv(maps) @ vectors[..., None])[..., 0]

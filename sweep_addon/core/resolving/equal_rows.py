# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Equal rows: places that are the same to the last bit."""

import numpy as np

MIXED = np.array([0x9E3779B97F4A7C15, 0xC2B2AE3D27D4EB4F, 0x165667B19E3779F9], np.uint64)  # odd, their bits at random


def equal_rows(rows, others):
    """The number of the other row that each row is equal to, -1 for none.

    Parameters
    ----------
    rows : (n, 3) float array
    others : (k, 3) float array

    Returns
    -------
    (n,) int array

    Examples
    --------
    >>> equal_rows(np.eye(3), np.array([(0.0, 0.0, 1.0), (1.0, -0.0, 0.0)])).tolist()
    [1, -1, 0]

    Places opposite each other do not hide each other:

    >>> equal_rows(np.array([(-1.0, -2.0, 3.0)]), np.array([(1.0, 2.0, 3.0), (-1.0, -2.0, 3.0)])).tolist()
    [1]
    """
    if not len(others):
        return np.full(len(rows), -1)
    keys = mixed(others)
    order = np.argsort(keys)
    place = np.searchsorted(keys[order], mixed(rows)).clip(0, len(others) - 1)
    found = order[place]
    return np.where((others[found] == rows).all(axis=1), found, -1)


def mixed(rows):
    """A number for each row that is the same for equal ones, and hardly ever for others."""
    bits = (np.ascontiguousarray(rows) + 0.0).view(np.uint64)  # + 0.0: -0.0 is 0.0
    bits ^= bits >> np.uint64(29)  # a product hands bits on to higher ones alone: two signs would cancel each other
    return (bits * MIXED).sum(axis=1)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The cells of many boxes of rows and columns, a few of the boxes at once."""

import numpy as np

MANY = 2_000_000  # cells at once, with what is known of each


def shares(counts, most=MANY):
    """Boxes in their order, so many at once that their cells fit into memory.

    Parameters
    ----------
    counts : (m,) int array
        The cells of each box; those without any are left out.
    most : int
        Cells at once, but for those of the last box.

    Returns
    -------
    list of int arrays

    Examples
    --------
    >>> [some.tolist() for some in shares(np.array([3, 0, 3, 4, 1]), most=5)]
    [[0], [2], [3, 4]]
    """
    boxes = np.flatnonzero(counts)
    share = np.cumsum(counts[boxes]) // most
    return np.split(boxes, np.flatnonzero(np.diff(share)) + 1) if len(boxes) else []


def cells(wide, high):
    """The cells of boxes of so many columns and rows each, (m,): the box of each cell, its column and its row, (c,).

    >>> [numbers.tolist() for numbers in cells(np.array([1, 2]), np.array([2, 1]))]
    [[0, 0, 1, 1], [0, 0, 0, 1], [0, 1, 0, 0]]
    """
    counts = wide * high
    box = np.repeat(np.arange(len(counts)), counts)
    number = np.arange(len(box)) - np.repeat(np.cumsum(counts) - counts, counts)
    return box, *np.divmod(number, high[box])

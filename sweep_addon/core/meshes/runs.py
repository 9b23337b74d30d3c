# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs: arrays of groups one after the other, loops of points or faces of corners, told by the offsets between them.

Run ``i`` of k is from ``offsets[i]`` to before ``offsets[i + 1]``; the last offset is the number of items.
"""

import numpy as np


def following(offsets):
    """(m,) int array: the index of the next item of the same run, after the last the first.

    Examples
    --------
    >>> following(np.array([0, 3, 5])).tolist()
    [1, 2, 0, 4, 3]
    """
    following = np.arange(1, offsets[-1] + 1)
    following[offsets[1:] - 1] = offsets[:-1]
    return following


def run_of(offsets):
    """(m,) int array: the number of the run that each item belongs to.

    Examples
    --------
    >>> run_of(np.array([0, 3, 5])).tolist()
    [0, 0, 0, 1, 1]
    """
    return np.repeat(np.arange(len(offsets) - 1), np.diff(offsets))


def backward(offsets):
    """(m,) int array: the indices that run through each run from its last item to its first.

    Examples
    --------
    >>> backward(np.array([0, 3, 5])).tolist()
    [2, 1, 0, 4, 3]
    """
    run = run_of(offsets)
    return offsets[run] + offsets[run + 1] - 1 - np.arange(offsets[-1])

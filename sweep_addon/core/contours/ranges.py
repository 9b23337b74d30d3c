# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ranges: pairs of each of many things with a run of numbers of its own, made without a loop over the things."""

import numpy as np

PAIRS_AT_ONCE = 1 << 20  # bounds the memory, not the work
IN_CACHE = 1 << 16  # so few that arrays of them are fast


def ranges(first, count, at_once=PAIRS_AT_ONCE):
    """Yield, in portions, all pairs of i and the numbers ``first[i]`` to before ``first[i] + count[i]``.

    Parameters
    ----------
    first, count : (n,) int arrays
    at_once : int
        About how many pairs make a portion.

    Yields
    ------
    (c,), (c,) int arrays
        The i and the numbers.

    Examples
    --------
    >>> [(i.tolist(), j.tolist()) for i, j in ranges(np.array([5, 0, 7]), np.array([2, 0, 1]))]
    [([0, 0, 2], [5, 6, 7])]
    """
    cuts = np.searchsorted(np.cumsum(count), np.arange(0, count.sum(), at_once), side="right")
    for start, end in zip(cuts, [*cuts[1:], len(count)], strict=False):
        some = count[start:end]
        skipped = first[start:end] - np.cumsum(some) + some
        yield np.repeat(np.arange(start, end), some), np.repeat(skipped, some) + np.arange(some.sum())

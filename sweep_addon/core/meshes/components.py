# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Connected components: which of many things hang together."""

import numpy as np


def components(count, pairs):
    """Find what is connected.

    Parameters
    ----------
    count : int
        Of things.
    pairs : (p, 2) int array
        Things that are connected.

    Returns
    -------
    (count,) int array
        The number of each thing's component: that of the first thing in it.

    Every component takes the lowest number that it touches until none is lower, each of which then stands for a whole
    tree: in few rounds, however long the chains are.

    Examples
    --------
    >>> components(5, np.array([(1, 4), (3, 1)])).tolist()
    [0, 1, 2, 1, 1]
    """
    first = np.arange(count)
    while True:
        one, other = first[pairs].reshape(-1, 2).T
        lower = first.copy()
        np.minimum.at(lower, np.maximum(one, other), np.minimum(one, other))
        while (lower[lower] != lower).any():
            lower = lower[lower]
        if (lower == first).all():
            return first
        first = lower

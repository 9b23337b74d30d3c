# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Search: where a function of one variable is highest, in many intervals at once."""

import numpy as np

GOLDEN = (np.sqrt(5) - 1) / 2
NARROWINGS = 44  # 6e-10 of each interval is left: the highest value is flat, so nothing of it is


def highest(function, low, high, narrowings=NARROWINGS):
    """Where a function is highest between pairs of ends, by golden sections, and how high.

    Parameters
    ----------
    function : callable
        From places (n,) to values (n,), with one peak in each interval.
    low, high : (n,) float array
        The ends.
    narrowings : int
        Each leaves 0.618 of every interval.

    Examples
    --------
    >>> place, value = highest(np.sin, np.array([0.0]), np.array([3.0]))
    >>> round(float(place[0]), 7) == round(np.pi / 2, 7), value.tolist()
    (True, [1.0])
    """
    left, right = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    at_left, at_right = function(left), function(right)
    for _ in range(narrowings):
        rises = at_left < at_right
        low, high = np.where(rises, left, low), np.where(rises, high, right)
        kept, at_kept = np.where(rises, right, left), np.where(rises, at_right, at_left)
        new = np.where(rises, low + GOLDEN * (high - low), high - GOLDEN * (high - low))
        at_new = function(new)
        left, right = np.where(rises, kept, new), np.where(rises, new, kept)
        at_left, at_right = np.where(rises, at_kept, at_new), np.where(rises, at_new, at_kept)
    return (low + high) / 2, np.maximum(at_left, at_right)

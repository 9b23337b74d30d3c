# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Search: where a function of one variable is highest, in many intervals at once."""

import numpy as np

GOLDEN = (np.sqrt(5) - 1) / 2
PARTS = 9  # into which an interval is cut; two of them are left
NARROWINGS = 14  # 7e-10 of each interval is left: the highest value is flat, so nothing of it is


def highest(function, low, high, narrowings=NARROWINGS):
    """Where a function is highest between pairs of ends, and how high.

    Parameters
    ----------
    function : callable
        From places (n,) to values (n,), with one peak in each interval. It is asked for several places of every
        interval at once, the first of all intervals first: a few long questions are answered sooner than many short
        ones, as golden sections ask.
    low, high : (n,) float array
        The ends.
    narrowings : int
        Each leaves 2 / 9 of every interval.

    Examples
    --------
    >>> place, value = highest(np.sin, np.array([0.0]), np.array([3.0]))
    >>> round(float(place[0]), 7) == round(np.pi / 2, 7), value.tolist()
    (True, [1.0])
    """
    here, steps = np.arange(len(low)), np.arange(PARTS + 1)[:, None] / PARTS
    place, most = (low + high) / 2, np.full(len(low), -np.inf)
    for _ in range(narrowings):
        places = low + (high - low) * steps
        values = function(places[1:-1].ravel()).reshape(PARTS - 1, len(low))
        top = values.argmax(axis=0)
        low, high = places[top, here], places[top + 2, here]
        found = values[top, here]
        place, most = np.where(found > most, places[top + 1, here], place), np.maximum(most, found)
    return place, most

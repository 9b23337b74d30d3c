# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Golden sections: where many functions are least between two places each, as far as that decides something."""

import numpy as np

GOLDEN = (np.sqrt(5) - 1) / 2
STEPS = 40
SURE = 0.25  # of how far a value is from what would change a label: what differs by less between places is known


def least_between(function, low, high, tolerance, enough):
    """Where functions are least.

    Parameters
    ----------
    function : callable
        From the numbers of functions (k,) and a place for each to their values: (k,).
    low, high : (n,) float array
        Between which places.
    tolerance, enough : float
        Values above the one, between it and less than nothing by the other, and below that are not told apart among
        themselves.

    Returns
    -------
    least : (n,) float array
        The least value that was found.
    place : (n,) float array

    Examples
    --------
    >>> centres = np.array([0.3, 0.6])
    >>> least, place = least_between(lambda k, s: (s - centres[k]) ** 2, np.zeros(2), np.ones(2), 0.0, 1e-6)
    >>> bool(np.abs(place - centres).max() < 1e-3)
    True
    """
    every = np.arange(len(low))
    places = np.stack((low, high - GOLDEN * (high - low), low + GOLDEN * (high - low), high))
    values = np.stack([function(every, place) for place in places])
    active = every
    for _ in range(STEPS):
        some = values[:, active]
        least = some.min(axis=0)
        spread = some.max(axis=0) - least
        gap = np.where(least > tolerance, least - tolerance, least + enough)
        active = active[(spread > SURE * gap) & (least >= -enough)]
        if not len(active):
            break
        place, value = places[:, active], values[:, active]
        left = value[1] < value[2]
        place = np.where(left, place[[0, 0, 1, 2]], place[[1, 2, 3, 3]])
        value = np.where(left, value[[0, 0, 1, 2]], value[[1, 2, 3, 3]])
        new = np.where(left, place[3] - GOLDEN * (place[3] - place[0]), place[0] + GOLDEN * (place[3] - place[0]))
        asked = function(active, new)
        row = np.where(left, 1, 2)
        place[row, np.arange(len(active))], value[row, np.arange(len(active))] = new, asked
        places[:, active], values[:, active] = place, value
    which = values.argmin(axis=0)
    return values[which, every], places[which, every]

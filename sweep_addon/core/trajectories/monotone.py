# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth functions through values at 0, 1, 2, ... that never turn between two of them."""

import numpy as np


def slopes(rises, closed):
    """Slopes at values with which cubics never turn between two of them.

    Parameters
    ----------
    rises : (m,) float array
        From each value to the next; of a closed function the last one leads to the first value again.
    closed : bool

    Returns
    -------
    (m + 1,) float array
        Where both rises are more than 0 it is so too, and at most twice the smaller one.

    Source
    ------
    Fritsch, Butland: A Method for Constructing Local Monotone Piecewise Cubic Interpolants, SIAM J. Sci. Stat. Comput.
    5(2), 1984: the harmonic mean of the rises on both sides, and 0 where they are of unlike signs. At an open end the
    cubic is a parabola.

    Examples
    --------
    >>> slopes(np.array([1.0, 3.0, 3.0, -3.0]), closed=False).tolist()
    [0.5, 1.5, 3.0, 0.0, -6.0]
    """
    before, after = (np.roll(rises, 1), rises) if closed else (rises[:-1], rises[1:])
    same = before * after > 0
    found = np.where(same, 2 * before / np.where(same, before + after, 1.0) * after, 0.0)
    if closed:
        return np.append(found, found[:1])
    inner = found if len(found) else rises
    return np.concatenate((2 * rises[:1] - inner[:1], found, 2 * rises[-1:] - inner[-1:]))


def cubics(rise, first, last):
    """The coefficients of x, x^2 and x^3 from 0 to 1 by how far cubics rise and their end slopes: three (n,)."""
    return first, 3 * rise - 2 * first - last, first + last - 2 * rise

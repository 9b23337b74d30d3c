# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Chebyshev polynomials: functions from -1 to 1 by what they are at a few places, to rounding where they are smooth."""

import numpy as np


def angles(order):
    """The angles whose cosines are the nodes of so many terms: (order,)."""
    return (np.arange(order) + 0.5) * np.pi / order


def fitting(order):
    """From values at the nodes to the coefficients of a sum of Chebyshev polynomials: (order, order)."""
    found = 2 / order * np.cos(np.arange(order)[:, None] * angles(order))
    found[0] /= 2
    return found


def counted(coefficients, allowed):
    """Sums (m, n) without their last terms, of which all together are no more than that in any."""
    rest = np.cumsum(np.abs(coefficients[:0:-1]), axis=0)  # of the last one, of the last two, and so on
    left_out = np.count_nonzero((rest <= allowed).all(axis=1))
    return coefficients[: len(coefficients) - left_out]


def summed(coefficients, x):
    """Sums of Chebyshev polynomials by Clenshaw's recurrence: (m, n) and (n,) to (n,).

    Examples
    --------
    Twice the second one, 2 x^2 - 1:

    >>> summed(np.array([[0.0], [0.0], [2.0]]), np.array([0.5])).tolist()
    [-1.0]
    """
    last = before = np.zeros_like(x)
    twice = 2 * x
    for coefficient in coefficients[:0:-1]:
        last, before = coefficient + twice * last - before, last
    return coefficients[0] + x * last - before

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which side: the sign of a turn in the plane, never wrong about a side, zero where rounding cannot tell."""

import numpy as np

ROUNDING = 4 * np.finfo(float).eps


def orientation(a, b, c):
    """Tell whether the turn from a over b to c is left (+1), right (-1) or none that rounding could tell (0).

    Parameters
    ----------
    a, b, c : (..., 2) float arrays
        Points, in arrays that broadcast against each other.

    Returns
    -------
    (...) int8 array

    Source
    ------
    Shewchuk: Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997: the error of
    the determinant is under 3.0000000000000036 rounding units of the sum of its two products.

    Examples
    --------
    >>> print(orientation(np.array([0.0, 0.0]), np.array([1.0, 0.0]), np.array([[2.0, 1.0], [2.0, 0.0]])))
    [1 0]
    """
    rise = (b[..., 0] - a[..., 0]) * (c[..., 1] - a[..., 1])
    fall = (b[..., 1] - a[..., 1]) * (c[..., 0] - a[..., 0])
    turn = rise - fall
    sure = np.abs(turn) > ROUNDING * (np.abs(rise) + np.abs(fall))
    return np.where(sure, np.sign(turn), 0).astype(np.int8)

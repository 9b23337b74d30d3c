# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Products and lengths of vectors, few and many."""

import numpy as np
import pytest

from sweep_addon.core.vectors import MANY, ROWS, dot, norms


@pytest.mark.parametrize("count", [1, MANY - 1, MANY, ROWS, ROWS + 1, 2 * ROWS + 7])
def test_products_of_whole_numbers_are_exact_however_many_there_are(count):
    """Small whole numbers are multiplied and added without rounding, in any order."""
    a, b = np.random.default_rng(count).integers(-1000, 1000, (2, count, 3))

    expected = [x * u + y * v + z * w for (x, y, z), (u, v, w) in zip(a.tolist(), b.tolist(), strict=True)]

    assert dot(a.astype(float), b.astype(float)).tolist() == expected


@pytest.mark.parametrize("layout", [np.ascontiguousarray, np.asfortranarray])
@pytest.mark.parametrize("count", [MANY - 1, 2 * ROWS + 7])
def test_pythagorean_quadruples_have_whole_lengths(count, layout):
    """The numbers m^2 + n^2 - p^2, 2 m p and 2 n p are the sides of a box whose diagonal is m^2 + n^2 + p^2."""
    m, n, p = np.random.default_rng(count).integers(1, 100, (3, count)).astype(float)
    sides = layout(np.stack((m * m + n * n - p * p, 2 * m * p, 2 * n * p), axis=1))

    assert norms(sides).tolist() == (m * m + n * n + p * p).tolist()

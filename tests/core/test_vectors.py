# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Products and lengths of vectors, few and many."""

import numpy as np
import pytest

from sweep_addon.core.vectors import MANY, ROWS, dot, norms, product


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


@pytest.mark.parametrize("count", [2, MANY - 1, MANY, 2 * ROWS + 7])
def test_a_product_is_the_same_however_many_there_are_and_however_they_lie(count):
    a, b = np.random.default_rng(count).normal(size=(2, count, 3))
    alone = [float(dot(a[i : i + 1], b[i : i + 1])[0]) for i in range(0, count, 97)]

    for first, second in ((a, b), (np.asfortranarray(a), np.asfortranarray(b)), (np.asfortranarray(a), b)):
        assert dot(first, second)[::97].tolist() == alone


@pytest.mark.parametrize("shape", [(9, 1000), (64, 30_000), (3, 50)])
def test_a_matrix_product_of_whole_numbers_is_exact_in_whatever_blocks_it_is_made(shape):
    rows, columns = shape
    left, right = (np.random.default_rng(rows).integers(-99, 99, size) for size in ((rows, 3), (3, columns)))
    out = np.empty(shape)

    product(left.astype(float), right.astype(float), out)

    assert (out == left @ right).all()

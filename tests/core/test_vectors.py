# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Products and lengths of vectors, few and many."""

import numpy as np
import pytest

from sweep_addon.core import vectors
from sweep_addon.core.vectors import MANY, ROWS, TOGETHER, added, dot, is_tuned, norms, product


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


@pytest.fixture(params=[True, False], ids=["tuned", "plain"])
def either_way(request, monkeypatch):
    """As where NumPy multiplies by a BLAS that is tuned, and as where it does not."""
    monkeypatch.setattr(vectors, "tuned", lambda: request.param)


@pytest.mark.parametrize("shape", [(9, 1000), (64, 30_000), (3, 50), (0, 5), (5, 0)])
@pytest.mark.usefixtures("either_way")
def test_a_matrix_product_of_whole_numbers_is_exact_in_whatever_blocks_it_is_made(shape):
    rows, columns = shape
    left, right = (np.random.default_rng(rows).integers(-99, 99, size) for size in ((rows, 3), (3, columns)))
    out = np.empty(shape)

    product(left.astype(float), right.astype(float), out)

    assert (out == left @ right).all()


AT_ONCE = TOGETHER // 8  # rows of so many numbers


@pytest.mark.parametrize("count", [0, 1, AT_ONCE - 1, AT_ONCE, AT_ONCE + 1, 3 * AT_ONCE + 7])
def test_whole_numbers_are_added_to_rows_exactly_however_many_there_are(count):
    made = np.random.default_rng(count)
    left, shares, right = (made.integers(-99, 99, size) for size in ((5, 2), (2, 8), (count, 8)))
    out = np.empty((5, count, 8))

    added(left.astype(float), shares.astype(float), right.astype(float), out)

    assert (out == right + (left @ shares)[:, None]).all()


@pytest.mark.parametrize("name", ["scipy-openblas", "openblas64", "accelerate", "mkl-sdl", "blis"])
def test_a_blas_that_is_tuned_is_known_by_what_numpy_says_of_it(name):
    assert is_tuned({"Build Dependencies": {"blas": {"name": name, "found": True}}})


@pytest.mark.parametrize("blas", [{"name": "blas", "found": True}, {"name": "none", "found": False}, {"found": False}])
def test_the_reference_and_none_are_not_tuned(blas):
    assert not is_tuned({"Build Dependencies": {"blas": blas}})
    assert not is_tuned({})


@pytest.mark.usefixtures("asked_again")
def test_numpy_is_asked_what_it_was_built_with(monkeypatch):
    monkeypatch.setattr(np, "show_config", lambda mode: {"Build Dependencies": {"blas": {"name": "openblas"}}})

    assert vectors.tuned()


@pytest.mark.usefixtures("asked_again")
def test_a_numpy_that_does_not_say_is_taken_to_have_none(monkeypatch):
    monkeypatch.setattr(np, "show_config", lambda: None)  # as it is where NumPy was built in the old way

    assert not vectors.tuned()


@pytest.fixture
def asked_again():
    """What is known of NumPy is forgotten before and after."""
    vectors.tuned.cache_clear()
    yield
    vectors.tuned.cache_clear()

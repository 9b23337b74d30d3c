# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ways back through linear maps of any size, and nearly so through flat ones."""

import numpy as np
import pytest

from sweep_addon.core.membership.motion.linear import solved


def test_maps_of_any_size_are_solved_as_numpy_does_one_by_one():
    random = np.random.default_rng(4)
    maps = random.normal(size=(500, 3, 3)) * 10.0 ** random.uniform(-100, 100, (500, 1, 1))
    vectors = random.normal(size=(500, 3))
    expected = np.linalg.solve(maps, vectors[..., None])[..., 0]
    error = np.linalg.norm(solved(maps, vectors) - expected, axis=1) / np.linalg.norm(expected, axis=1)
    assert (error < 1e-14 * np.linalg.cond(maps)).all()


@pytest.mark.parametrize("size", [1e-200, 1.0, 1e200])
def test_a_flat_map_is_solved_along_itself_and_far_across(size):
    """Of diag(2, 1, 0) with a millionth of its size, 2, added to the diagonal."""
    found = size * solved(size * np.diag((2.0, 1.0, 0.0)), np.ones(3), 1e-6)
    assert found == pytest.approx([1 / (2 + 2e-6), 1 / (1 + 2e-6), 1 / 2e-6], rel=1e-9)


def test_a_map_to_one_point_has_ways_back_as_far_as_numbers_go():
    found = solved(np.zeros((2, 3, 3)), np.array([[1.0, 0, 0], [0, -1.0, 0]]))
    assert found == pytest.approx(np.array([[1e300, 0, 0], [0, -1e300, 0]]), rel=1e-12)

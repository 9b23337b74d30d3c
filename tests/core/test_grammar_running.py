# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Running sums of bytes, against sums of wide integers, one by one."""

import numpy as np
import pytest

from sweep_addon.core.grammars.drawing.running import Running


@pytest.mark.parametrize("count", [0, 1, 7, 8, 9, 1000, 70_001])
@pytest.mark.parametrize("chances", [(0.3, 0.4, 0.3), (0.9, 0.1, 0.0), (0.0, 0.1, 0.9)])
def test_sums_of_bytes_are_those_of_wide_integers(count, chances):
    steps = np.random.default_rng(count).choice(np.array([-1, 0, 1], dtype=np.int8), count, p=chances)
    expected = 300 + np.cumsum(steps, dtype=np.int64)

    sums = Running(steps, 300)

    assert sums.at(np.arange(count)).tolist() == expected.tolist()
    assert sums.bytes.tolist() == (expected % 256).tolist()
    assert sums.total == (expected[-1] if count else 300)


@pytest.mark.parametrize("count", [0, 8, 5000])
def test_items_are_counted_as_they_are_one_by_one(count):
    chosen = np.random.default_rng(count).random(count) < 0.9

    assert Running(chosen).at(np.arange(count)).tolist() == np.cumsum(chosen).tolist()

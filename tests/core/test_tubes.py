# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How a sweep is taken apart: as few tubes as none of which meets itself."""

import numpy as np
import pytest

from sweep_addon.core.resolving.conflicts import Chunks
from sweep_addon.core.resolving.plan import planned


@pytest.mark.parametrize(("count", "reach"), [(30, 10), (31, 7), (12, 5)])
def test_tubes_round_a_closed_sweep_are_as_long_as_they_may_be(count, reach):
    """Chunks meet those that are so many farther on; a tube holds so many less one, for it begins in the last one's."""
    number = np.arange(count)
    between = np.abs(number - number[:, None])
    conflict = np.minimum(between, count - between) >= reach
    plan = planned(Chunks(np.arange(count + 1), np.full(count, False), conflict), closed=True)
    assert not plan.folds and not plan.untouched.any()
    assert len(plan.tubes) == -(-count // (reach - 1))
    for first, last in plan.tubes:
        held = np.arange(first, last) % count
        assert not conflict[np.ix_(held, held)].any()
    assert sorted(ring for first, last in plan.tubes for ring in range(first + 1, last)) == list(number)


def test_tubes_of_an_open_sweep_begin_at_its_start():
    number = np.arange(20)
    conflict = np.abs(number - number[:, None]) >= 10
    plan = planned(Chunks(np.arange(21), np.full(20, False), conflict), closed=False)
    assert plan.tubes == ((0, 10), (9, 19), (18, 20))

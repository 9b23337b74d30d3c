# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where functions change their sign, of many at once, of which some take longer."""

import numpy as np
import pytest

from sweep_addon.core.self_intersection.folds import roots


def of_both(one, other):
    """What `roots` says of two functions between 0 and 1."""

    def both(places):
        return np.array([one(places[0]), other(places[1])])

    low, high = np.zeros(2), np.ones(2)
    return roots(both, low, high, both(low), both(high))


def jump(place):
    return np.copysign(1.0, place - 0.3)


@pytest.mark.parametrize(
    ("function", "root"),
    [
        (lambda x: x - 0.5, 0.5),
        (lambda x: 4 * x - 1, 0.25),
        (lambda x: -x, 0.0),
        (lambda x: x - 1, 1.0),
        (lambda x: np.exp(x) - 1.1, np.log(1.1)),
    ],
)
def test_a_root_that_is_found_early_is_not_left_while_others_are_looked_for(function, root):
    """A line is 0 after one step; a jump is halved on for the full count, and every fourth step halves them all."""
    found = of_both(function, jump)
    assert found[0] == pytest.approx(root, abs=1e-13)
    assert found[1] == pytest.approx(0.3, abs=1e-11)


def test_a_flat_root_is_where_rounding_leaves_nothing_of_the_function():
    found = of_both(lambda x: (x - 0.3) ** 3, lambda x: 1e3 * (x - 0.7) ** 5)
    assert abs(found[0] - 0.3) ** 3 < 1e-13
    assert 1e3 * abs(found[1] - 0.7) ** 5 < 1e-13

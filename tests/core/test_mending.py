# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Loops that cross by less than can be seen are mended, those that mean to are not."""

import numpy as np
import pytest
from contour_inputs import ngon, square, star
from hypothesis import given
from hypothesis import strategies as st

from sweep_addon.core.contours import Outline
from sweep_addon.core.contours.mending import mended
from sweep_addon.core.declared.parameters import ShapeError

HOURGLASS = np.array([(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)])


def area(loops):
    return Outline(loops).section().area


def slipped(loop, at, by):
    """A loop that goes some way straight outwards at a point, twice as far back, and is then at the point again."""
    out = by * loop[at] / np.linalg.norm(loop[at])
    return np.concatenate((loop[: at + 1], [loop[at] + out, loop[at] - out], loop[at:]))


@given(st.integers(0, 2**32), st.integers(5, 40), st.floats(1e-6, 1e-2))
def test_a_loop_with_a_slip_encloses_what_it_does_without(seed, sides, by):
    rng = np.random.default_rng(seed)
    loop = star(rng, sides)
    slip = slipped(loop, int(rng.integers(sides)), by)
    with pytest.raises(ShapeError, match="must not cross or touch"):
        Outline([slip])
    assert area(mended([slip])) == pytest.approx(area([loop]), rel=1e-5)


@pytest.mark.parametrize("turn", [1, -1])
def test_a_ring_whose_hole_touches_it_stays_a_ring(turn):
    """The corner of the hole is a ten-thousandth beyond the side of the square, whichever way it runs."""
    hole = (ngon(4, 1.0) + (1.0001, 0.0))[::turn]
    made = mended([square(4, -2.0, -2.0), hole])
    assert area(made) == pytest.approx(14, abs=1e-4)


@pytest.mark.parametrize(
    "loops",
    [[HOURGLASS], [square(1), square(1, 0.5, 0.5)], [square(1), square(1, 0.9)], [np.array([(0.0, 0.0), (1.0, 1.0)])]],
    ids=["hourglass", "two squares", "two squares with a strip in common", "two points"],
)
def test_loops_that_mean_to_cross_and_those_round_nothing_are_not_mended(loops):
    assert mended(loops) == []


def test_what_goes_there_and_back_beside_others_is_left_out():
    made = mended([square(1), np.array([(3.0, 0.0), (3.0, 1.0)])])
    assert len(made) == 1 and area(made) == pytest.approx(1)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What overlapping loops fill has the area that inclusion and exclusion or a formula gives."""

import numpy as np
import pytest
from contour_inputs import ngon, shoelace, square
from hypothesis import given
from hypothesis import strategies as st

from sweep_addon.core.contours import Section
from sweep_addon.core.contours.filling import filled
from sweep_addon.core.declared.parameters import ShapeError

NONZERO, EVEN_ODD = np.array([False]), np.array([True])


def area(loops, figure=None, even_odd=NONZERO):
    figure = np.zeros(len(loops), dtype=int) if figure is None else np.array(figure)
    found = filled(loops, figure, even_odd)
    return Section.from_loops(found).area if found else 0.0


def pentagram():
    return ngon(5, 1.0)[[0, 2, 4, 1, 3]]


def test_a_pentagram_is_full_by_nonzero_and_hollow_by_even_odd():
    """Ten triangles between the centre, the tips and the corners of the inner pentagon, of radius 1 / golden^2."""
    inner = ((1 + np.sqrt(5)) / 2) ** -2
    full = 10 * inner * np.sin(np.pi / 5) / 2
    hollow = full - 5 / 2 * inner**2 * np.sin(2 * np.pi / 5)
    assert area([pentagram()]) == pytest.approx(full, rel=1e-5)
    assert area([pentagram()], even_odd=EVEN_ODD) == pytest.approx(hollow, rel=1e-4)


box = st.tuples(*[st.integers(0, 20)] * 2, *[st.integers(1, 10)] * 2)


@given(st.lists(box, min_size=1, max_size=6), st.booleans())
def test_boxes_fill_the_cells_that_they_cover(boxes, together):
    """On a board of unit cells; as figures of their own boxes unite, as one even-odd figure they exclude each other."""
    board = np.zeros((30, 30), dtype=int)
    for x, y, w, h in boxes:
        board[x : x + w, y : y + h] += 1
    loops = [np.array([(x, y), (x + w, y), (x + w, y + h), (x, y + h)], dtype=float) for x, y, w, h in boxes]
    if together:
        found, covered = area(loops, even_odd=EVEN_ODD), (board % 2).sum()
    else:
        found, covered = area(loops, range(len(loops)), np.zeros(len(loops), dtype=bool)), (board > 0).sum()
    assert found == pytest.approx(covered, abs=1e-2)


def test_figures_that_run_in_opposite_directions_do_not_cancel():
    assert area([square(2), square(2, 1)[::-1]], [0, 1], np.array([False, False])) == pytest.approx(6)


def test_within_one_figure_opposite_loops_leave_a_hole():
    assert area([square(3), square(1, 1, 1)[::-1]]) == pytest.approx(8)
    assert area([square(3), square(1, 1, 1)]) == pytest.approx(9)


def test_areas_that_touch_in_a_point_are_drawn_apart():
    found = filled([square(1), square(1, 1, 1)], np.array([0, 1]), np.array([False, False]))
    assert len(found) == 2
    assert Section.from_loops(found).area == pytest.approx(2, abs=1e-4)


def test_loops_without_width_fill_nothing():
    assert (
        filled([np.array([(0.0, 0.0), (1.0, 0.0)]), np.zeros((3, 2)), np.empty((0, 2))], np.zeros(3, int), NONZERO)
        == []
    )


def test_points_of_loops_that_overlap_nothing_stay_where_they_are_to_single_precision():
    loop = ngon(50, 3.0)
    (found,) = filled([loop], np.array([0]), NONZERO)
    assert np.hypot(*(found[:, None] - loop).transpose(2, 0, 1)).min(axis=0).max() < 6 / 4e6
    assert shoelace(found) == pytest.approx(shoelace(loop), rel=1e-6)


def test_a_scribble_that_crosses_without_end_is_refused():
    with pytest.raises(ShapeError, match="must have overlaps of at most 250000 pieces"):
        filled([np.random.default_rng(0).random((1500, 2))], np.array([0]), NONZERO)

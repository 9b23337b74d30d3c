# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattened curves keep their tolerance and turn gently, in the plane and in space."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweep_addon.core.contours.flatten import cubics_from_lines, cubics_from_quadratics, flatten_cubics
from sweep_addon.core.declared.parameters import ShapeError


def on_cubic(control, t):
    a, b, c, d = control
    t = t[:, None]
    return (1 - t) ** 3 * a + 3 * (1 - t) ** 2 * t * b + 3 * (1 - t) * t**2 * c + t**3 * d


def distance_to_chords(places, chain):
    start, chord = chain[:-1], np.diff(chain, axis=0)
    along = np.einsum("pcd,cd->pc", places[:, None] - start, chord) / np.maximum((chord**2).sum(axis=1), 1e-300)
    nearest = start + np.clip(along, 0, 1)[..., None] * chord
    return np.linalg.norm(places[:, None] - nearest, axis=2).min(axis=1)


@given(st.integers(0, 2**32 - 1), st.sampled_from([2, 3]), st.sampled_from([1e-1, 1e-2, 1e-3]))
def test_no_place_on_a_cubic_is_further_from_its_chords_than_the_tolerance(seed, dimensions, tolerance):
    control = np.random.default_rng(seed).standard_normal((1, 4, dimensions))
    points, first = flatten_cubics(control, tolerance)
    chain = np.concatenate([points, control[:, 3]])
    assert distance_to_chords(on_cubic(control[0], np.linspace(0, 1, 500)), chain).max() <= tolerance
    assert first.tolist() == [0]


def quarter_circles():
    k = 4 / 3 * np.tan(np.pi / 8)
    quarter = np.array([(1, 0), (1, k), (k, 1), (0, 1)])
    turn = np.array([(0, 1), (-1, 0)])
    return np.stack([quarter, quarter @ turn, quarter @ turn @ turn, quarter @ turn @ turn @ turn])


@pytest.mark.parametrize("tolerance", [1.0, 1e-2, 1e-4])
def test_chords_turn_by_at_most_15_degrees_also_from_one_segment_to_the_next(tolerance):
    points, _ = flatten_cubics(quarter_circles(), tolerance)
    edges = np.roll(points, -1, axis=0) - points
    after = np.roll(edges, -1, axis=0)
    turns = np.arctan2(edges[:, 0] * after[:, 1] - edges[:, 1] * after[:, 0], (edges * after).sum(axis=1))
    assert np.degrees(turns).max() <= 15 + 1e-9
    assert turns.sum() == pytest.approx(2 * np.pi)


def test_a_cusp_stays_a_corner_and_costs_few_points():
    cusp = np.array([[(0.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 0.0)]])
    points, _ = flatten_cubics(cusp, 1e-3)
    assert len(points) < 100
    assert np.abs(points[:, 1]).max() == pytest.approx(0.75, abs=1e-3)


def test_lines_need_no_points_between_and_quadratics_are_cubics():
    points, first = flatten_cubics(cubics_from_lines([[(0, 0), (1, 0)], [(1, 0), (1, 1)]]), 1e-9)
    assert points.tolist() == [[0, 0], [1, 0]]
    assert first.tolist() == [0, 1]
    t = np.linspace(0, 1, 9)
    parabola = np.stack([2 * t, 4 * t * (1 - t)], axis=1)
    assert on_cubic(cubics_from_quadratics([[(0, 0), (1, 2), (2, 0)]])[0], t) == pytest.approx(parabola)


def test_a_tolerance_that_asks_for_too_many_points_is_refused():
    with pytest.raises(ShapeError, match="^tolerance: must be large enough to give at most 200000 points, got"):
        flatten_cubics(quarter_circles(), 1e-18)

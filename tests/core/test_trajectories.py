# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trajectories against formulas: points, derivatives, lengths, arc length and its inverse, corners."""

import json
from math import asinh, hypot, pi, sqrt
from pathlib import Path

import numpy as np
import pytest

from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.formulas.expressions import compile
from sweep_addon.core.stations.cells import bend
from sweep_addon.core.stations.sampling import Tolerance, place
from sweep_addon.core.trajectories import Arc, Bezier, Helix, Line, Nurbs, Polyline, Sampled, TorusKnot
from sweep_addon.core.trajectories.arc_length import arc_length

KNOTS = json.loads((Path(__file__).parents[1] / "data" / "knots.json").read_text())["knots"]
QUARTERS = [(1, 0, 0), (1, 1, 0), (0, 1, 0), (-1, 1, 0), (-1, 0, 0), (-1, -1, 0), (0, -1, 0), (1, -1, 0), (1, 0, 0)]
CIRCLE = Nurbs(  # Piegl, Tiller: The NURBS Book, example 7.2: the unit circle by nine points
    QUARTERS, [1, sqrt(0.5)] * 4 + [1], order=3, knots=[0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4]
)
POINTS = np.random.default_rng(1).normal(size=(13, 3))
SEMICUBICAL = Bezier([(0, 0, 0), (0, 0, 0), (1 / 3, 0, 0), (1, 1, 0)])  # (u^2, u^3, 0): its first handle has no length
PARABOLA = Bezier([(0, 0, 0), (1 / 3, 0, 0), (2 / 3, 1 / 3, 0), (1, 1, 0)])  # (u, u^2, 0)
EVERY = {
    "line": Line((1, 2, 3), (-1, 0, 5)),
    "arc": Arc(2.0, 4.0),
    "helix": Helix(2.0, -0.7, 1.3),
    "knot": TorusKnot(3, 4, 2.0, 0.7),
    "polyline": Polyline(POINTS, closed=True),
    "bezier": Bezier(POINTS),
    "closed bezier": Bezier(POINTS[:12], closed=True),
    "clamped nurbs": Nurbs(POINTS, order=5),
    "weighted nurbs": Nurbs(POINTS, np.linspace(0.3, 3, 13), order=4),
    "closed nurbs": Nurbs(POINTS, np.linspace(0.3, 3, 13), order=6, closed=True),
    "own knots": Nurbs(POINTS[:7], order=4, knots=[0, 1, 2, 2, 3, 4.5, 4.5, 7, 8, 9, 10]),
    "circle": CIRCLE,
    "sampled": Sampled(POINTS),
    "closed sampled": Sampled(POINTS, closed=True),
}


def inside(trajectory, count=40):
    """Parameters between the joints, away from them by a hundredth of their distance."""
    joints = trajectory.joints()
    fraction = np.random.default_rng(2).uniform(0.01, 0.99, (len(joints) - 1, count))
    return (joints[:-1, None] + np.diff(joints)[:, None] * fraction).ravel()


@pytest.mark.parametrize("name", EVERY)
def test_points_and_derivatives_at_once_are_those_asked_for_one_by_one(name):
    trajectory, u = EVERY[name], inside(EVERY[name])
    points, first, second = trajectory.moving(u)
    assert np.array_equal(points, trajectory.evaluate(u))
    assert np.array_equal(first, trajectory.derivative(u)) and np.array_equal(second, trajectory.derivative(u, 2))


@pytest.mark.parametrize(("radius", "rise"), [(2.0, 0.3), (0.01, 5.0), (7.0, 0.0)])
def test_a_helix_bends_towards_its_axis_by_its_radius_over_the_square_of_its_speed(radius, rise):
    trajectory = Helix(radius, 2 * pi * rise, 3.0) if rise else Arc(radius, 2.0)
    u = np.linspace(*trajectory.domain, 50)
    curvature = radius / (radius**2 + rise**2)
    expected = -curvature * np.stack((np.cos(u), np.sin(u), 0 * u), axis=1)
    assert np.abs(bend(trajectory, u) - expected).max() < 1e-15 * curvature
    speed = np.linalg.norm(trajectory.derivative(u), axis=1)
    assert np.abs(speed / trajectory.pace - 1).max() < 1e-15


@pytest.mark.parametrize("order", [1, 2, 3])
@pytest.mark.parametrize("name", EVERY)
def test_derivatives_are_those_of_the_points(name, order):
    """Central differences over four points are of fourth order: with steps of a thousandth, 1e-12 of the fifth
    derivative and 1e-13 / step of rounding, both under a millionth of the derivatives here."""
    trajectory, h = EVERY[name], 1e-3 * min(1.0, np.diff(EVERY[name].joints()).min())
    u = inside(trajectory)

    def below(u):
        return trajectory.evaluate(u) if order == 1 else trajectory.derivative(u, order - 1)

    difference = (8 * (below(u + h) - below(u - h)) - below(u + 2 * h) + below(u - 2 * h)) / (12 * h)
    found = trajectory.derivative(u, order)
    assert found.shape == (len(u), 3)
    assert np.abs(found - difference).max() < 1e-6 * max(1.0, np.abs(below(u)).max(), np.abs(found).max())


@pytest.mark.parametrize(
    ("trajectory", "length"),
    [
        (Line((1, 2, 3), (3, 5, 9)), 7.0),
        (Arc(3.0, 0.5), 1.5),
        (Helix(3.0, 8 * pi, 2.5), 25 * pi),
        (Helix(1.0, 0.3, 10_000.0), 10_000 * hypot(2 * pi, 0.3)),
        (CIRCLE, 2 * pi),
        (PARABOLA, sqrt(5) / 2 + asinh(2) / 4),
        (SEMICUBICAL, (13**1.5 - 8) / 27),  # the first curve ever rectified: Neile, 1657
        (Polyline([(0, 0, 0), (3, 4, 0), (3, 4, 12)], closed=True), 5 + 12 + 13),
        (Bezier([(0, 0, 0), (0, 0, 0), (1, 0, 0), (1, 0, 0)]), 1.0),
    ],
)
def test_lengths_are_those_of_the_formulas(trajectory, length):
    assert abs(trajectory.length() / length - 1) < 1e-12


@pytest.mark.parametrize(("p", "q", "minor"), [(2, 3, 0.4), (200, 199, 0.4), (128, 129, 0.4), (1, 200, 0.99)])
def test_a_knot_is_as_long_in_each_of_its_windings(p, q, minor):
    """A turn about the torus' tube is the last one turned about the axis: q pieces of one length."""
    knot = TorusKnot(p, q, minor=minor)
    windings = arc_length(knot).at(np.linspace(0, 2 * pi, q + 1))
    assert np.abs(np.diff(windings) * q / knot.length() - 1).max() < 1e-9
    assert abs(windings[-1] / knot.length() - 1) < 1e-15


def test_arc_length_along_a_curve_of_no_speed_at_its_start_is_that_of_the_formula():
    u = np.linspace(0, 1, 1001)
    s = ((4 + 9 * u**2) ** 1.5 - 8) / 27
    assert np.abs(arc_length(SEMICUBICAL).at(u) - s).max() < 1e-13
    assert np.abs(arc_length(SEMICUBICAL).parameter(s) - u).max() < 1e-7  # s is u^2 / 2: half the digits of u are lost


@pytest.mark.parametrize("trajectory", [*EVERY.values(), SEMICUBICAL, TorusKnot(200, 199), Bezier(1e6 + 1e-3 * POINTS)])
def test_a_parameter_found_for_an_arc_length_is_there(trajectory):
    measure = arc_length(trajectory)
    s = np.linspace(0, measure.total, 1003)
    assert np.abs(measure.at(measure.parameter(s)) - s).max() < 1e-13 * measure.total
    assert (np.diff(measure.parameter(s)) > 0).all()


@pytest.mark.parametrize(
    ("angle", "closed"), [(1e-3, False), (pi, False), (6.28, False), (6.283185, True), (2 * pi, True)]
)
def test_an_arc_starts_on_x_and_closes_after_a_full_turn(angle, closed):
    """Also one that is a turn to the digits that single precision has."""
    arc = Arc(2.0, angle)
    ends = arc.evaluate(np.array(arc.domain))
    assert arc.closed == closed
    assert np.abs(ends[0] - (2, 0, 0)).max() == 0
    assert np.abs(ends[1] - (2 * np.cos(angle), 2 * np.sin(angle), 0)).max() < 1e-6
    assert (np.abs(ends[1] - ends[0]).max() < 1e-15) == closed


def test_nine_weighted_points_make_a_circle():
    u = np.linspace(0, 4, 1001)
    points, tangents = CIRCLE.evaluate(u), CIRCLE.tangents(u)
    assert np.abs(np.linalg.norm(points, axis=1) - 1).max() < 1e-15
    assert np.abs(tangents - np.stack((-points[:, 1], points[:, 0], points[:, 2]), axis=1)).max() < 1e-14
    assert not len(CIRCLE.corners())


def test_a_nurbs_with_threefold_knots_is_a_chain_of_bezier_segments():
    knots = np.repeat(np.arange(5.0), [4, 3, 3, 3, 4])
    u = np.linspace(0, 4, 401)
    chain, nurbs = Bezier(POINTS), Nurbs(POINTS, knots=knots)
    for before in (False, True):
        assert np.abs(chain.derivative(u, 1, before) - nurbs.derivative(u, 1, before)).max() < 1e-13
    assert np.abs(chain.evaluate(u) - nurbs.evaluate(u)).max() < 1e-14
    assert chain.corners().tolist() == nurbs.corners().tolist() == [1, 2, 3]


def test_a_closed_uniform_cubic_passes_the_means_of_its_points():
    """At a knot the basis of a uniform cubic is 1/6, 4/6, 1/6, and two derivatives go on smoothly."""
    closed = Nurbs(POINTS, closed=True)
    first, last = closed.domain
    u = np.arange(first, last)
    means = (np.roll(POINTS, 1, axis=0) + 4 * POINTS + np.roll(POINTS, -1, axis=0)) / 6
    found = closed.evaluate(u)
    shift = np.linalg.norm(means - found[0], axis=1).argmin()
    assert np.abs(np.roll(means, -shift, axis=0) - found).max() < 1e-14
    for order in (1, 2):
        gap = closed.derivative(np.array([last]), order, before=True) - closed.derivative(np.array([first]), order)
        assert np.abs(gap).max() < 1e-13
    assert not len(closed.corners())


def test_weights_count_only_against_each_other():
    u = np.linspace(0, 10, 101)
    weights = np.linspace(0.5, 2, 13)
    assert np.abs(Nurbs(POINTS, weights).evaluate(u) - Nurbs(POINTS, 1e6 * weights).evaluate(u)).max() < 1e-14


def test_a_torus_knot_is_that_of_the_collection():
    """Its torus_2_3 runs the other way through the hole."""
    formula = next(knot for knot in KNOTS if knot["name"] == "torus_2_3")
    t = np.linspace(0, 2 * pi, 101)
    x, y, z = (compile(formula[axis], ["t"]).evaluate(t=t) for axis in "xyz")
    assert np.abs(TorusKnot(2, 3, 2.0, 1.0).evaluate(t) - np.stack((x, y, -z), axis=1)).max() < 1e-14


@pytest.mark.parametrize(
    ("trajectory", "corners"),
    [
        (Polyline([(0, 0, 0), (1, 0, 0), (2, 0, 0), (2, 1, 0)]), [2]),
        (Polyline([(0, 0, 0), (1, 0, 0), (2, 0, 0), (2, 1, 0)], closed=True), [0, 2, 3]),
        (Polyline([(1, 0, 0), (2, 0, 0), (2, 1, 0), (0, 0, 0)], closed=True), [1, 2, 3]),
        (Bezier([(0, 0, 0), (0, 0, 1), (0, 1, 2), (0, 2, 2), (0, 3, 2), (0, 4, 2), (0, 5, 2)]), []),
        (Bezier([(0, 0, 0), (0, 0, 1), (0, 1, 2), (0, 2, 2), (0, 2, 2), (0, 4, 2), (0, 5, 2)]), []),
        (Bezier([(0, 0, 0), (0, 0, 1), (0, 1, 2), (0, 2, 2), (0, 2, 2), (0, 2, 2), (0, 2, 5)]), [1]),
        (Nurbs([(0, 0, 0), (1, 0, 0), (2, 0, 0), (3, 1, 0), (4, 2, 0), (5, 2, 0)], order=2), [2, 4]),
        (TorusKnot(), []),
        (Arc(1.0, 2 * pi), []),
        (CIRCLE, []),
    ],
)
def test_corners_are_where_the_tangent_turns_at_once(trajectory, corners):
    assert trajectory.corners().tolist() == corners


@pytest.mark.parametrize("repeats", [1, 2, 5])
def test_a_corner_stays_one_where_a_nurbs_stands_still_in_it(repeats):
    """Of order 2, a NURBS is the polyline of its points, of which a repeated one changes nothing."""
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1)]
    still = Nurbs(np.repeat(corners, [repeats] * 4, axis=0), order=2)
    stations, expected = place(still, Tolerance()), place(Polyline(corners), Tolerance())
    assert stations.corners.tolist() == [1, 2]
    for name in ("points", "arrive", "leave", "s"):
        assert np.abs(getattr(stations, name) - getattr(expected, name)).max() < 1e-15


def test_tangents_where_the_speed_vanishes_are_their_limits():
    ends = np.array([0.0, 1.0])
    assert np.abs(SEMICUBICAL.tangents(ends[:1]) - (1, 0, 0)).max() < 1e-15
    there_and_back = Bezier([(0, 0, 0), (0, 0, 0), (3, 4, 0), (3, 4, 0), (3, 4, 0), (3, 4, 1), (3, 4, 1)])
    assert np.abs(there_and_back.tangents(np.array([0.0, 1.0])) - [(0.6, 0.8, 0), (0, 0, 1)]).max() < 1e-15
    assert np.abs(there_and_back.tangents(np.array([1.0, 2.0]), before=True) - [(0.6, 0.8, 0), (0, 0, 1)]).max() < 1e-15
    late = Bezier([(0, 0, 0), (0, 0, 0), (0, 0, 0), (0, 2, 0)])
    assert np.abs(late.tangents(ends) - (0, 1, 0)).max() < 1e-15


def test_a_turn_in_six_digits_is_a_full_turn():
    """The number that the docs and a refusal print, and what single precision makes of a turn."""
    for angle in (6.28319, 6.2832, float(np.float32(2 * np.pi)), 6.283185):
        assert Arc(angle=angle).closed and Arc(angle=angle).length() == Arc(angle=2 * np.pi).length()
    assert not Arc(angle=6.2831).closed
    with pytest.raises(ShapeError, match="^angle: must be at most 6.28"):
        Arc(angle=6.3)


def test_points_are_read_back_one_by_one():
    path = Polyline([(0, 0, 0), (0, 0, 1)])
    assert [point.tolist() for point in path.points] == [[0, 0, 0], [0, 0, 1]] and path.points[1, 2] == 1

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Directions: cubics as published, and the frame that the tangent and d define, as exact as rounding lets it be."""

import numpy as np
import pytest
from solids import TEAPOT_INNER, TEAPOT_OUTER

from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.stations.cubics import Basis
from sweep_addon.core.stations.directions import Arrows, Cubic, Guide, Tilt, meetings
from sweep_addon.core.stations.frames import axes, rotation_minimizing
from sweep_addon.core.stations.pd_curve import PDCurve
from sweep_addon.core.stations.rotations import signed_angle
from sweep_addon.core.stations.sampling import Count, place
from sweep_addon.core.trajectories import Arc, Bezier, Helix, Line, Nurbs, Polyline, TorusKnot
from sweep_addon.core.vectors import dot, norms, unit

UPRIGHT = Line(end=(0, 0, 2))
THROUGH = [(1, 0, -1), (1, 0, -1), (-1, 0, 3), (-1, 0, 3)]  # turns through the tangent of that in its middle


def framed(trajectory, direction, contours=41):
    stations = place(trajectory, Count(contours))
    e2, e3, told = axes(direction, stations, np.zeros(len(stations.s)))
    return stations, e2, e3, told


def test_the_teapots_handle_is_a_pd_curve_of_its_two_published_rails():
    """By hand, at the middle of the first of Newell's two segments: (P0 + 3 P1 + 3 P2 + P3) / 8."""
    trajectory = Bezier(TEAPOT_INNER)
    assert trajectory.evaluate([0.5]).tolist() == pytest.approx(np.array([[-2.4125, 0, 1.996875]]), abs=1e-15)
    d = Guide(TEAPOT_OUTER).vectors(trajectory, np.array([0.5]))
    assert d == pytest.approx(np.array([[-0.2125, 0, 0.196875]]), abs=1e-15)
    _, e2, e3, told = framed(trajectory, Guide(TEAPOT_OUTER))
    assert np.abs(e2[:, 1]).max() < 1e-15 and np.abs(np.abs(e3[:, 1]) - 1).max() < 1e-15
    assert told == ()


def test_the_three_bases_tell_the_same_cubic():
    rng = np.random.default_rng(5)
    bezier = rng.normal(size=(4, 6))
    hermite = [bezier[0], 3 * (bezier[1] - bezier[0]), bezier[3], 3 * (bezier[3] - bezier[2])]
    t = np.linspace(0, 1, 9)
    assert np.abs(PDCurve(bezier).evaluate(t) - PDCurve(hermite, "hermite").evaluate(t)).max() < 1e-14


def test_a_b_spline_is_the_one_of_its_uniform_knots():
    rows = np.random.default_rng(6).normal(size=(7, 6))
    found = PDCurve(rows, "b-spline").evaluate(np.linspace(0, 4, 33))
    uniform = np.arange(11.0)
    for part in (slice(0, 3), slice(3, 6)):
        spline = Nurbs(rows[:, part], knots=uniform)
        assert np.abs(found[:, part] - spline.evaluate(np.linspace(3, 7, 33))).max() < 1e-14


@pytest.mark.parametrize("seed", range(20))
def test_e2_lies_in_the_plane_of_the_tangent_and_d(seed):
    """As the lecture constructs it, to 1e-14, on the side of d, and the axes are right-handed and orthonormal."""
    rng = np.random.default_rng(seed)
    trajectory, direction = [
        (Bezier(np.cumsum(rng.uniform(0.2, 1, (4, 3)), axis=0)), Cubic(rng.normal(size=(4, 3)) + (5, -5, 0))),
        (Helix(turns=3), Cubic([(0, 0, 1)] * 4)),
        (Line(end=(1, 1, 1)), Arrows([(0, 0, -3, 1), (0.4, 1, -3, 0), (1, 0.5, -3, 0)])),
        (TorusKnot(), Guide([*[rng.normal(size=3) + (0, 0, 20)] * 4], "b-spline")),
    ][seed % 4]
    stations, e2, e3, told = framed(trajectory, direction)
    assert told == ()
    d = unit(direction.vectors(trajectory, stations.u))
    e1 = trajectory.tangents(stations.u)
    assert np.abs(dot(e2, np.cross(e1, d))).max() < 1e-14
    assert dot(e2, d).min() > 0
    assert max(np.abs(dot(e1, e2)).max(), np.abs(norms(e2) - 1).max()) < 1e-14
    assert np.abs(np.cross(e1, e2) - e3).max() < 1e-14


def test_where_d_turns_through_the_tangent_is_reported_and_the_frame_goes_on():
    """d = (1 - 2 b, 0, 4 b - 1) with b = 3 t^2 - 2 t^3: along z where b is a half, at t = 1/2."""
    met = meetings(Cubic(THROUGH), UPRIGHT)
    assert met.u == pytest.approx([0.5], abs=1e-12) and met.flips.tolist() == met.u.tolist()
    for contours in (2, 5, 11, 12):
        _, e2, _, told = framed(UPRIGHT, Cubic(THROUGH), contours)
        assert np.abs(e2 - (1, 0, 0)).max() < 1e-12
        assert told == (
            "Direction: at u = 0.5 it runs along the trajectory or is 0, and says no side; the frame goes on.",
        )


def test_where_d_only_touches_the_tangent_it_keeps_its_side():
    touching = [(1, 0, 1), (-1 / 3, 0, 1), (-1 / 3, 0, 1), (1, 0, 1)]  # x = (1 - 2 t)^2
    met = meetings(Cubic(touching), UPRIGHT)
    assert len(met.u) == 1 and met.u[0] == pytest.approx(0.5, abs=1e-3) and not len(met.flips)
    _, e2, _, _ = framed(UPRIGHT, Cubic(touching), 10)
    assert np.abs(e2 - (1, 0, 0)).max() < 1e-12


def test_a_stretch_along_the_tangent_is_turned_through_evenly():
    """Along z over the middle third, from x before it to y behind it."""
    straight = Polyline([(0, 0, 0), (0, 0, 1), (0, 0, 2), (0, 0, 3)])
    side = Arrows([(0, 1, 0, 0), (1 / 3, 0, 0, 1), (2 / 3, 0, 0, 1), (1, 0, 1, 0)])
    stations, e2, _, told = framed(straight, side, 31)
    angle = np.arctan2(e2[:, 1], e2[:, 0])
    assert np.diff(angle[10:21]).std() < 1e-9 and angle[0] == pytest.approx(0) and angle[-1] == pytest.approx(np.pi / 2)
    assert "runs along the trajectory" in told[0]


def test_refused_where_the_parameter_says_so():
    with pytest.raises(ShapeError, match=r"parallel: must be continue .*, got refuse at u = 0\.5$"):
        framed(UPRIGHT, Cubic(THROUGH, parallel="refuse"))
    with pytest.raises(ShapeError, match="must not run along the whole trajectory"):
        framed(UPRIGHT, Cubic([(0, 0, 1)] * 4))


def test_round_a_closed_trajectory_d_comes_back():
    circle = Arc(2.0, 2 * np.pi)
    _, e2, _, told = framed(circle, Cubic([(0, 0, 1)] * 4))
    assert np.abs(e2 - (0, 0, 1)).max() < 1e-14 and told == ()
    with pytest.raises(
        ShapeError, match="must come back to where it began on a closed trajectory, got it turned by 45 deg"
    ):
        framed(circle, Cubic([(0, 0, 1), (0, 0, 1), (1, 0, 1), (1, 0, 1)]))
    odd = Cubic(
        [(0, 0, 1), (0, 3, 0), (0, 0, -3), (0, 0, -1)]
    )  # d passes the tangent plane's side once: it comes back below
    with pytest.raises(ShapeError, match="must come back"):
        framed(circle, odd)


def test_a_tilt_turns_from_the_normal_that_turns_least():
    helix = Bezier([(0, 0, 0), (1, 1, 0), (2, 1, 1), (3, 0, 2)], tilts=[0.25, 1.0])
    stations, e2, _, _ = framed(helix, Tilt())
    normals, _ = rotation_minimizing(stations)
    assert signed_angle(normals, e2, stations.leave) == pytest.approx(0.25 + 0.75 * stations.u, abs=1e-12)


def test_arrows_are_met_where_they_stand():
    rows = [(0, 1, 0, 0), (0.25, 1, 2, 0), (0.7, -1, 2, 0), (1, -3, 0, 0)]
    t = np.array(rows)[:, 0]
    found = Arrows(rows).vectors(UPRIGHT, t)
    assert np.abs(found - unit(np.array(rows)[:, 1:])).max() < 1e-14


@pytest.mark.parametrize("rows, basis", [(5, Basis.BEZIER), (3, Basis.B_SPLINE), (5, Basis.HERMITE)])
def test_rows_that_make_no_segments_are_refused(rows, basis):
    with pytest.raises(ShapeError, match=r"^values: must (be|have)"):
        Cubic(np.ones((rows, 3)), basis)

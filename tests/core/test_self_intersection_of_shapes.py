# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Self-intersection of the other shapes: screws whose turns meet, contours over their axis, PD curves."""

import numpy as np
import pytest
from brute_force import crossing_faces

from sweep_addon.core.contours import Circle, Outline, Rectangle
from sweep_addon.core.rings.limits import Plane
from sweep_addon.core.self_intersection.faces import faces_of
from sweep_addon.core.shapes.pd_curve_sweep import PDCurveSweep
from sweep_addon.core.shapes.rotational_sweep import RotationalSweep
from sweep_addon.core.shapes.translational_sweep import TranslationalSweep
from sweep_addon.core.stations.directions import Arrows
from sweep_addon.core.stations.sampling import Count
from sweep_addon.core.trajectories import Formula, Line

THREAD = Outline([[(1, 0), (2, 0), (2, 0.5), (1, 0.5)]])
PARABOLA = Formula("u", "4*u^2", "0", start=-1.0, end=1.0)


def test_a_translational_sweep_is_clean_whatever_its_taper():
    places = TranslationalSweep(Rectangle(2, 2), 3.0, taper=0.3, hole_taper=-0.1).self_intersections()
    assert len(places) == 0 and places.largest_safe_size == np.inf


@pytest.mark.parametrize(("pitch", "clean"), [(0.501, True), (0.499, False)])
def test_the_turns_of_a_screw_meet_where_the_pitch_is_less_than_the_thread_is_high(pitch, clean):
    screw = RotationalSweep(THREAD, angle=6 * np.pi, pitch=pitch, samples=Count(60))
    places = screw.self_intersections()
    assert (not places) is clean is (not len(crossing_faces(screw.mesh())))
    assert places.largest_safe_size == pytest.approx(pitch / 0.5, abs=3e-4)  # helicoids have bent faces
    if places:
        assert {place.kind for place in places} <= {"global", "ends"}
        assert set(crossing_faces(screw.mesh())) <= set(faces_of(screw.mesh().chart, places))


def test_of_a_ball_and_a_ring_nothing_meets():
    half = Outline([[(0, -1), (0, 1)]], bulges=[(1, 0)], tolerance=0.01)
    for shape in (RotationalSweep(half), RotationalSweep(), RotationalSweep(THREAD, angle=2.0)):
        assert not shape.self_intersections()


def test_a_contour_over_the_axis_passes_through_itself_there():
    places = RotationalSweep(Circle(1.0), angle=1.0, crossing="keep").self_intersections()
    assert [place.kind for place in places] == ["local"] and "both sides of the axis" in str(places)
    assert not RotationalSweep(Circle(1.0), angle=1.0, crossing="split").self_intersections()


def test_a_pd_curve_sweep_folds_where_its_contour_reaches_the_centre_of_curvature():
    """y = 4 x^2 has the curvature 8 / (1 + 64 x^2)^(3/2); the direction is out of its plane, so e3 lies in it."""
    half = 0.3
    sweep = PDCurveSweep(Rectangle(0.1, 2 * half), PARABOLA, Arrows([(0, 0, 0, 1)]))
    x = np.sqrt((8 * half) ** (2 / 3) - 1) / 8
    assert sweep.self_intersections()[0].parameters[0] == pytest.approx((-x, x), abs=1e-6)
    assert any("reaches the centre of curvature" in said for said in sweep.mesh().told)
    thin = PDCurveSweep(Rectangle(2 * half, 0.1), PARABOLA, Arrows([(0, 0, 0, 1)])).self_intersections()
    assert not thin and thin.largest_safe_size == pytest.approx(1 / 8 / 0.05, rel=3e-5)


def test_planes_that_cut_a_solid_off_make_no_crossing():
    planes = Plane((0, 0, 0.5), (1, 0, 2)), Plane((0, 0, 3), (-1, 2, 3))
    assert not PDCurveSweep(Rectangle(0.4, 0.2), Line(end=(0, 0, 4)), Arrows(), *planes).self_intersections()

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A coarse area-true mesh has the volume of the true sweep: area times length, however the tube bends (Weyl 1939)."""

import numpy as np
import pytest
from solids import assert_solid

from sweep_addon.core.contours import Circle, Ellipse, Fit, Outline, Rectangle
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.rings.ends import Taper
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.stations.frames import FixedUp, Frenet, RotationMinimizing
from sweep_addon.core.stations.sampling import Count, Tolerance, place
from sweep_addon.core.trajectories import Arc, Bezier, Helix, Line, Polyline, TorusKnot

RING, TUBE = Arc(2.0, 2 * np.pi), Circle(0.5, points=16)
KNOT = TorusKnot(2, 3, 2.0, 0.8)
HELIX = Helix(2.0, 1.0, 2.0)
WAVE = Bezier([(0, 0, 0), (1, 2, 0), (2, -2, 1), (3, 0, 0)])
KINKED = Bezier([(0, 0, 0), (1, 2, 0), (2, 2, 1), (3, 0, 0), (3.5, 2, 0), (4, 2, -1), (6, 0, 0)])
QUARTER = 4 / 3 * np.tan(np.pi / 8)
HOOK = Bezier([(-9, 0, 0), (-6, 0, 0), (-3, 0, 0), (0, 0, 0), (QUARTER, 0, 0), (1, 1 - QUARTER, 0), (1, 1, 0)])
CENTRED = [Circle(0.2, points=7), Ellipse(0.3, 0.1, points=12), Rectangle(0.3, 0.2), Rectangle(0.4, 0.2, 0.05)]
ANGLE = Outline([[(0, 0), (0.4, 0), (0.4, 0.1), (0.1, 0.1), (0.1, 0.3), (0, 0.3)]])  # its centroid is (0.15, 0.1)


def missed(contour, trajectory, samples, truth=1.0, **others):
    """The volume of an area-true mesh over area times length times a truth, less 1."""
    samples = Count(samples) if isinstance(samples, int) else samples
    mesh = GeneralizedCylinder(contour, trajectory, samples, fit=Fit.AREA_TRUE, **others).mesh()
    return mesh.volume() / (contour.area * trajectory.length() * truth) - 1


def assert_order(errors, power):
    """From one to the next the steps are halved: the errors fall by a power of 2, a third of a step less at most."""
    falls = np.log2(np.abs(errors[:-1]) / np.abs(errors[1:]))
    assert falls.min() > power - 1 / 3, falls


@pytest.mark.parametrize("steps", [3, 8, 32])
@pytest.mark.parametrize("contour", [TUBE, *CENTRED])
def test_a_ring_has_the_volume_of_the_torus_however_few_its_steps(contour, steps):
    assert missed(contour, RING, steps) == pytest.approx(0, abs=1e-13)


@pytest.mark.parametrize("angle", [0.1, 1.0, 2.0, 6.0])
@pytest.mark.parametrize("contours", [3, 9])
def test_so_has_a_part_of_one(angle, contours):
    assert missed(TUBE, Arc(2.0, angle), max(contours, int(2 * angle))) == pytest.approx(0, abs=1e-13)


def test_the_asked_figures_where_an_inscribed_mesh_lacks_three_hundredths():
    assert abs(missed(TUBE, RING, 32)) < 3e-5
    assert abs(missed(Circle(0.5, points=16), KNOT, 400)) < 1e-5
    for trajectory, steps in ((RING, 32), (KNOT, 400)):
        inscribed = GeneralizedCylinder(TUBE, trajectory, Count(steps)).mesh().volume()
        assert 1 - inscribed / (TUBE.area * trajectory.length()) == pytest.approx(0.03, abs=0.005)


@pytest.mark.parametrize("contour", CENTRED)
@pytest.mark.parametrize("trajectory", [KNOT, HELIX, WAVE, KINKED], ids=["knot", "helix", "wave", "kinked"])
def test_the_error_falls_by_the_fourth_power_of_the_steps(trajectory, contour):
    """An inscribed mesh's falls by the second, and never below what its contour lacks."""
    steps = [65, 129, 257] if not trajectory.closed else [100, 200, 400]
    errors = np.array([missed(contour, trajectory, count) for count in steps])
    assert_order(errors, 4)
    assert np.abs(errors[0]) < 3e-6


@pytest.mark.parametrize("frame", [RotationMinimizing(3), Frenet(), FixedUp()], ids=lambda frame: type(frame).__name__)
@pytest.mark.parametrize("twist", ["0", "4*pi*t", "2*sin(2*pi*t)"])
def test_whatever_turns_the_contour_takes_nothing_from_it(frame, twist):
    for count in (33, 65, 129, 257, 513):
        assert abs(missed(Ellipse(0.3, 0.1, 12), HELIX, count, frame=frame, twist=twist)) < 5 / count**4


@pytest.mark.parametrize("sectors", [1, -3, 4])
@pytest.mark.parametrize("scale", [1.0, -1.0])
def test_a_contour_that_comes_back_turned_onto_itself_has_it_too(sectors, scale):
    """A square by quarters, a band by a half: from the last ring to the first it turns no more than elsewhere."""
    frame, count = RotationMinimizing(extra_sectors=sectors), 48
    for contour in (Rectangle(0.4, 0.4), Rectangle(0.6, 0.2), Circle(0.3, 6)):
        error = missed(contour, RING, count, frame=frame, scale_x=scale)
        assert error == pytest.approx(0, abs=1e-13)


@pytest.mark.parametrize("turns", [0.25, 0.5, 0.75])
def test_nor_does_a_step_that_turns_by_half_a_turn(turns):
    """Its columns meet on the axis, and a third of the section is left on the way."""
    for steps in (1, 4):
        error = missed(Rectangle(0.4, 0.2), Line(), steps + 1, twist=f"2*pi*{turns * steps}*t")
        assert error == pytest.approx(0, abs=1e-12)


LAWS = {  # of a scale, and its mean square along t
    "1 + t": 7 / 3,
    "exp(-t)": (1 - np.exp(-2)) / 2,
    "1 + 0.5*sin(2*pi*t)": 1.125,
    "t^2 - 2": 43 / 15,
}


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("trajectory", [Line(end=(0, 0, 2)), HELIX], ids=["line", "helix"])
@pytest.mark.parametrize("twist", ["0", "3*t"])
def test_scaled_on_the_way_it_has_the_volume_of_its_sections(law, trajectory, twist):
    def error(count):
        return missed(Circle(0.2, 16), trajectory, count, LAWS[law], scale_x=law, scale_y=law, twist=twist)

    assert abs(error(257)) < 1e-7
    assert abs(error(257)) < max(abs(error(129)) / 10, 1e-11)


def test_unequal_scales_twisted_against_each_other():
    """The mean of (1 + t)(2 - t) is 13 / 6; between the contours both are straight, so only the twist costs."""
    error = missed(Ellipse(0.4, 0.1), Line(), 9, 13 / 6, scale_x="1 + t", scale_y="2 - t", twist="2*t")
    assert error == pytest.approx(0, abs=1e-5)


def test_a_taper_is_a_cone_and_a_ball_is_nearly_a_ball():
    line = Line(end=(0, 0, 2))
    assert missed(TUBE, line, 9, 2 / 3, end=Taper(1.0)) == pytest.approx(0, abs=1e-13)
    ball = {"scale_x": "sqrt(1 - (2*t - 1)^2)", "scale_y": "sqrt(1 - (2*t - 1)^2)"}
    assert abs(missed(Circle(1.0, 16), line, 33, 2 / 3, **ball)) < 3e-5


@pytest.mark.parametrize("tolerances", [(1e-2, 1e-3, 1e-4)])
@pytest.mark.parametrize("trajectory", [KNOT, WAVE], ids=["knot", "wave"])
def test_adaptive_sampling_errs_by_the_square_of_its_tolerance(trajectory, tolerances):
    """A tolerance is a square of the steps."""
    errors = [abs(missed(Circle(0.1, 16), trajectory, Tolerance(chord))) for chord in tolerances]
    assert all(error < chord**2 for error, chord in zip(errors, tolerances, strict=True))
    assert errors[0] > 30 * errors[1] > 900 * errors[2]


@pytest.mark.parametrize("count", [12, 13, 14, 15, 40])
def test_a_long_straight_leg_before_a_bend_stays_where_it_is(count):
    """One step begins on the leg and ends in the bend: only where it bends does it have to move."""
    assert abs(missed(Circle(0.1, 16), HOOK, count)) < 3e-4
    fitted, plain = (
        GeneralizedCylinder(Circle(0.1, 16), HOOK, Count(count), fit=fit).mesh().vertices.reshape(16, count, 3)
        for fit in (Fit.AREA_TRUE, Fit.INSCRIBED)
    )
    straight = place(HOOK, Count(count)).s < 8
    moved = (fitted - plain).mean(axis=0)[straight]
    assert np.linalg.norm(moved, axis=1).max() < 1e-3


@pytest.mark.parametrize("contour", [*CENTRED, ANGLE])
def test_corners_keep_their_place_and_legs_their_section(contour):
    path = Polyline([(0, 0, 0), (5, 0, 0), (5, 5, 1), (0, 3, 0)])
    mesh = GeneralizedCylinder(contour, path, fit=Fit.AREA_TRUE).mesh()
    rings = mesh.vertices.reshape(-1, 4, 3)
    for leg in range(3):
        step = rings[:, leg + 1] - rings[:, leg]
        assert np.abs(np.cross(step, path.legs[leg])).max() < 1e-12
    if contour is not ANGLE:
        assert mesh.volume() == pytest.approx(contour.area * path.length(), rel=1e-12)


@pytest.mark.parametrize("off", [{}, {"offset_x": 0.3}, {"scale_x": -1.0}, {"scale_x": -1.5, "offset_x": -0.2}])
@pytest.mark.parametrize("steps", [5, 32])
def test_beside_its_trajectory_a_ring_has_the_volume_pappus_gives_it(off, steps):
    """Area times the way of the centroid. The first normal is level, here away from the axis."""
    scale, offset = off.get("scale_x", 1.0), off.get("offset_x", 0.0)
    truth = abs(scale) * (2 + offset + 0.15 * scale) / 2
    assert missed(ANGLE, RING, steps, truth, **off) == pytest.approx(0, abs=1e-12)


def test_an_angle_carried_round_a_helix_errs_by_the_square_of_its_steps():
    """The Frenet frame turns it about the path: A L (1 - curvature times the centroid's way towards the centre)."""
    helix = Helix(2.0, 3.0, 2.0)
    curvature = 2 / (4 + (3 / (2 * np.pi)) ** 2)
    errors = [missed(ANGLE, helix, n, 1 - curvature * 0.15, frame=Frenet()) for n in (33, 65, 129)]
    assert max(map(abs, errors)) < 3e-5
    assert_order(np.array(errors), 2)


def test_the_ends_keep_their_planes():
    rings = GeneralizedCylinder(TUBE, WAVE, Count(9), fit=Fit.AREA_TRUE).mesh().vertices.reshape(16, 9, 3)
    for station, u in ((0, 0.0), (-1, 1.0)):
        here = np.array([u])
        ahead = (rings[:, station] - WAVE.evaluate(here)) @ WAVE.tangents(here)[0]
        assert np.abs(ahead).max() < 1e-12


@pytest.mark.parametrize("fit", [Fit.AREA_TRUE, Fit.CIRCUMSCRIBED])
@pytest.mark.parametrize(
    ("trajectory", "contours", "degrees"),
    [(Arc(2.0, 6.2), 2, 177.6), (Helix(2.0, 1e-3, 2.0), 5, 90.0), (Helix(2.0, 1e-3, 3.0), 4, 90.0)],
)
def test_steps_that_lose_the_trajectory_are_refused(trajectory, contours, degrees, fit):
    with pytest.raises(ShapeError, match=r"^samples: must be more if the fit is [a-z-]+: a chord may") as info:
        GeneralizedCylinder(Circle(0.1), trajectory, Count(contours), fit=fit).mesh()
    assert float(str(info.value).rpartition(" ")[2]) == pytest.approx(degrees, abs=0.1)
    GeneralizedCylinder(Circle(0.1), trajectory, Count(contours)).mesh()


def test_a_fit_is_chosen_by_name():
    assert GeneralizedCylinder(fit="area-true").fit is Fit.AREA_TRUE and GeneralizedCylinder().fit is Fit.INSCRIBED
    with pytest.raises(ShapeError, match="^fit: must be one of inscribed, area-true, circumscribed, got 'exact'$"):
        GeneralizedCylinder(fit="exact")


def test_where_nothing_bends_nothing_moves():
    """To the bit, whatever rounding says of the length of a straight step."""
    line = Line((0.1, 0.2, 0.3), (1.3, -2.7, 0.9))
    plain, fitted = (
        GeneralizedCylinder(Rectangle(0.2, 0.1), line, Count(30), fit=fit).mesh().vertices
        for fit in (Fit.INSCRIBED, Fit.AREA_TRUE)
    )
    assert np.abs(fitted - plain).max() < 1e-15
    assert_solid(GeneralizedCylinder(Rectangle(0.2, 0.1), line, Count(30), fit=Fit.AREA_TRUE).mesh(), euler=2)

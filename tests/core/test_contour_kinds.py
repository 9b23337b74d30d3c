# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Contours by formula have the areas and points that geometry gives them, and sweep to solids."""

from math import pi, sqrt

import numpy as np
import pytest
from solids import assert_solid

from sweep_addon.core.contours import (
    Circle,
    Ellipse,
    Outline,
    Rectangle,
    RegularPolygon,
    ScrewThread,
    Section,
    Star,
    Superellipse,
)
from sweep_addon.core.rings.ends import Taper
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.trajectories import Helix, Line, TorusKnot

SLOT = Outline([[(0.2, 0.1), (-0.2, 0.1), (-0.2, -0.1), (0.2, -0.1)]], [[0, 1, 0, 1]])
CONTOURS = [
    Circle(0.2, points=7),
    Ellipse(0.2, 0.02),
    Rectangle(0.4, 0.1, 0.05, corner_points=2),
    RegularPolygon(3, 0.2),
    RegularPolygon(7, 0.2, "sides", rounding=0.05),
    RegularPolygon(5, 0.2, "sides", rounding=0.2),
    Star(5, 0.2, 0.05),
    Star(2, 0.2, 0.1),
    Superellipse(0.4, 0.3, 0.25),
    Superellipse(0.4, 0.1, 1.0),
    Superellipse(0.4, 0.3, 100.0, quarter_points=5),
    ScrewThread(0.4, 0.15, starts=2, points=16),
    SLOT,
]
SHAPED = [(contour, f"{type(contour).__name__}-{i}") for i, contour in enumerate(CONTOURS)]


@pytest.mark.parametrize("contour", [c for c, _ in SHAPED], ids=[name for _, name in SHAPED])
@pytest.mark.parametrize("trajectory", [Line(), Helix(1.0, 0.6, 1.2), TorusKnot()], ids=["line", "helix", "knot"])
def test_every_kind_sweeps_to_a_solid(contour, trajectory):
    mesh = GeneralizedCylinder(contour, trajectory, samples={"kind": "count", "contours": 90}).mesh()
    assert_solid(mesh, euler=0 if trajectory.closed else 2)


@pytest.mark.parametrize("contour", [c for c, _ in SHAPED], ids=[name for _, name in SHAPED])
def test_every_kind_is_a_loop_that_a_stranger_could_have_given(contour):
    """Checked as an outline from a file would be, it has no crossing, keeps its points and runs counter-clockwise."""
    section = contour.section()
    checked = Section.from_loops([section.points])
    assert np.array_equal(checked.points, section.points)
    assert section.areas[0] > 0


def test_a_taper_closes_a_star_in_one_vertex():
    mesh = GeneralizedCylinder(Star(7, 0.2, 0.1), Line(), end=Taper(0.5)).mesh()
    assert_solid(mesh, euler=2)


@pytest.mark.parametrize("points", [3, 4, 17, 64])
def test_an_ellipse_is_the_image_of_a_regular_polygon(points):
    section = Ellipse(3.0, 0.5, points).section()
    assert section.area == pytest.approx(points / 2 * 1.5 * np.sin(2 * pi / points), rel=1e-12)
    assert (section.points / (3.0, 0.5)) ** 2 @ (1, 1) == pytest.approx(1, abs=1e-12)
    assert Ellipse(3.0, 0.5).area == pytest.approx(1.5 * pi, rel=1e-15)
    assert not section.sharp.any()


@pytest.mark.parametrize(
    ("sides", "area"), [(3, sqrt(27) / 4), (4, 2), (6, sqrt(27) / 2), (8, sqrt(8)), (12, 3)], ids=str
)
def test_a_regular_polygon_has_the_area_that_geometry_gives_it(sides, area):
    """Triangle, square, hexagon, octagon and dodecagon in the unit circle."""
    polygon = RegularPolygon(sides, 2.0)
    assert polygon.section().area == pytest.approx(4 * area, rel=1e-12)
    assert polygon.area == pytest.approx(4 * area, rel=1e-12)
    assert polygon.section().sharp.all()
    assert polygon.section().points[0] == pytest.approx([2, 0], abs=1e-12)


def test_a_nut_is_measured_across_flats():
    """Of an M8 nut, 13 mm across flats, the corners are 15.01 mm apart."""
    corners = RegularPolygon(6, 6.5, radius_to="sides").section().points
    assert np.ptp(corners[:, 1]) == pytest.approx(13, abs=1e-12)
    assert np.ptp(corners[:, 0]) == pytest.approx(15.01, abs=0.005)


@pytest.mark.parametrize("sides", [3, 4, 6])
@pytest.mark.parametrize("rounding", [0.1, 0.5])
def test_rounding_takes_off_what_is_between_a_polygon_and_its_inscribed_circle(sides, rounding):
    """As many corners of radius r leave out what a polygon about a circle of radius r has beyond it."""
    sharp = RegularPolygon(sides, 1.0, "sides")
    many = RegularPolygon(sides, 1.0, "sides", rounding, corner_points=200)
    beyond = RegularPolygon(sides, rounding, "sides").area - pi * rounding**2
    assert many.area == pytest.approx(sharp.area - beyond, rel=1e-12)
    assert many.section().area == pytest.approx(many.area, rel=1e-4)
    assert not many.section().sharp.any()


def test_a_polygon_rounded_to_its_sides_is_a_circle():
    section = RegularPolygon(5, 2.0, "sides", rounding=2.0, corner_points=9).section()
    assert len(section.points) == 5 * 8
    assert np.hypot(*section.points.T) == pytest.approx(2, abs=1e-12)


def test_a_pentagram_has_the_area_of_the_golden_ratio():
    """Its inner corners are at 1 / phi^2 of the tips; its area is 5 / 2 sin 36 degrees times twice that."""
    phi = (1 + sqrt(5)) / 2
    star = Star(5, 1.0, phi**-2)
    tips, section = star.section().points[::2], star.section()
    assert section.area == pytest.approx(star.area, rel=1e-12)
    assert star.area == pytest.approx(5 * phi**-2 * sqrt(10 - 2 * sqrt(5)) / 4, rel=1e-12)
    along, inner = tips[2] - tips[0], section.points[1] - tips[0]
    assert along[0] * inner[1] - along[1] * inner[0] == pytest.approx(0, abs=1e-12), "its sides are diagonals"
    assert section.sharp.all()


@pytest.mark.parametrize(
    ("exponent", "part"),
    [(0.5, 1 / 6), (2 / 3, 3 * pi / 32), (1, 1 / 2), (2, pi / 4), (4, 0.9270373386), (100, 0.99984)],
    ids=["parabolas", "astroid", "rhombus", "ellipse", "4", "100"],
)
def test_a_superellipse_has_its_part_of_the_rectangle_around_it(exponent, part):
    """Of exponent 4 that is Gamma(1/4)^2 / (8 sqrt(pi)), of a large exponent n about 1 - pi^2 / 6n^2."""
    figure = Superellipse(3.0, 2.0, exponent, quarter_points=512)
    assert figure.area == pytest.approx(6 * part, rel=1e-6 if exponent < 100 else 1e-5)
    assert figure.section().area == pytest.approx(figure.area, rel=1e-4)


@pytest.mark.parametrize("exponent", [0.25, 0.5, 1, 1.2, 2, 2.5, 10, 100])
def test_points_of_a_superellipse_lie_on_it_and_cut_off_equal_areas(exponent):
    """At equal steps of affine arc length; next to the axes, where the curvature has no bound or is 0, they differ."""
    figure = Superellipse(3.0, 2.0, exponent, quarter_points=16)
    points, apexes = figure.section().points, figure.apexes()
    assert (np.abs(points / (1.5, 1.0)) ** exponent) @ (1, 1) == pytest.approx(1, abs=1e-9)
    edge, rise = np.roll(points, -1, axis=0) - points, apexes - points
    cut = np.abs(edge[:, 0] * rise[:, 1] - edge[:, 1] * rise[:, 0])
    inner = cut.reshape(4, 16)[:, 1:-1]
    assert np.ptp(inner) < 0.06 * inner.min() + 1e-12
    assert cut.max() < 30 * inner.max() + 1e-12


def test_a_superellipse_of_exponent_2_has_the_points_of_an_ellipse():
    figure, ellipse = Superellipse(3.0, 2.0, 2.0, quarter_points=16), Ellipse(1.5, 1.0, 64)
    assert figure.section().points == pytest.approx(ellipse.section().points, abs=1e-6)


@pytest.mark.parametrize(("exponent", "corners"), [(0.5, 4), (1, 4), (1.5, 0), (2, 0), (2.5, 0), (100, 0)])
@pytest.mark.parametrize("width", [1.0, 20.0])
def test_a_superellipse_is_sharp_at_its_tips_only(exponent, corners, width):
    section = Superellipse(width, 1.0, exponent).section()
    assert section.sharp.sum() == corners
    assert np.abs(section.points[section.sharp]).min(axis=1) == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize("exponent", [0.25, 1, 2, 100])
def test_a_superellipse_keeps_its_symmetry_to_rounding(exponent):
    points = Superellipse(1.0, 1.0, exponent).section().points
    assert np.array_equal(points[16:32], points[:16, ::-1] * (-1, 1))
    assert points[:17] == pytest.approx(points[16::-1, ::-1], abs=1e-15)

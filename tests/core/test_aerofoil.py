# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Aerofoils have the coordinates, thickness, camber and nose that were published for them."""

from math import pi
from pathlib import Path

import numpy as np
import pytest
from solids import assert_solid

from sweep_addon.core.contours import Aerofoil, Section
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.trajectories import Line

NACA = Path(__file__).parents[1] / "data" / "naca"
CODES = [
    f"{camber}{place}{thickness:02}"
    for camber, place in ((0, 0), (1, 1), (9, 1), (9, 9), (2, 4))
    for thickness in (1, 12, 40, 99)
]


def published(code):
    return np.loadtxt(NACA / f"naca{code}.dat", skiprows=1)


def profile(code, **options):
    """A section whose coordinates are those of tables: the nose at the origin, the chord 1."""
    return Aerofoil(code, reference=0.0, **options).section()


def test_points_of_a_0012_are_the_published_ones():
    """The table has the same spacing, 35 points a side, and 7 decimals."""
    section = profile("0012", trailing_edge="open", side_points=35)
    assert np.abs(section.points - published("0012")).max() < 1.5e-7


@pytest.mark.parametrize("code", ["1412", "2414"])
def test_published_points_lie_on_a_cambered_aerofoil(code):
    """The tables were computed by hand or from other stations, and have 5 decimals; all are within 1e-4 of a chord."""
    section = profile(code, trailing_edge="open", side_points=512)
    start, along = section.points, section.points[section.following] - section.points
    to = published(code)[:, None] - start
    part = np.clip((to * along).sum(axis=2) / (along**2).sum(axis=1), 0, 1)
    distance = np.linalg.norm(to - part[..., None] * along, axis=2).min(axis=1)
    assert distance.max() < 1e-4 and distance.mean() < 7e-6


@pytest.mark.parametrize("edge", ["open", "closed"])
def test_the_greatest_thickness_is_at_three_tenths_of_the_chord(edge):
    """By definition of the series; the last coefficient moves it by little."""
    section = profile("0015", side_points=512, trailing_edge=edge)
    top = section.points[section.points[:, 1].argmax()]
    assert top[1] == pytest.approx(0.075, abs=3e-5)
    assert top[0] == pytest.approx(0.3, abs=4e-3)


@pytest.mark.parametrize("code", ["0006", "0012", "0024"])
def test_the_nose_has_its_published_radius(code):
    """NACA Report 460: 1.1019 times the square of the thickness; by the circle through the nose and its neighbours."""
    section = profile(code, side_points=512)
    x, y = section.points[510]
    assert section.points[511] == pytest.approx([0, 0], abs=1e-15)
    assert (x * x + y * y) / (2 * x) == pytest.approx(1.1019 * (int(code) / 100) ** 2, rel=2e-2)


@pytest.mark.parametrize(("code", "camber", "place"), [("2412", 0.02, 0.4), ("4706", 0.04, 0.7), ("9112", 0.09, 0.1)])
def test_the_middle_of_both_sides_rises_to_the_camber_at_its_place(code, camber, place):
    upper, lower = (side[::-1] for side in Aerofoil(code, reference=0.0).sides(np.linspace(0, pi, 4001)))
    middle = (upper + lower) / 2
    assert middle[:, 1].max() == pytest.approx(camber, abs=1e-8)
    assert middle[middle[:, 1].argmax(), 0] == pytest.approx(place, abs=1e-3)


@pytest.mark.parametrize(("edge", "last"), [("open", 0.1015), ("closed", 0.1036)])
def test_a_symmetric_aerofoil_has_the_integral_of_its_polynomial(edge, last):
    """Twice the integral of t / 0.2 (0.2969 sqrt(x) - 0.126 x - 0.3516 x^2 + 0.2843 x^3 - last x^4)."""
    expected = 2 * 0.12 / 0.2 * (0.2969 * 2 / 3 - 0.126 / 2 - 0.3516 / 3 + 0.2843 / 4 - last / 5)
    wing = Aerofoil("0012", chord=3.0, trailing_edge=edge, side_points=512)
    assert wing.area == pytest.approx(9 * expected, rel=1e-12)
    assert wing.section().area == pytest.approx(9 * expected, rel=1e-5)


@pytest.mark.parametrize("edge", ["open", "closed"])
@pytest.mark.parametrize("code", CODES)
def test_an_aerofoil_has_the_area_to_which_its_polygons_go(code, edge):
    """What a polygon misses falls by 4 when its points are doubled, so 4/3 and -1/3 of two of them leave little."""
    coarse, fine = (profile(code, trailing_edge=edge, side_points=n).area for n in (201, 401))
    assert Aerofoil(code, trailing_edge=edge).area == pytest.approx((4 * fine - coarse) / 3, rel=2e-6)


@pytest.mark.parametrize("side_points", [3, 4, 33, 200])
@pytest.mark.parametrize("edge", ["open", "closed"])
@pytest.mark.parametrize("code", CODES)
def test_no_aerofoil_crosses_itself(code, edge, side_points):
    section = profile(code, trailing_edge=edge, side_points=side_points)
    assert len(Section.from_loops([section.points]).points) == 2 * side_points - (2 if edge == "closed" else 1)


def test_the_trailing_edge_is_sharp_and_nothing_else():
    closed, blunt = (profile("2412", trailing_edge=edge) for edge in ("closed", "open"))
    assert closed.points[closed.sharp] == pytest.approx(np.array([[1, 0]]), abs=1e-15)
    assert blunt.sharp.sum() == 2
    assert np.ptp(blunt.points[blunt.sharp][:, 1]) == pytest.approx(0.0021 * 2 * 0.12 / 0.2, rel=3e-3)


def test_the_reference_point_is_a_quarter_of_the_chord_behind_the_nose():
    """So a wing is twisted about the quarter chord."""
    points = Aerofoil("0012", chord=2.0).section().points
    assert points[:, 0].min() == pytest.approx(-0.5, abs=1e-12)
    assert points[:, 0].max() == pytest.approx(1.5, abs=1e-12)


def test_a_wing_is_a_solid_of_its_area_times_its_span():
    for edge in ("open", "closed"):
        wing = Aerofoil("4415", chord=0.5, trailing_edge=edge)
        mesh = GeneralizedCylinder(wing, Line(end=(0, 3, 0))).mesh()
        assert_solid(mesh, euler=2)
        assert mesh.volume() == pytest.approx(3 * wing.section().area, rel=1e-12)


def test_every_code_of_four_digits_is_an_aerofoil_or_refused():
    made = 0
    for code in range(0, 10_000, 7):
        try:
            Aerofoil(f"{code:04}")
            made += 1
        except ShapeError as refusal:
            assert str(refusal).startswith("code: must have ")
            assert (code >= 1000) != (code // 100 % 10 > 0) or code % 100 == 0
    assert made > 1100

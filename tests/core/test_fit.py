# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Polygons fitted to curves have the area of the curve, or contain it, and leave straight sides on their lines."""

import numpy as np
import pytest
from contour_inputs import OUTLINES, drawn, square, star
from hypothesis import given
from hypothesis import strategies as st

from sweep_addon.core.contours import (
    Aerofoil,
    Circle,
    Ellipse,
    Fit,
    Outline,
    Rectangle,
    RegularPolygon,
    Section,
    Star,
    Superellipse,
    fitted,
)
from sweep_addon.core.declared.parameters import ShapeError

CURVED = [
    Circle(2.0, points=3),
    Circle(2.0, points=64),
    Ellipse(3.0, 0.2, points=9),
    Rectangle(3.0, 1.0, 0.5, corner_points=3),
    Rectangle(1.0, 1.0, 0.1, corner_points=2),
    RegularPolygon(5, 1.0, rounding=0.3),
    RegularPolygon(5, 1.0, "sides", rounding=1.0, corner_points=2),
    Superellipse(3.0, 2.0, 0.5),
    Superellipse(3.0, 2.0, 4.0, quarter_points=3),
    Aerofoil("2412"),
    Aerofoil("9112", trailing_edge="open", side_points=9),
    Outline([[(0.5, 0.5), (-0.5, 0.5), (-0.5, -0.5), (0.5, -0.5)], [(0.2, 0), (-0.2, 0)]], [[0.4, -0.3, 0, 0], [1, 1]]),
]
NAMES = [f"{type(contour).__name__}-{i}" for i, contour in enumerate(CURVED)]


def beyond(points, section):
    """How far points lie outside a section: by the even-odd rule, and the distance to the nearest edge."""
    start, end = section.points, section.points[section.following]
    along, to = end - start, points[:, None] - start
    part = np.clip((to * along).sum(axis=2) / (along**2).sum(axis=1), 0, 1)
    distance = np.linalg.norm(to - part[..., None] * along, axis=2).min(axis=1)
    level = points[:, 1:]
    passes = (start[:, 1] > level) != (end[:, 1] > level)
    with np.errstate(divide="ignore", invalid="ignore"):
        met = start[:, 0] + (level - start[:, 1]) * along[:, 0] / along[:, 1]
    inside = (passes & (met > points[:, :1])).sum(axis=1) % 2 == 1
    return np.where(inside, 0, distance)


@pytest.mark.parametrize("contour", CURVED, ids=NAMES)
def test_an_inscribed_polygon_is_the_section(contour):
    assert np.array_equal(fitted(contour, Fit.INSCRIBED).points, contour.section().points)


@pytest.mark.parametrize("contour", CURVED, ids=NAMES)
def test_an_area_true_polygon_has_the_area_of_the_curve(contour):
    section = fitted(contour, Fit.AREA_TRUE)
    assert section.area == pytest.approx(contour.area, rel=1e-12)
    assert len(section.points) == len(contour.section().points)
    Section.from_loops(np.split(section.points, section.offsets[1:-1]))


@pytest.mark.parametrize("outline", OUTLINES, ids=lambda outline: outline["id"])
def test_outlines_of_lines_and_arcs_get_their_area_whatever_the_tolerance(outline):
    for tolerance in (0.0, np.ptp(outline["vertices"], axis=0).max() / 50):
        contour = drawn(outline, tolerance)
        assert contour.area == pytest.approx(outline["area"], rel=1e-6)
        assert fitted(contour, Fit.AREA_TRUE).area == pytest.approx(contour.area, rel=1e-12)


@pytest.mark.parametrize("points", [3, 8, 64])
@pytest.mark.parametrize("contour", [Circle(2.0), Ellipse(3.0, 0.1)], ids=["circle", "ellipse"])
def test_circles_and_ellipses_are_scaled(contour, points):
    """By 1 / cos(pi / n) to touch the circle, by the square root of 2 pi / n / sin(2 pi / n) to have its area."""
    contour = type(contour)(*[2.0, points] if isinstance(contour, Circle) else [3.0, 0.1, points])
    step, inscribed = 2 * np.pi / points, contour.section().points
    about, equal = (fitted(contour, fit).points for fit in (Fit.CIRCUMSCRIBED, Fit.AREA_TRUE))
    assert about == pytest.approx(inscribed / np.cos(step / 2), abs=1e-12)
    assert equal == pytest.approx(inscribed * np.sqrt(step / np.sin(step)), abs=1e-12)


@pytest.mark.parametrize("contour", CURVED[:-1], ids=NAMES[:-1])
def test_a_circumscribed_polygon_contains_the_curve(contour):
    """The curve as a polygon of very many points; of curves other than conics the farthest point is nearly known."""
    finer = {"points": 999, "corner_points": 199, "quarter_points": 199, "side_points": 299}
    known = {name: many for name, many in finer.items() if hasattr(contour, name)}
    curve = type(contour)(**vars(contour) | known).section().points
    inscribed, section = contour.section(), fitted(contour, Fit.CIRCUMSCRIBED)
    conic = not isinstance(contour, (Superellipse, Aerofoil))
    allowed = 1e-9 * section.size if conic else 0.1 * beyond(curve, inscribed).max()
    assert beyond(curve, section).max() <= allowed + 1e-12
    assert beyond(inscribed.points, section).max() <= allowed + 1e-12


@pytest.mark.parametrize("outline", OUTLINES, ids=lambda outline: outline["id"])
def test_circumscribed_outlines_contain_their_arcs(outline):
    """One of them has arcs that leave their lines at a hollow angle of a degree: there a fifth is missed."""
    contour = drawn(outline)
    size = contour.section().size
    curve = Outline(contour.loops, contour.bulges, size / 1e5).section().points
    missed = beyond(curve, fitted(contour, Fit.CIRCUMSCRIBED)).max()
    assert missed <= (beyond(curve, contour.section()).max() / 5 if outline["id"] == "dxf2gcode-031" else 1e-9 * size)


@pytest.mark.parametrize("fit", Fit)
@pytest.mark.parametrize("corner_points", [2, 8])
def test_straight_sides_stay_on_their_lines(fit, corner_points):
    points = fitted(Rectangle(3.0, 2.0, 0.4, corner_points), fit).points
    assert np.abs(points).max(axis=0) == pytest.approx([1.5, 1.0], abs=1e-12)
    assert (np.abs(np.abs(points[:, 0]) - 1.5) < 1e-12).sum() == 4


@pytest.mark.parametrize("fit", Fit)
@pytest.mark.parametrize(
    "contour", [Star(), RegularPolygon(5), Rectangle(), Outline([square(1)])], ids=lambda c: type(c).__name__
)
def test_what_has_no_curves_is_left_as_it_is(contour, fit):
    assert np.array_equal(fitted(contour, fit).points, contour.section().points)
    assert contour.section().area == pytest.approx(contour.area, rel=1e-15)


def test_a_hole_is_fitted_from_within():
    """A circumscribed ring contains the ring: its hole is inscribed in the true hole."""
    ring = Outline([[(-2, 0), (2, 0)], [(-1, 0), (1, 0)]], [[1, 1], [-1, -1]], tolerance=0.05)
    about, equal = (fitted(ring, fit) for fit in (Fit.CIRCUMSCRIBED, Fit.AREA_TRUE))
    outer, inner = (np.hypot(*part.T) for part in np.split(about.points, about.offsets[1:-1]))
    chords = len(outer)
    assert outer * np.cos(np.pi / chords) == pytest.approx(2, abs=1e-12)
    assert inner == pytest.approx(1, abs=1e-12)
    assert equal.area == pytest.approx(3 * np.pi, rel=1e-12)


@given(st.integers(0, 2**32 - 1), st.integers(3, 12), st.sampled_from([1e-4, 1e-2]))
def test_whatever_outline_is_fitted_has_its_area_and_does_not_cross(seed, corners, tolerance):
    """Arcs to either side, straight lines between them, corners of any angle; some are too near one another."""
    rng = np.random.default_rng(seed)
    bulges = rng.uniform(-0.8, 0.8, corners) * rng.integers(0, 2, corners)
    try:
        contour = Outline([star(rng, corners)], [bulges], tolerance)
    except ShapeError:
        return
    try:
        section = fitted(contour, Fit.AREA_TRUE)
    except ShapeError as refusal:
        assert (
            str(refusal) == "fit: must be inscribed where curves are as close and edges as few as here, got 'area-true'"
        )
        return
    assert section.area == pytest.approx(contour.area, rel=1e-11)
    Section.from_loops([section.points])


def test_a_fit_may_be_told_by_its_name():
    """An area-true triangle for a circle of radius 2 has the circle's area."""
    assert fitted(Circle(2.0, points=3), "area-true").area == pytest.approx(4 * np.pi, rel=1e-12)
    with pytest.raises(ShapeError, match="^fit: must be one of inscribed, area-true, circumscribed, got 'area'"):
        fitted(Circle(), "area")

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Offsets of contours: every place on their lines and arcs is at the distance from the true contour."""

import numpy as np
import pytest
from contour_inputs import OUTLINES, drawn

import sweep_addon as sw
from sweep_addon.core.contours import Circle, Ellipse, Outline, Rectangle, Star
from sweep_addon.core.contours.arcs import arc_points
from sweep_addon.core.declared.parameters import ShapeError

pytest.importorskip("manifold3d")
offset = sw.contours.offset
NOTCH = Outline([[(0, 0), (4, 0), (4, 3), (2.3, 3), (2, 1), (1.7, 3), (0, 3)]])


def ends(outline):
    """Start, end and bulge of each edge."""
    for loop, bulges in zip(outline.loops, outline.bulges or [np.zeros(len(p)) for p in outline.loops], strict=True):
        points = np.asarray(loop)
        yield from zip(points, np.roll(points, -1, axis=0), np.asarray(bulges), strict=True)


def distances(points, outline):
    """How far points are from the lines and arcs of an outline, edge by edge, by formula."""
    found = np.full(len(points), np.inf)
    for a, b, bulge in ends(outline):
        found = np.minimum(found, np.hypot(*(points - a).T))
        way = b - a
        if bulge == 0:
            t = np.clip((points - a) @ way / (way @ way), 0, 1)
            found = np.minimum(found, np.hypot(*(points - a - t[:, None] * way).T))
        else:
            left = np.array((-way[1], way[0]))
            centre = (a + b) / 2 + left * (1 - bulge**2) / (4 * bulge)
            radius = np.hypot(*(a - centre))
            angle = np.arctan2(*(points - centre).T[::-1]) - np.arctan2(*(a - centre)[::-1])
            on = (angle * np.sign(bulge)) % (2 * np.pi) <= 4 * np.arctan(abs(bulge))
            found = np.where(on, np.minimum(found, np.abs(np.hypot(*(points - centre).T) - radius)), found)
    return found


def places(outline, each=5):
    """Places on all lines and arcs."""
    a, b, bulge = map(np.array, zip(*ends(outline), strict=True))
    return arc_points(a, b, np.where(bulge == 0, 1e-12, bulge), np.full(len(a), each))


def test_a_disc_on_a_circle_leaves_the_ring_of_the_lecture():
    """A disc of radius 1 along a circle of radius 5: boundaries of 4 and 6."""
    ring = offset(Circle(5.0), 1.0, both=True)
    assert ring.area == pytest.approx(20 * np.pi, rel=1e-12)
    radii = [np.hypot(*np.asarray(loop).T) for loop in ring.loops]
    np.testing.assert_allclose(np.sort(np.concatenate(radii)), [4, 4, 6, 6], rtol=1e-12)


@pytest.mark.parametrize("distance", [0.001, 0.5, 30.0])
def test_a_square_gets_four_quarter_circles(distance):
    outline = offset(Rectangle(1.0, 1.0), distance)
    assert outline.area == pytest.approx(1 + 4 * distance + np.pi * distance**2, rel=1e-12)
    assert sorted(np.asarray(outline.bulges[0]).round(9)) == [0.0] * 4 + [0.414213562] * 4


def test_inwards_a_square_stays_one_and_a_circle_a_circle():
    assert offset(Rectangle(1.0, 1.0), -0.2).area == pytest.approx(0.36, rel=1e-12)
    assert offset(Circle(2.0), -0.5).area == pytest.approx(2.25 * np.pi, rel=1e-12)


def test_arcs_that_trim_each_other_end_where_they_cross():
    """The two upper corners of a notch of 0.6 m close it: their circles meet above its middle."""
    outline = offset(NOTCH, 0.35)
    (loop,) = outline.loops
    crossing = np.array((2.0, 3 + np.sqrt(0.35**2 - 0.3**2)))
    assert np.hypot(*(np.asarray(loop) - crossing).T).min() < 1e-12
    assert distances(places(outline), NOTCH) == pytest.approx(0.35, abs=1e-11)


@pytest.mark.thorough
@pytest.mark.parametrize("part", [0.02, 0.1, 0.3, -0.03])
def test_real_outlines_are_offset_exactly(part):
    for number, given in enumerate(OUTLINES):
        source = drawn(given)
        size = source.section().size
        try:
            outline = offset(source, part * size)
        except ShapeError as refusal:
            assert part < 0 and "must leave something" in str(refusal)
            continue
        error = np.abs(distances(places(outline), source) - abs(part) * size) / size
        assert error.max() < 5e-6, number  # where pieces cross at a few hundredths of a degree
        assert np.median(error) < 1e-9, number


def test_both_sides_are_the_difference_of_one_and_the_other():
    source = drawn(OUTLINES[3])
    distance = 0.02 * source.section().size
    both, out, inside = offset(source, distance, both=True), offset(source, distance), offset(source, -distance)
    assert both.area == pytest.approx(out.area - inside.area, rel=1e-12)


@pytest.mark.parametrize("contour", [Ellipse(2.0, 1.0), Star(5, 1.0, 0.5), Rectangle(2.0, 1.0, rounding=0.3)])
def test_steiner_holds_for_convex_contours_and_bounds_others(contour):
    """Area + perimeter d + pi d^2, exact for a convex curve, and more than there is where corners are hollow."""
    distance = 0.2
    section = contour.section()
    perimeter, area = section.perimeters.sum(), getattr(contour, "area", section.area)
    expected = area + perimeter * distance + np.pi * distance**2
    found = offset(contour, distance).area
    if isinstance(contour, Star):
        assert found < expected
    else:
        assert found == pytest.approx(expected, rel=2e-3)  # the perimeter is that of chords


def test_refusals():
    with pytest.raises(ShapeError, match="distance: must leave something inside, got -0.6"):
        offset(Rectangle(1.0, 1.0), -0.6)
    with pytest.raises(ShapeError, match="distance: must not be 0"):
        offset(Rectangle(1.0, 1.0), 0)
    with pytest.raises(ShapeError, match="contour: must be closed"):
        offset(Outline([[(0, 0), (1, 0), (1, 1)]], closed=False), 0.1)
    with pytest.raises(ShapeError, match="distance: must be a number"):
        offset(Rectangle(1.0, 1.0), "far")

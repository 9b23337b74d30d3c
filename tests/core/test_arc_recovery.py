# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arcs recovered from chords: outlines of arcs, flattened, come back as they were."""

import numpy as np
import pytest

import sweep_addon as sw

SLOT = sw.contours.Outline([[(0, 0), (3, 0), (3, 1), (0, 1)]], [[0, 1, 0, 1]], tolerance=1e-3)
PLATE = sw.contours.Outline(
    [[(0, 0), (4, 0), (4, 2), (3, 3), (0, 3)], [(1, 1), (2, 1)]], [[0, 0, 0.3, -0.2, 0], [1, 1]], tolerance=1e-4
)
CRESCENT = sw.contours.Outline([[(0, 0), (2, 0)]], [[1.0, -0.6]], tolerance=1e-4)


def flattened(outline):
    section = outline.section()
    return sw.contours.Outline(np.split(section.points, section.offsets[1:-1]))


@pytest.mark.parametrize("outline", [SLOT, PLATE, CRESCENT])
@pytest.mark.parametrize("noise", [0.0, 1e-7])
def test_flattened_arcs_are_arcs_again(outline, noise):
    """Noise is that of single precision, which Blender keeps."""
    flat = flattened(outline)
    loops = [loop.values + noise * np.random.default_rng(0).normal(size=loop.values.shape) for loop in flat.loops]
    found = sw.contours.recover_arcs(sw.contours.Outline(loops))
    assert found.area == pytest.approx(outline.area, rel=1e-6 if noise else 1e-12)
    assert sum(map(len, found.loops)) <= sum(map(len, outline.loops)) + 2  # arcs beyond half a turn are two
    assert sum(np.count_nonzero(bulge.values) for bulge in found.bulges) >= sum(
        np.count_nonzero(bulge.values) for bulge in outline.bulges
    )


@pytest.mark.parametrize("start", [0, 5, 17])
def test_it_does_not_matter_where_a_loop_begins(start):
    points = np.roll(flattened(SLOT).loops[0].values, start, axis=0)
    for loop in (points, points[::-1]):
        found = sw.contours.recover_arcs(sw.contours.Outline([loop]))
        assert len(found.loops[0]) == 4 and found.area == pytest.approx(3 + np.pi / 4, rel=1e-12)


def test_polygons_stay():
    for contour in (sw.contours.RegularPolygon(6), sw.contours.Star(7), sw.contours.Rectangle(2.0, 1.0)):
        outline = sw.contours.Outline([contour.section().points])
        assert not any(np.any(bulge.values) for bulge in sw.contours.recover_arcs(outline).bulges)


def test_chords_of_an_ellipse_come_no_farther_from_it():
    ellipse = sw.contours.Ellipse(2.0, 1.0, 64)
    found = sw.contours.recover_arcs(sw.contours.Outline([ellipse.section().points]))
    assert ellipse.section().area <= found.area <= ellipse.area


def test_an_open_outline_is_refused():
    with pytest.raises(sw.ShapeError, match="must be a closed outline"):
        sw.contours.recover_arcs(sw.contours.Outline([[(0, 0), (1, 0), (1, 1)]], closed=False))


def test_a_drawing_is_converted_by_its_arcs():
    """A rounded plate from a drawing: a block less four fillets, and not a fan of prisms."""
    pytest.importorskip("svgelements")
    plate = "M5 0 H35 A5 5 0 0 1 40 5 V25 A5 5 0 0 1 35 30 H5 A5 5 0 0 1 0 25 V5 A5 5 0 0 1 5 0 Z"
    outline = sw.contours.recover_arcs(sw.contours.from_svg(f'<svg><path d="{plate}"/></svg>'))
    assert outline.area == pytest.approx(1200 - 25 * (4 - np.pi), rel=1e-6)
    assert len(sw.sweep_to_csg(sw.TranslationalSweep(outline, 1.0)).steps) == 4

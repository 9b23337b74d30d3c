# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""From one grid to another: between which old vertices a new one lies, measured in space."""

import numpy as np
import pytest

from sweep_addon.core.contours import Circle, Outline, Rectangle
from sweep_addon.core.grids.between import sources
from sweep_addon.core.meshes.joining import joined
from sweep_addon.core.rings.ends import Open, Taper
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.shapes.rotational_sweep import RotationalSweep
from sweep_addon.core.shapes.translational_sweep import TranslationalSweep
from sweep_addon.core.stations.sampling import Count
from sweep_addon.core.trajectories import Arc, Helix, Line, Polyline, TorusKnot

UP = Line(end=(0, 0, 1))
HALF = Outline([[(0, -1), (0, 1)]], bulges=[(1, 0)], tolerance=0.01)
WASHER = Outline([[(-1, -1), (1, -1), (1, 1), (-1, 1)], [(-0.5, -0.5), (-0.5, 0.5), (0.5, 0.5), (0.5, -0.5)]])
SHAPES = {
    "tube": GeneralizedCylinder(Circle(0.1, points=8), Helix(), Count(40)),
    "open": GeneralizedCylinder(Circle(0.1, points=8), UP, Count(5), start=Open(), end=Open()),
    "spindle": GeneralizedCylinder(Rectangle(), UP, Count(5), start=Taper(0.3), end=Taper(0.3)),
    "cone": GeneralizedCylinder(Circle(0.1, points=3), UP, Count(2), end=Taper(1.0)),
    "sandglass": GeneralizedCylinder(Rectangle(), UP, Count(5), scale_x="1-2*t", scale_y="1-2*t"),
    "washer": GeneralizedCylinder(WASHER, UP, Count(4)),
    "knot": GeneralizedCylinder(Rectangle(0.1, 0.1), TorusKnot(), Count(90), twist="pi/2*t"),
    "mitred": GeneralizedCylinder(Rectangle(0.1, 0.1), Polyline([(0, 0, 0), (0, 0, 1), (0, 1, 1)])),
    "ball": RotationalSweep(HALF),
    "wedge": RotationalSweep(HALF, 2.0),
    "sheet": TranslationalSweep(Outline([[(0, 0), (1, 0), (1, 1)]], closed=False)),
}


def found(before, after):
    """Between which old vertices the new ones lie, from what a Blender mesh keeps of the old ones."""
    known = before.attributes
    lengths = (known[name].astype(np.float32) for name in ("arc_length", "v"))
    return sources(*lengths, before.vertices, before.topology.edges, after.chart)


def tube(rings, points):
    return GeneralizedCylinder(Circle(0.5, points=points), UP, Count(rings)).mesh()


@pytest.mark.parametrize("name", SHAPES)
def test_on_the_same_grid_each_vertex_is_its_own(name):
    made = SHAPES[name].mesh()
    assert found(made, made).nearest.tolist() == list(range(len(made.vertices)))
    assert np.array_equal(found(made, made).blended(made.vertices), made.vertices)


@pytest.mark.parametrize("rings", [2, 7, 41])
@pytest.mark.parametrize("points", [3, 16, 100])
def test_on_a_straight_tube_a_new_vertex_lies_on_the_faces_of_the_old(rings, points):
    """Its height is exact, as what is linear is; from the circle it is as far as a side of the polygon of 16."""
    before, after = tube(11, 16), tube(rings, points)
    there = found(before, after).blended(before.vertices)
    assert np.abs(there[:, 2] - after.vertices[:, 2]).max() < 1e-6
    turn = np.angle((there[:, 0] + 1j * there[:, 1]) * (after.vertices[:, 0] - 1j * after.vertices[:, 1]))
    assert np.abs(turn).max() < 1e-2
    assert np.linalg.norm(there[:, :2], axis=1).min() > 0.5 * np.cos(np.pi / 16) - 1e-6


@pytest.mark.parametrize("points", [3, 16, 100])
def test_the_nearest_is_no_farther_than_half_a_step(points):
    before, after = tube(11, 16), tube(41, points)
    there = before.vertices[found(before, after).nearest]
    turn = np.angle((there[:, 0] + 1j * there[:, 1]) * (after.vertices[:, 0] - 1j * after.vertices[:, 1]))
    assert np.abs(there[:, 2] - after.vertices[:, 2]).max() <= 0.05 + 1e-6
    assert np.abs(turn).max() <= np.pi / 16 + 1e-6


def test_one_step_after_another_nothing_drifts():
    """As under a slider: what is linear along the path stays so."""
    made = tube(11, 8)
    height = made.vertices[:, 2]
    for rings in (*range(12, 60), *range(58, 20, -1)):
        made, before = tube(rings, 8), made
        height = found(before, made).blended(height)
    assert np.abs(height - made.vertices[:, 2]).max() < 1e-4


@pytest.mark.parametrize("rings", [30, 61, 240])
def test_a_closed_sweep_goes_on_from_its_last_ring_to_its_first(rings):
    """Between two of 60 rings of a torus lies a chord, no farther from the arc than its sagitta."""
    before, after = (
        GeneralizedCylinder(Circle(0.1, points=8), Arc(2, 2 * np.pi), Count(count)).mesh() for count in (60, rings)
    )
    apart = found(before, after).blended(before.vertices) - after.vertices
    assert np.linalg.norm(apart, axis=1).max() <= 2.1 * (1 - np.cos(np.pi / 60)) + 1e-6


def test_between_a_ring_and_a_tip_is_the_side_of_the_cone():
    before = SHAPES["cone"].mesh()
    after = GeneralizedCylinder(Circle(0.1, points=3), UP, Count(12), end=Taper(1.0)).mesh()
    assert np.allclose(found(before, after).blended(before.vertices), after.vertices, atol=1e-6)


def test_poles_of_a_ball_stay_near_the_poles():
    """Columns begin a step beside a pole, which is another step where the ball is finer."""
    before = SHAPES["ball"].mesh()
    after = RotationalSweep(Outline(HALF.loops, bulges=HALF.bulges, tolerance=0.001)).mesh()
    pole = np.isclose(np.abs(after.vertices[:, 1]), 1)
    assert len(after.vertices) > len(before.vertices) and np.count_nonzero(pole) == 2
    apart = found(before, after).blended(before.vertices)[pole] - after.vertices[pole]
    step = np.linalg.norm(before.vertices[-1] - before.vertices[0])
    assert np.linalg.norm(apart, axis=1).max() < step < 0.3


def test_loops_keep_their_own_when_both_have_other_points():
    ring = [(1, 0), (-1, 0)], [(0.5, 0), (-0.5, 0)]
    before, after = (
        GeneralizedCylinder(Outline(ring, bulges=[(1, 1), (1, 1)], tolerance=tolerance), UP).mesh()
        for tolerance in (0.01, 0.001)
    )
    inside = [np.linalg.norm(made.vertices[:, :2], axis=1) < 0.6 for made in (before, after)]
    assert len(after.vertices) > len(before.vertices)
    assert (inside[0][found(before, after).around] == inside[1]).all()


def test_what_is_no_grid_is_not_carried():
    made = SHAPES["tube"].mesh()
    assert found(joined([made, made]), made) is None
    assert found(joined([SHAPES["open"].mesh(), made]), made) is None
    known = made.attributes
    some = np.random.default_rng(0).permutation(len(made.vertices))[:200]
    none = np.zeros((0, 2), int)
    assert sources(known["arc_length"][some], known["v"][some], made.vertices[some], none, made.chart) is None


FRAME = [(0, 0, 0), (2, 0, 0), (2, 1, 0), (0, 1, 0)]


@pytest.mark.parametrize("count", [60, 61, 200])
def test_a_closed_path_of_uneven_steps_closes_with_its_own_last_step(count):
    """A mitre moves what lies beside the path by half the contour's width along it, a new ring on a side by less."""
    before, after = (
        GeneralizedCylinder(Rectangle(0.02, 0.02), Polyline(FRAME, closed=True), **samples).mesh()
        for samples in ({}, {"samples": Count(count)})
    )
    apart = found(before, after).blended(before.vertices) - after.vertices
    assert len(after.vertices) > 2 * len(before.vertices)
    assert np.abs(apart).max() <= 0.01 + 1e-6


def sheathed(points):
    return GeneralizedCylinder(Outline([points]), UP, Count(3)).mesh()


def test_points_put_on_the_sides_of_a_contour_lie_on_them():
    corners = [(0, 0), (3, 0), (3, 1), (0, 1)]
    before, after = sheathed(corners), sheathed([(0, 0), (1.25, 0), (3, 0), (3, 1), (0.5, 1), (0, 1)])
    assert len(after.vertices) == 1.5 * len(before.vertices)
    assert np.allclose(found(before, after).blended(before.vertices), after.vertices, atol=1e-5)


def test_points_put_on_the_sides_of_two_loops_lie_on_them():
    hole = [(1, 0.25), (1, 0.5), (2.5, 0.5), (2.5, 0.25)]
    loops = [(0, 0), (3, 0), (3, 1), (0, 1)], hole
    finer = [(0, 0), (1.25, 0), (3, 0), (3, 1), (0.5, 1), (0, 1)], [*hole[:3], (2.5, 0.3), hole[3], (2, 0.25)]
    before, after = (GeneralizedCylinder(Outline(list(points)), UP, Count(3)).mesh() for points in (loops, finer))
    assert np.allclose(found(before, after).blended(before.vertices), after.vertices, atol=1e-5)


def test_a_line_that_is_bent_to_a_ring_is_bent_whole():
    before = tube(11, 8)
    after = GeneralizedCylinder(Circle(0.1, points=8), Arc(2, 2 * np.pi), Count(20)).mesh()
    share = after.attributes["arc_length"] / after.chart.total
    assert np.allclose(found(before, after).blended(before.vertices)[:, 2], share, atol=1e-6)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""From one grid to another: the old vertex that lies where a new one does, measured in space."""

import numpy as np
import pytest

from sweep_addon.core.contours import Circle, Outline, Rectangle
from sweep_addon.core.grids.carrying import sources
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
    """The old vertex of each new one, from what a Blender mesh keeps of the old ones."""
    known = before.attributes
    return sources(known["arc_length"].astype(np.float32), known["v"].astype(np.float32), after.chart)


def distances(before, after):
    """How far each new vertex is from the old one that it comes from."""
    return np.linalg.norm(after.vertices - before.vertices[found(before, after)], axis=1)


@pytest.mark.parametrize("name", SHAPES)
def test_on_the_same_grid_each_vertex_is_its_own(name):
    made = SHAPES[name].mesh()
    assert found(made, made).tolist() == list(range(len(made.vertices)))


@pytest.mark.parametrize("rings", [2, 7, 41])
@pytest.mark.parametrize("points", [3, 16, 100])
def test_no_vertex_comes_from_farther_than_half_a_step(rings, points):
    """On a straight tube the height and the angle are the lengths that count: 11 rings of 16 points."""
    before = GeneralizedCylinder(Circle(0.5, points=16), UP, Count(11)).mesh()
    after = GeneralizedCylinder(Circle(0.5, points=points), UP, Count(rings)).mesh()
    here, there = after.vertices, before.vertices[found(before, after)]
    turn = np.arctan2(here[:, 1], here[:, 0]) - np.arctan2(there[:, 1], there[:, 0])
    assert np.abs(here[:, 2] - there[:, 2]).max() <= 0.05 + 1e-6
    assert np.abs(np.angle(np.exp(1j * turn))).max() <= np.pi / 16 + 1e-6


@pytest.mark.parametrize("rings", [30, 61, 240])
def test_a_closed_sweep_goes_on_from_its_last_ring_to_its_first(rings):
    """A torus of radius 2 about 60 rings, whose steps are 2 pi 2 / 60 long."""
    before, after = (
        GeneralizedCylinder(Circle(0.1, points=8), Arc(2, 2 * np.pi), Count(count)).mesh() for count in (60, rings)
    )
    assert distances(before, after).max() <= 2.1 * np.pi / 60 + 1e-6


def test_a_tip_is_carried_to_all_that_is_nearest_to_it():
    """Of a cone of one ring and a tip, half of the height has what the ring had and half what the tip had."""
    before = SHAPES["cone"].mesh()
    after = GeneralizedCylinder(Circle(0.1, points=3), UP, Count(12), end=Taper(1.0)).mesh()
    height = before.vertices[found(before, after), 2]
    assert (height == (after.vertices[:, 2] > 0.5)).all()


def test_poles_of_a_ball_stay_the_poles():
    before = SHAPES["ball"].mesh()
    after = RotationalSweep(Outline(HALF.loops, bulges=HALF.bulges, tolerance=0.001)).mesh()
    pole = np.isclose(np.abs(after.vertices[:, 1]), 1)
    assert len(after.vertices) > len(before.vertices) and np.count_nonzero(pole) == 2
    assert np.allclose(before.vertices[found(before, after)][pole], after.vertices[pole])


def test_loops_keep_their_own_when_both_have_other_points():
    ring = [(1, 0), (-1, 0)], [(0.5, 0), (-0.5, 0)]
    before, after = (
        GeneralizedCylinder(Outline(ring, bulges=[(1, 1), (1, 1)], tolerance=tolerance), UP).mesh()
        for tolerance in (0.01, 0.001)
    )
    inside = [np.linalg.norm(made.vertices[:, :2], axis=1) < 0.6 for made in (before, after)]
    assert len(after.vertices) > len(before.vertices)
    assert (inside[0][found(before, after)] == inside[1]).all()


def test_what_is_no_grid_is_not_carried():
    tube = SHAPES["tube"].mesh()
    assert found(joined([tube, tube]), tube) is None
    assert found(joined([SHAPES["open"].mesh(), tube]), tube) is None
    known = tube.attributes
    some = np.random.default_rng(0).permutation(len(tube.vertices))[:200]
    assert sources(known["arc_length"][some], known["v"][some], tube.chart) is None

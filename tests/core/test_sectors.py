# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweeps whose strands run beside each other: of their contours only the sector that comes near is united."""

import numpy as np
import pytest

from sweep_addon.core.contours import Circle, Ellipse, RegularPolygon, Star
from sweep_addon.core.resolving.conflicts import chunks
from sweep_addon.core.resolving.plan import planned
from sweep_addon.core.resolving.resolve import of_plan, of_sectors
from sweep_addon.core.resolving.rings import Rings
from sweep_addon.core.resolving.sectors import one_run, sectors
from sweep_addon.core.resolving.wedges import Wedges
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.stations.sampling import Count
from sweep_addon.core.trajectories import Formula, TorusKnot

KNOT = TorusKnot(2, 3, 2.0, 0.8)
BESIDE = Formula("(3+cos(1.5*u))*cos(u)", "(3+cos(1.5*u))*sin(u)", "0.9*sin(1.5*u)", 0.0, 4 * np.pi)
CASES = {
    "knot": (Circle(0.9, points=32), KNOT, {}),
    "two tubes round a ring": (Ellipse(1.1, 0.95, points=24), BESIDE, {}),
    "seam": (RegularPolygon(6, 1.05), BESIDE, {}),
    "star": (Star(7, 0.95, 0.75), KNOT, {}),
    "swollen": (Circle(0.75, points=24), KNOT, {"scale_x": "1+0.2*sin(2*pi*t)", "scale_y": "1+0.2*sin(2*pi*t)"}),
}


@pytest.fixture(autouse=True)
def manifold3d():
    return pytest.importorskip("manifold3d")


def parts(name):
    contour, trajectory, laws = CASES[name]
    rings = Rings(GeneralizedCylinder(contour, trajectory, Count(300), **laws).surface())
    found = chunks(rings)
    plan = planned(found, rings.closed)
    return rings, plan, sectors(rings, plan, found)


def quiet(part):
    """Progress that nobody looks at."""


@pytest.mark.parametrize("name", CASES)
def test_sectors_give_the_solid_that_whole_tubes_give(name):
    """But for the diagonals of bent faces that are cut, which manifold3d chooses."""
    rings, plan, strips = parts(name)
    assert 0.1 < strips.mean() < 0.6
    ours, whole = of_sectors(Wedges(rings, plan, strips), quiet), of_plan(rings, plan, quiet)
    assert ours.volume() == pytest.approx(whole.volume(), rel=1e-6)
    assert ours.area() == pytest.approx(whole.area(), rel=1e-6)
    assert ours.euler_characteristic() == whole.euler_characteristic()
    assert not len(ours.boundary_edges()) and not len(ours.non_manifold_edges())
    assert len(np.unique(ours.vertices.astype(np.float32), axis=0)) == len(ours.vertices)


def test_sectors_through_whose_walls_something_comes_are_not_trusted():
    rings, plan, strips = parts("knot")
    less = strips & np.roll(strips, 4, axis=0)  # without the first four of each run
    assert less.any(axis=0).all()
    assert of_sectors(Wedges(rings, plan, less), quiet) is None


def test_faces_outside_of_sectors_are_faces_of_the_solid_that_whole_tubes_give():
    rings, plan, strips = parts("two tubes round a ring")
    kept = {tuple(place) for place in of_plan(rings, plan, quiet).vertices}
    left = np.unique(rings.mesh.corners.reshape(-1, 4)[rings.faces[~strips]])
    assert len(left) > 1000 and all(tuple(place) in kept for place in rings.mesh.vertices[left])


def test_a_run_goes_round_the_longest_gap():
    strips = np.array([[1, 0, 0, 0, 1, 0, 1, 0, 0], [0, 0, 1, 0, 0, 0, 0, 0, 0], [0] * 9, [1] * 9], bool).T
    expected = [[1, 0, 0, 0, 1, 1, 1, 1, 1], [0, 0, 1, 0, 0, 0, 0, 0, 0], [0] * 9, [1] * 9]
    assert one_run(strips).T.astype(int).tolist() == expected

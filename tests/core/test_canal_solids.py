# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids of canal surfaces hold what the balls visit, and each place once: judged by the balls themselves."""

from dataclasses import replace
from math import pi, tau

import numpy as np
import pytest

pytest.importorskip("manifold3d", reason="solids need it, and it is missing here")

from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.shapes.canal_surface import CanalSurface
from sweep_addon.core.stations.sampling import Count, Tolerance
from sweep_addon.core.trajectories import Arc, Formula, Helix, Line, Polyline

EIGHT = Formula("1.5*sin(u)", "1.5*sin(u)*cos(u)", "0", end=tau)
PARABOLA = Formula("u", "4*u^2", "0", start=-0.5, end=0.5, closed="no")
BENT = Polyline([(0, 0, 0), (1, 0, 0), (0.2, 0.3, 0)])
SOLIDS = {
    "eight parts and a ball": CanalSurface(Line(end=(0, 0, pi)), "0.3 + 0.25*sin(8*u*pi)", points=96),
    "crossing": CanalSurface(EIGHT, "0.25 + 0.1*sin(5*u)", points=64),
    "folding everywhere": CanalSurface(Arc(0.3, tau), "0.5 + 0.05*cos(u)", points=48, samples=Count(128)),
    "turns that touch": CanalSurface(Helix(1.0, 0.9, 1.0), "0.25 + 0.2*sin(9*u)", points=64),
    "a sharp bend": CanalSurface(PARABOLA, "0.3 + 0.1*u", points=48),
    "a corner": CanalSurface(BENT, "0.1 + 0.04*u", points=64),
    "a radius that begins to grow": CanalSurface(Line(), "0.3 + 0.5*abs(u - 0.5)", points=96),
    "a pearl": CanalSurface(Line(), "0.8*sqrt(u*(1 - u))", points=96, samples=Tolerance(1e-4)),
}

BRIEFLY = "crossing"  # is tried on every host


def visited(shape, count):
    """The volume of all points in any of 2,000 balls, and its standard error, by counting."""
    u = np.linspace(*shape.trajectory.domain, 2000)
    middles, radii = shape.trajectory.evaluate(u), shape.radius.evaluate(u, u, u)  # laws of u alone
    low, high = (middles - radii[:, None]).min(axis=0), (middles + radii[:, None]).max(axis=0)
    places = np.random.default_rng(5).uniform(low, high, (count, len(low)))
    share, box = 1 - len(outside(places, middles, radii)) / count, np.prod(high - low)
    return box * share, box * np.sqrt(share * (1 - share) / count)


def outside(places, middles, radii):
    """The places in no ball, of balls a few at a time, that are spread over all: (n, d)."""
    beyond = np.stack((*-2 * middles.T, (middles**2).sum(axis=1) - radii**2, np.ones_like(radii)))  # squares less radii
    left = np.column_stack((places, np.ones(len(places)), (places**2).sum(axis=1)))
    for start in range(80):
        left = left[(left @ beyond[:, start::80] >= 0).all(axis=1)]
    return left[:, : places.shape[1]]


@pytest.mark.parametrize(
    "name", [BRIEFLY, *(pytest.param(n, marks=pytest.mark.thorough) for n in SOLIDS if n != BRIEFLY)]
)
def test_solid_is_what_2000_balls_visit(name):
    """An inscribed mesh is smaller by what its circles have less than true ones, one part in 400 at 48 points."""
    shape = SOLIDS[name]
    mesh = shape.solid()
    volume, error = visited(shape, 40_000)
    assert len(mesh.boundary_edges()) == len(mesh.non_manifold_edges()) == 0
    assert -3 * error - 0.006 * volume < mesh.volume() - volume < 3 * error


@pytest.mark.thorough
def test_vertices_of_a_union_of_parts_are_on_the_balls():
    """None of them is within a ball by more than a chord of the mesh is."""
    shape = replace(SOLIDS["eight parts and a ball"], samples=Tolerance(1e-4), points=48)
    mesh = shape.solid()
    u = np.linspace(0, 1, 4000)
    x, y, z = mesh.vertices.T[..., None]
    apart = np.hypot(np.hypot(x, y), z - pi * u)
    depth = (0.3 + 0.25 * np.sin(8 * pi * u) - apart).max(axis=1)
    assert -5e-6 < depth.min() and depth.max() < 1.5e-4  # between 4,000 balls, and a chord of the tolerance


def test_a_clean_surface_is_its_own_solid():
    shape = CanalSurface(Line(), "0.2 + 0.25*t")
    surface, solid = shape.surface(), shape.solid()
    assert np.array_equal(surface.vertices, solid.vertices) and np.array_equal(surface.corners, solid.corners)


def test_mesh_is_the_solid_where_that_is_asked_for():
    shape = replace(SOLIDS["a corner"], make_solid=True)
    assert shape.mesh().volume() == pytest.approx(SOLIDS["a corner"].solid().volume(), rel=1e-12)
    assert not shape.self_intersections()
    assert all(not said.startswith("Self-intersection") for said in shape.mesh().told)


def test_a_corner_leaves_one_surface():
    mesh = CanalSurface(Polyline([(0, 0, 0), (1, 0, 0), (1, 1, 0)]), 0.1).solid()
    assert mesh.euler_characteristic() == 2


def test_open_ends_make_no_solid():
    with pytest.raises(ShapeError, match="^A solid needs a closed contour and closed ends, got an open surface"):
        CanalSurface(start="open").solid()


@pytest.mark.parametrize(
    ("shape", "area"),
    [
        (CanalSurface(Arc(5.0, tau), 1.0, "disc", samples=Count(4096)), 20 * pi),
        (CanalSurface(Arc(0.3, tau), 0.5, "disc", samples=Tolerance(1e-6)), pi * 0.8**2),
        (CanalSurface(Line(end=(2, 0, 0)), 0.3, "disc", samples=Tolerance(1e-6)), 4 * 0.3 + pi * 0.3**2),
    ],
    ids=["ring from 4 to 6", "disc over its middle", "slot"],
)
def test_region_of_discs_has_the_area_of_its_form(shape, area):
    mesh = shape.solid()
    assert mesh.area() == pytest.approx(area, rel=1e-5)
    assert (mesh.normals[:, 2] > 0).all()


def test_boundaries_of_the_lectures_ring_are_two_circles():
    mesh = CanalSurface(Arc(5.0, tau), 1.0, "disc", samples=Count(512)).solid()
    radii = np.hypot(*mesh.vertices[np.unique(mesh.boundary_edges()), :2].T)
    assert np.abs(np.abs(radii - 5) - 1).max() < 1e-7
    assert np.count_nonzero(radii > 5) == np.count_nonzero(radii < 5) == 512


@pytest.mark.thorough
def test_region_of_a_crossing_strip_is_what_discs_visit():
    shape = CanalSurface(EIGHT, "0.25 + 0.1*sin(5*u)", "disc")
    u = np.linspace(0, tau, 4000)
    middles, radii = shape.trajectory.evaluate(u)[:, :2], 0.25 + 0.1 * np.sin(5 * u)
    places = np.random.default_rng(7).uniform((-2, -1.3), (2, 1.3), (40_000, 2))
    share, mesh = 1 - len(outside(places, middles, radii)) / len(places), shape.solid()
    error = 4 * 2.6 * np.sqrt(share * (1 - share) / len(places))
    assert abs(mesh.area() - 4 * 2.6 * share) < 3 * error
    assert mesh.area() < shape.surface().area()

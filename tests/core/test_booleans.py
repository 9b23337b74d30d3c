# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Booleans of solids and convex hulls."""

import sys

import numpy as np
import pytest

from sweep_addon.core.contours import Circle, Rectangle, Star
from sweep_addon.core.csg import SweptSolid
from sweep_addon.core.csg.meshes import transformed
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.meshes.booleans import body_of, combined, hull_body, mesh_of, union, united
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.shapes.translational_sweep import TranslationalSweep
from sweep_addon.core.solids import Block
from sweep_addon.core.trajectories import Line

needs_manifold3d = pytest.mark.usefixtures("manifold3d")


@pytest.fixture
def manifold3d():
    return pytest.importorskip("manifold3d")


def block(width, depth, height=1.0):
    return TranslationalSweep(Rectangle(width, depth), height=height).mesh()


def closed(mesh):
    return not len(mesh.boundary_edges()) and not len(mesh.non_manifold_edges())


@needs_manifold3d
@pytest.mark.parametrize("turns", [-3, 1, 3])
def test_a_twisted_bar_is_as_thick_in_a_tree_as_by_itself(turns):
    """A turn about its axis keeps its area: chords across h radians lack h^2 / 6 of it, and h is at most a quarter."""
    bar = GeneralizedCylinder(Rectangle(0.2, 0.2), Line(), twist=f"{turns}*2*pi*t")
    for operand in ((bar & Block(3.0, 3.0, 3.0)).mesh(), SweptSolid(bar).sweep().generator.mesh()):
        assert 0.2 * 0.2 * (1 - 0.25**2 / 6) <= operand.volume() <= 0.2 * 0.2
        assert closed(operand)


@needs_manifold3d
def test_volumes_of_a_cross_obey_inclusion_and_exclusion():
    bars = block(3.1, 0.7), block(0.9, 2.3)
    both, common, first = (
        mesh_of(combined(operation, *map(body_of, bars))) for operation in ("union", "intersection", "difference")
    )
    assert both.volume() == pytest.approx(3.1 * 0.7 + 0.9 * 2.3 - 0.9 * 0.7, rel=1e-14)
    assert common.volume() == pytest.approx(0.9 * 0.7, rel=1e-14)
    assert first.volume() == pytest.approx((3.1 - 0.9) * 0.7, rel=1e-14)
    assert closed(both) and closed(common) and closed(first)


@needs_manifold3d
def test_films_between_blocks_that_meet_are_left_out():
    """Corners that meet are the same but for rounding: of some rows of four a film is left, which holds nothing."""
    random, cube, found = np.random.default_rng(1), Block(1.0, 1.0, 1.0).mesh(), 0
    for _ in range(40):
        axes = np.linalg.qr(random.normal(size=(3, 3)))[0]
        there = [transformed(cube, np.eye(3), (x, 0.0, 0.0)) for x in range(4)]
        row = united([body_of(transformed(block, axes, np.zeros(3))) for block in there])
        volumes = [abs(part.volume()) for part in row.decompose()]
        found += min(volumes) < 1e-12
        whole = mesh_of(row)
        assert closed(whole) and whole.volume() == pytest.approx(4.0, rel=1e-14)
        assert whole.euler_characteristic() == 2 * sum(volume > 0.5 for volume in volumes)
    assert found


@needs_manifold3d
@pytest.mark.parametrize("width", [0.5, 1e-8])
def test_cavities_are_no_films(width):
    block = Block(1.0, 1.0, 1.0)
    hollow = (block - Block(0.5, 0.5, width)).mesh()
    assert hollow.euler_characteristic() == 4 and len(hollow.vertices) == 16


@needs_manifold3d
def test_vertices_that_nothing_cuts_come_back_to_the_bit():
    tube = TranslationalSweep(Circle(1 / 3, points=32), height=np.pi).mesh()
    far = block(0.1, 0.1)
    far.vertices[:] += (10, 0, 0)
    back = union([tube, far]).vertices
    assert {tuple(v) for v in tube.vertices} | {tuple(v) for v in far.vertices} == {tuple(v) for v in back}


@needs_manifold3d
def test_hull_of_points_on_a_sphere_is_bounded_by_all_of_them():
    points = np.random.default_rng(1).normal(size=(500, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    mesh = mesh_of(hull_body(points))
    assert len(mesh.vertices) == 500 and mesh.euler_characteristic() == 2 and closed(mesh)


@needs_manifold3d
def test_union_of_two_hulls_that_overlap_and_one_that_holds_nothing():
    cube = np.stack(np.meshgrid(*[(0.0, 1.0)] * 3), axis=-1).reshape(-1, 3)
    bodies = map(hull_body, (cube, cube + 0.5, 2 * cube[cube[:, 0] == 0]))
    assert mesh_of(united(bodies)).volume() == pytest.approx(2 - 1 / 8, rel=1e-14)


@needs_manifold3d
def test_open_meshes_are_refused():
    with pytest.raises(ShapeError, match="takes closed, manifold, oriented meshes, got"):
        body_of(TranslationalSweep(Rectangle(), end="open").mesh())


def test_without_the_library_the_refusal_says_how_to_get_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "manifold3d", None)
    with pytest.raises(ShapeError, match="pip install manifold3d"):
        hull_body(np.eye(4, 3))


@needs_manifold3d
def test_a_concave_cap_is_cut_by_its_ears_and_not_in_a_fan():
    """A fan from a star's first corner would leave triangles outside it, which a boolean takes for matter."""
    star = TranslationalSweep(Star(points=5, outer=1.0, inner=0.2), height=1.0).mesh()
    assert union([star]).volume() == pytest.approx(star.volume(), rel=1e-12)
    assert len(union([star]).boundary_edges()) == 0

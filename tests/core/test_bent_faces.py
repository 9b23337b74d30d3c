# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bent faces as triangles: a twisted bar is neither thicker nor thinner for being cut."""

import numpy as np
import pytest

import sweep_addon as sw
from sweep_addon.core.contours import Rectangle, RegularPolygon
from sweep_addon.core.meshes.facets import facets
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.solids import Triangles
from sweep_addon.core.trajectories import Line

SIDE, LENGTH = 0.1, 1.0
TWISTS = (np.pi / 2, -np.pi / 2, 2 * np.pi, -2 * np.pi, -6 * np.pi, 12 * np.pi)


def bar(twist, contour=None, **given):
    contour = contour or Rectangle(SIDE, SIDE)
    return GeneralizedCylinder(contour, Line(end=(0, 0, LENGTH)), twist=f"{twist} * t", **given)


def held(vertices, triangles):
    """The volume inside triangles, by the divergence theorem."""
    a, b, c = vertices[triangles].swapaxes(0, 1)
    return np.einsum("ij,ij->", np.cross(a, b), c) / 6


def between(twist, bands):
    """What straight lines between the rings of a twisted bar bound.

    At a part s of the way from one ring to the next, turned by an angle, the section is (1 - s) + s exp(i angle) times
    the contour: similar, of 1 - 2 s (1 - s) (1 - cos angle) times its area, on average 1 - (1 - cos angle) / 3.
    """
    return SIDE**2 * LENGTH * (1 - (1 - np.cos(twist / bands)) / 3)


@pytest.mark.parametrize("twist", TWISTS)
def test_a_twisted_bar_as_triangles_holds_what_lines_between_its_rings_bound(twist):
    mesh = bar(twist).mesh()
    expected = between(twist, mesh.rings - 1)
    assert held(mesh.vertices, mesh.triangles) == pytest.approx(expected, rel=1e-12)
    solid = mesh.triangulated()
    assert held(solid.vertices, solid.triangles) == pytest.approx(expected, rel=1e-12)
    assert solid.volume() == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("bands", [16, 32, 64, 128])
@pytest.mark.parametrize("turns", [1, -1])
def test_a_twisted_bar_as_triangles_holds_its_section_times_its_length_by_the_square_of_the_step(bands, turns):
    mesh = bar(turns * 2 * np.pi, samples=sw.sampling.Count(bands)).mesh()
    step = 2 * np.pi / (mesh.rings - 1)
    assert held(mesh.vertices, mesh.triangles) == pytest.approx(SIDE**2 * LENGTH, rel=step**2 / 5)


@pytest.mark.parametrize("twist", [2.0, -2.0, 7.0])
@pytest.mark.parametrize("contour", [Rectangle(0.3, 0.1), Rectangle(0.3, 0.1, rounding=0.03), RegularPolygon(sides=3)])
def test_bars_whose_columns_differ_or_are_odd_hold_about_as_much(contour, twist):
    mesh = bar(twist, contour).mesh()
    along_shorter = held(mesh.vertices, facets(mesh)[0]) / mesh.volume() - 1
    assert abs(held(mesh.vertices, mesh.triangles) / mesh.volume() - 1) < along_shorter / 8


@pytest.mark.parametrize("twist", TWISTS)
def test_triangles_of_a_twisted_bar_are_closed_and_look_outwards(twist):
    mesh = bar(twist).mesh()
    of_its_vertices, nearer = Triangles(mesh.vertices, mesh.triangles).mesh(), mesh.triangulated()
    for made in (of_its_vertices, nearer):
        assert len(made.boundary_edges()) == len(made.non_manifold_edges()) == 0
        assert made.euler_characteristic() == 2 and (np.diff(made.offsets) == 3).all()
    assert len(of_its_vertices.vertices) == len(mesh.vertices)
    assert np.bincount(nearer.topology.material).tolist() == [4 * 4 * (mesh.rings - 1), 2 * 2]


def test_a_wall_without_ends_is_cut_as_its_solid_is_and_stays_open():
    mesh = bar(np.pi, start="open", end="open").mesh()
    assert len(mesh.triangulated().boundary_edges()) == len(mesh.boundary_edges()) == 8


def test_flat_faces_gain_no_vertex():
    mesh = sw.solids.Block().mesh()
    assert mesh.triangulated().vertices is mesh.vertices
    assert (mesh.triangles == facets(mesh)[0]).all()


@pytest.mark.parametrize("twist", [np.pi, -np.pi])
def test_solids_of_twisted_bars_are_as_thick_as_these(twist):
    """Triangles as those of a part to be machined."""
    mesh = bar(twist).mesh()
    expected = between(twist, mesh.rings - 1)
    assert Triangles.of(mesh).mesh().volume() == pytest.approx(expected, rel=1e-12)


@pytest.mark.thorough
def test_faces_that_may_be_cut_in_two_but_not_in_four_are_cut_in_two():
    """A solid of triangles has at most a million: of as many bent faces as these it was refused."""
    mesh = bar(900.0, RegularPolygon(sides=100), samples=sw.sampling.Count(2601)).mesh()
    of_sides, of_caps = 2 * 100 * 2600, 2 * 98
    assert len(Triangles.of(mesh).faces) == of_sides + of_caps

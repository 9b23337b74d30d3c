# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tubes of figures are closed, look outwards, and have the volume of their contour times the length of their axes."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweep_addon.core.grammars import LSystem
from sweep_addon.core.grammars.faces import FACE
from sweep_addon.core.parameters import ShapeError

PLANT = "#angle 22.5\naxiom: X\nX -> F-[[X]+X]+F[+FX]-X\nF -> FF\n"
HONDA = """axiom: A(1,0.1)
A(l,w) -> !(w)F(l)[&(45)B(l*0.6,w*0.707)]/(137.5)A(l*0.9,w*0.707)
B(l,w) -> !(w)F(l)[-(45)$C(l*0.6,w*0.707)]C(l*0.9,w*0.707)
C(l,w) -> !(w)F(l)[+(45)$B(l*0.6,w*0.707)]B(l*0.9,w*0.707)"""


def polygon(sides, diameter):
    """The area of a regular polygon with corners on a circle."""
    return sides / 2 * np.sin(2 * np.pi / sides) * diameter**2 / 4


@pytest.mark.parametrize(("told", "generations"), [(PLANT, 4), (HONDA, 7)])
@pytest.mark.parametrize("sides", [3, 8])
def test_each_axis_is_a_closed_tube(told, generations, sides):
    figure = LSystem.parse(told).derive(generations).figure()
    mesh = figure.mesh(sides)
    assert not len(mesh.boundary_edges()) and not len(mesh.non_manifold_edges())
    assert mesh.euler_characteristic() == 2 * (figure.axis.max() + 1)
    pairs, _, _ = mesh.topology.uses()
    assert np.array_equal(pairs, np.unique(np.sort(mesh.edges, axis=1), axis=0))
    ends = np.sort(mesh.edges[mesh.topology.corner_edges], axis=1)
    following = mesh.corners[mesh.topology.following]
    assert np.array_equal(ends, np.sort(np.column_stack((mesh.corners, following)), axis=1))


turn = st.tuples(st.sampled_from("+-&^/\\"), st.floats(-60, 60).map(lambda angle: round(angle, 2)))


@given(st.lists(st.lists(turn, max_size=3), min_size=1, max_size=12), st.integers(3, 9))
def test_a_mitred_tube_has_the_volume_of_its_contour_times_its_length(turns_, sides):
    """Each segment is a prism cut by planes through the centroids at its ends, wherever these lean (Pappus)."""
    told = "".join("".join(f"{name}({angle!r})" for name, angle in some) + "F(1)" for some in turns_)
    figure = LSystem.parse(f"#width 0.02\naxiom: {told}").derive(0).figure()
    bends = np.einsum("ij,ij->i", figure.axes[1:, 0], figure.axes[:-1, 0])
    if (bends < -0.4).any():
        return
    mesh = figure.mesh(sides)
    assert mesh.volume() == pytest.approx(polygon(sides, 0.02) * len(turns_), rel=1e-9)


def test_a_tube_that_only_rolls_does_not_twist():
    figure = LSystem.parse("axiom: F/(40)F/(40)F\\(10)F").derive(0).figure()
    vertices = figure.mesh(5).vertices.reshape(-1, 5, 3)
    assert np.abs(vertices[:, :, 1:] - vertices[:1, :, 1:]).max() < 1e-15


def test_a_tube_tapers_to_the_width_of_the_next_segment():
    figure = LSystem.parse("axiom: !(2)F!(1)F").derive(0).figure()
    radii = np.linalg.norm(figure.mesh(4).vertices.reshape(-1, 4, 3)[:, :, 1:], axis=2)
    assert radii == pytest.approx(np.repeat([[1.0], [0.5], [0.5]], 4, axis=1))
    assert set(figure.mesh(4).attributes) == {"radius", "colour", "birth", "axis", "order"}


def test_wires_share_vertices_where_segments_meet():
    mesh = LSystem.parse("axiom: F[+F]F f F").derive(0).figure().mesh(sides=0)
    assert len(mesh.vertices) == 6 and len(mesh.edges) == 4 and len(mesh.offsets) == 1
    lengths = np.linalg.norm(np.diff(mesh.vertices[mesh.edges], axis=1)[:, 0], axis=1)
    assert lengths == pytest.approx(1)
    assert len(np.unique(mesh.vertices.round(9), axis=0)) == 6


@pytest.mark.parametrize("sides", [-1, 1, 2, 257])
def test_other_numbers_of_sides_are_refused(sides):
    with pytest.raises(ShapeError, match=f"sides: must be 0 or from 3 to 256, got {sides}"):
        LSystem.parse("axiom: F").derive(0).figure().mesh(sides)


@pytest.mark.parametrize("sides", [0, 6])
def test_a_word_that_draws_nothing_has_an_empty_mesh(sides):
    mesh = LSystem.parse("axiom: A[B]").derive(0).figure().mesh(sides)
    assert mesh.vertices.shape == (0, 3) and len(mesh.offsets) == 1


def test_each_polygon_is_a_face_beside_the_tubes():
    """Two unit squares, one within a branch of the other's: 2 square metres, 8 vertices of their own, one edge each."""
    square = "{f+f+f+f}"
    system = LSystem.parse(f"#angle 90\naxiom: '(3)F[''{square}F']{square}")
    figure = system.derive(0).figure()
    mesh, alone = figure.mesh(6), LSystem.parse("#angle 90\naxiom: '(3)F[''ffffFf']ffff").derive(0).figure().mesh(6)
    leaves = mesh.topology.material == FACE
    assert leaves.sum() == 2 and np.diff(mesh.offsets)[leaves].tolist() == [4, 4]
    assert mesh.area() == pytest.approx(alone.area() + 2, rel=1e-12)
    assert len(mesh.vertices) == len(alone.vertices) + 8 and len(mesh.boundary_edges()) == 8
    assert not len(mesh.non_manifold_edges())
    assert mesh.attributes["colour"][-8:].tolist() == [5] * 4 + [3] * 4
    assert mesh.attributes["radius"][-8:].tolist() == [0] * 8 and mesh.attributes["axis"][-8:].tolist() == [0] * 8
    ends = np.sort(mesh.edges[mesh.topology.corner_edges], axis=1)
    following = mesh.corners[mesh.topology.following]
    assert np.array_equal(ends, np.sort(np.column_stack((mesh.corners, following)), axis=1))


def test_polygons_are_faces_beside_edges_too():
    mesh = LSystem.parse("#angle 90\naxiom: F{f+f+f+f}").derive(0).figure().mesh(sides=0)
    assert mesh.area() == pytest.approx(1, rel=1e-12) and len(mesh.edges) == 1 + 4

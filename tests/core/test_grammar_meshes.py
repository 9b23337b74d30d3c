# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tubes of figures are closed, look outwards, and have the volume of their contour times the length of their axes."""

from copy import deepcopy

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweep_addon.core.declared.options import Texture
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.grammars import Budget, LSystem
from sweep_addon.core.shapes.plant import Plant

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


@pytest.mark.parametrize("corners", [4, 7])
def test_a_closed_tube_has_no_notch_where_it_begins(corners):
    """Each corner of a regular polygon is as far from its centre as the others: that of the first and last ring too."""
    told = f"#angle 360/{corners}\n#width 0.1\naxiom: {'F+' * corners}"
    figure = LSystem.parse(told).derive(0).figure()
    mesh = figure.mesh(4)
    outer = np.sort(np.linalg.norm(mesh.vertices - figure.start.mean(axis=0), axis=1))[::-1][: corners + 1]
    assert outer == pytest.approx(np.full(corners + 1, outer[0]), rel=1e-9)
    assert mesh.volume() == pytest.approx(polygon(4, 0.1) * corners, rel=1e-9)


def test_a_tube_that_only_rolls_does_not_twist():
    figure = LSystem.parse("axiom: F/(40)F/(40)F\\(10)F").derive(0).figure()
    vertices = figure.mesh(5).vertices.reshape(5, -1, 3)
    assert np.abs(vertices[:, :, 1:] - vertices[:, :1, 1:]).max() < 1e-15


def test_a_tube_tapers_to_the_width_of_the_next_segment():
    figure = LSystem.parse("axiom: !(2)F!(1)F").derive(0).figure()
    mesh = figure.mesh(4)
    radii = np.linalg.norm(mesh.vertices.reshape(4, -1, 3)[:, :, 1:], axis=2)
    assert radii == pytest.approx(np.repeat([[1.0, 0.5, 0.5]], 4, axis=0))
    assert set(mesh.attributes) == {"u", "arc_length", "v", "radius", "colour", "birth", "axis", "order"}


def test_wires_share_vertices_where_segments_meet():
    mesh = LSystem.parse("axiom: F[+F]F f F").derive(0).figure().mesh(sides=0)
    assert len(mesh.vertices) == 6 and len(mesh.edges) == 4 and len(mesh.offsets) == 1
    lengths = np.linalg.norm(np.diff(mesh.vertices[mesh.edges], axis=1)[:, 0], axis=1)
    assert lengths == pytest.approx(1)
    assert len(np.unique(mesh.vertices.round(9), axis=0)) == 6


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
    faces = len(alone.offsets) - 1
    assert mesh.topology.material[faces:].tolist() == [5, 3] and np.diff(mesh.offsets)[faces:].tolist() == [4, 4]
    assert mesh.area() == pytest.approx(alone.area() + 2, rel=1e-12)
    assert len(mesh.vertices) == len(alone.vertices) + 8 and len(mesh.boundary_edges()) == 8
    assert not len(mesh.non_manifold_edges())
    assert mesh.attributes["colour"][-8:].tolist() == [5] * 4 + [3] * 4
    assert mesh.attributes["radius"][-8:].tolist() == [0] * 8 and mesh.attributes["axis"][-8:].tolist() == [0] * 8
    ends = np.sort(mesh.edges[mesh.topology.corner_edges], axis=1)
    following = mesh.corners[mesh.topology.following]
    assert np.array_equal(ends, np.sort(np.column_stack((mesh.corners, following)), axis=1))


def test_axes_as_poly_lines_have_no_vertex_in_common():
    """A stem of three segments, a branch of two at its first fork and one of one at its second."""
    mesh = Plant("axiom: F[+FF]F[-F]F", output="curves").mesh()
    runs = np.split(mesh.edges, np.flatnonzero(np.diff(mesh.edges[:, 0]) > 1) + 1)
    assert sorted(len(run) for run in runs) == [1, 2, 3] and len(mesh.vertices) == 2 + 3 + 4
    assert all((run[1:, 0] == run[:-1, 1]).all() for run in runs) and np.bincount(mesh.edges.ravel()).max() == 2
    assert sorted(np.bincount(mesh.attributes["axis"].astype(int))) == [2, 3, 4]
    assert mesh.attributes["radius"] == pytest.approx(0.05)


def test_polygons_are_faces_beside_edges_too_and_without_colours_have_a_slot_of_their_own():
    mesh = LSystem.parse("#angle 90\naxiom: F{f+f+f+f}").derive(0).figure().mesh(sides=0)
    assert mesh.area() == pytest.approx(1, rel=1e-12) and len(mesh.edges) == 1 + 4
    assert mesh.topology.material.tolist() == [2]


LEAF = "#angle 90\n#names leaf\naxiom: F '(3) [{ +f-f-f }] ' ~leaf(0.5) f ~leaf ~A"


@pytest.mark.parametrize("sides", [0, 5])
def test_a_polygon_is_a_face_and_each_organ_a_point(sides):
    mesh = LSystem.parse(LEAF).derive(0).figure().mesh(sides)
    places = mesh.vertices[mesh.corners[mesh.offsets[-2] :]]  # polygons stand behind tubes
    assert places.round(9).tolist() == [[1, 0, 0], [1, 1, 0], [2, 1, 0], [2, 0, 0]]
    assert len(mesh.offsets) == (2 if sides == 0 else 5 + 2 + 2) and mesh.topology.material[-1] == 3
    organ, size, colour = (mesh.attributes[name] for name in ("organ", "size", "colour"))
    assert organ[organ > 0].tolist() == [1, 1, 2] and size[organ > 0].tolist() == [0.5, 1, 1]
    assert colour[organ > 0].tolist() == [4, 4, 4]
    assert mesh.vertices[organ > 0].tolist() == [[1, 0, 0], [2, 0, 0], [2, 0, 0]]
    assert mesh.told == ("Organs are points. Attribute organ: 1 = leaf (2 of it), 2 = A (1 of it).",)


def test_the_colour_of_a_segment_is_the_number_of_its_material_slot():
    mesh = LSystem.parse("axiom: F'F''F'(99)F").derive(0).figure().mesh(3)
    slots, ahead = mesh.topology.material, np.add.reduceat(mesh.vertices[mesh.corners, 0], mesh.offsets[:-1]) / 4
    assert {slot: {*ahead[:12][slots[:12] == slot].round(6)} for slot in {*slots.tolist()}} == {
        0: {0.5}, 1: {1.5}, 3: {2.5}, 63: {3.5}
    }  # fmt: skip


@pytest.mark.parametrize("texture", ["lengths", "unit"])
def test_texture_coordinates_are_lengths_along_and_round_or_parts_of_them(texture):
    """Of a straight tube, 3 long, of six sides and a radius of 0.5: its hexagon is 3 round, and has sides of 0.5."""
    shape = Plant("#width 1\naxiom: F(1)F(2)", output={"kind": "tubes", "sides": 6}, texture=texture)
    mesh = shape.mesh()
    uv = mesh.uv[: 4 * 12].reshape(12, 4, 2)
    size = np.array([1, 1] if texture == "lengths" else [3, 3])
    places = mesh.vertices[mesh.corners[:48]].reshape(12, 4, 3)
    assert uv[..., 0] * size[0] == pytest.approx(places[..., 0])
    width = np.abs(uv[:, 0, 1] - uv[:, 1, 1]) * size[1]
    assert width == pytest.approx(0.5) and uv[..., 1].min() == 0 and uv[..., 1].max() * size[1] == pytest.approx(3)
    way, up = uv[:, 1] - uv[:, 0], uv[:, 3] - uv[:, 0]
    assert (way[:, 0] * up[:, 1] - way[:, 1] * up[:, 0] > 0).all()  # seen from outside no picture is mirrored
    caps = mesh.uv[48:].reshape(2, 6, 2)
    turns = np.roll(caps, -1, axis=1) - caps
    assert (turns[:, 0, 0] * turns[:, 1, 1] - turns[:, 0, 1] * turns[:, 1, 0] > 0).all()
    assert np.linalg.norm(turns, axis=2) == pytest.approx(0.5)


def test_attributes_are_of_the_segment_that_begins_there_and_lengths_along_its_axis():
    mesh = Plant("axiom: !(2)F(1)[+(90)F(3)F(1)]'!(1)F(2)", output="edges").mesh()
    place = {tuple(vertex): number for number, vertex in enumerate(mesh.vertices.round(9).tolist())}
    at = {
        name: {key: float(values[number]) for key, number in place.items()} for name, values in mesh.attributes.items()
    }
    base, fork, tip, end = (0, 0, 0), (1, 0, 0), (1, 4, 0), (3, 0, 0)
    assert [at["arc_length"][key] for key in (base, fork, tip, end)] == [0, 1, 4, 3]
    assert at["u"][fork] == pytest.approx(1 / 3) and at["u"][tip] == 1
    assert [at["order"][key] for key in (base, tip, end)] == [0, 1, 0] and at["colour"][end] == 1
    assert [at["radius"][key] for key in (base, end)] == [1, 0.5]


@pytest.mark.parametrize(
    "told", ["~b+(30)F~b^(40)/(20)[&(15)~b]f~b", "F(2)+(90)~b", "#tropism 0 0 -1 0.4\naxiom: F&F~b+F~b"]
)
def test_an_organ_is_turned_as_the_turtle_is_there(told):
    """As the segment would be that a turtle drew in its place: its heading is z, its left x and its up y."""
    text = told if "axiom" in told else f"axiom: {told}"
    mesh = LSystem.parse(text).derive(0).figure(upright=False).mesh(0)
    rotation = mesh.attributes["rotation"][mesh.attributes["organ"] > 0]
    spots = [place for place in range(len(text)) if text.startswith("~b", place)]
    for spot, (a, b, c, d) in zip(spots, rotation, strict=True):
        drawn = (
            LSystem.parse(f"{text[:spot]}F(0.001){text[spot + 2 :]}".replace("~b", "")).derive(0).figure(upright=False)
        )
        axes = drawn.axes[np.linalg.norm(drawn.end - drawn.start, axis=1).argmin()]
        columns = np.array(
            [
                [1 - 2 * (c * c + d * d), 2 * (b * c - a * d), 2 * (b * d + a * c)],
                [2 * (b * c + a * d), 1 - 2 * (b * b + d * d), 2 * (c * d - a * b)],
                [2 * (b * d - a * c), 2 * (c * d + a * b), 1 - 2 * (b * b + c * c)],
            ]
        ).T
        assert columns == pytest.approx(axes[[1, 2, 0]], abs=1e-12)
    assert (mesh.attributes["rotation"][mesh.attributes["organ"] == 0] == (1, 0, 0, 0)).all()


@pytest.mark.parametrize("told", ["F(-1)", "F(1)+(30)F(-2)F(1)", "&(20)F(2)/(40)+(80)F(-3)", "F(0)F(1)&F(0)F(1)"])
def test_tubes_look_outwards_where_the_turtle_goes_backwards_or_nowhere(told):
    mesh = LSystem.parse(f"axiom: {told}").derive(0).figure().mesh(6)
    assert np.isfinite(mesh.vertices).all() and mesh.volume() > 0


@pytest.mark.parametrize("sides", [3.5, "3", None, -1, 1, 2, 257])
@pytest.mark.parametrize("budget", [None, Budget()])
def test_other_numbers_of_sides_are_refused(sides, budget):
    figure = LSystem.parse("axiom: F").derive(0).figure()
    with pytest.raises(ShapeError, match=f"^sides: must be 0 or a whole number from 3 to 256, got {sides!r}"):
        figure.mesh(sides, budget=budget)
    assert len(figure.mesh(np.int64(3), budget=budget).vertices) == 6


def test_meshes_with_organs_are_copied_with_all_they_know():
    mesh = LSystem.parse("axiom: F~K F").derive(0).figure().mesh(texture=Texture.LENGTHS)
    copied = deepcopy(mesh)
    assert copied.attributes.keys() == mesh.attributes.keys() >= {"organ", "size", "rotation", "radius"}
    assert all(np.array_equal(copied.attributes[name], values) for name, values in mesh.attributes.items())
    assert np.array_equal(copied.uv, mesh.uv) and np.array_equal(copied.vertices, mesh.vertices)

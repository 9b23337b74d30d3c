# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The grid against its own faces: edges known without a search are those a search finds, and textures keep lengths."""

from dataclasses import replace

import numpy as np
import pytest
from solids import GLYPHS, ngon

from sweep_addon.core.contours import Circle, Outline, Rectangle
from sweep_addon.core.grids.laying import CAP, SIDE
from sweep_addon.core.meshes.joining import joined
from sweep_addon.core.rings.ends import Open, Taper
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.shapes.rotational_sweep import RotationalSweep
from sweep_addon.core.shapes.translational_sweep import TranslationalSweep
from sweep_addon.core.stations.sampling import Count, Tolerance
from sweep_addon.core.trajectories import Line, Polyline, TorusKnot

PERCENT, _ = GLYPHS["%"]
HALF = Outline([[(0, -1), (0, 1)]], bulges=[(1, 0)], tolerance=0.01)
RIDGE = [(0, 0, 0), (0, 0, 2), (0, 1, 3)]
SHAPES = {
    "tube": GeneralizedCylinder(Circle(0.1, points=5), Line(), Count(4)),
    "open": GeneralizedCylinder(PERCENT, Line(), Count(3), start=Open(), end=Open()),
    "glyphs": GeneralizedCylinder(PERCENT, Line(end=(0, 0, 9)), Count(5)),
    "ring": GeneralizedCylinder(GLYPHS["B"][0], TorusKnot(major=9.0, minor=3.0), Count(40)),
    "spindle": GeneralizedCylinder(Rectangle(), Line(), Count(4), start=Taper(0.5), end=Taper(0.5)),
    "sandglass": GeneralizedCylinder(PERCENT, Line(), Count(5), scale_x="1-2*t", scale_y="1-2*t"),
    "pinched ring": GeneralizedCylinder(
        Circle(0.1, 4), TorusKnot(), Count(9), scale_x="sin(pi*t)", scale_y="sin(pi*t)"
    ),
    "pencil": GeneralizedCylinder(Circle(0.1, points=6), Line(), Count(2), start=Open(), end=Taper(0.3)),
    "cone": GeneralizedCylinder(Circle(0.1, points=3), Line(), Count(2), end=Taper(1.0)),
    "one side": GeneralizedCylinder(Rectangle(0.2, 0.1), TorusKnot(1, 1), Count(9), twist="pi*t"),
    "one side and a hole": GeneralizedCylinder(
        Outline([ngon((0, 0), 0.3, 6), ngon((0, 0), 0.1, 3)]), TorusKnot(1, 1), Count(9), twist="-2*pi/3*t"
    ),
    "mirrored": GeneralizedCylinder(GLYPHS["B"][0], Polyline(RIDGE), scale_x=-0.5),
}
PLANAR = {
    "frustum": TranslationalSweep(PERCENT, 2.0, "both", steps=3, taper=0.01),
    "bipyramid": TranslationalSweep(Rectangle(2, 2), 3.0, "symmetric", taper=np.arctan(2 / 3)),
    "sheets": TranslationalSweep(Outline([[(0, 0), (3, 4), (3, 6)], [(5, 0), (6, 0)]], closed=False)),
    "ball": RotationalSweep(HALF, samples=Count(9)),
    "wedge": RotationalSweep(HALF, 1.0, samples=Count(9)),
    "wedge with an open end": RotationalSweep(HALF, 1.0, samples=Count(9), start=Open()),
    "horn torus": RotationalSweep(Circle(0.5, 12), axis_point=(-0.5, 0), samples=Count(9)),
    "ring of glyphs": RotationalSweep(PERCENT, axis_point=(-2, 0), samples=Count(9)),
    "screw": RotationalSweep(angle=9.0, pitch=1.5),
    "spindle torus": RotationalSweep(Circle(0.5), 2.0, axis_point=(-0.3, 0), crossing="keep"),
    "apple and lemon": RotationalSweep(Circle(0.5), axis_point=(-0.3, 0), crossing="split"),
    "top": RotationalSweep(Outline([[(0, 0), (1, 1), (1, 2), (0, 2)]], closed=False)),
}
SHAPES["two"] = None


def mesh_of(name):
    if name == "two":
        return joined([SHAPES["sandglass"].mesh(), SHAPES["ring"].mesh(), SHAPES["tube"].mesh()])
    return (SHAPES | PLANAR)[name].mesh()


def faces_at_edges(mesh):
    """The edge at each corner, its two ends as the face runs, and the face: (c,), (c, 2), (c,)."""
    face = np.repeat(np.arange(len(mesh.offsets) - 1), np.diff(mesh.offsets))
    return mesh.topology.corner_edges, np.stack((mesh.corners, mesh.corners[mesh.topology.following]), axis=1), face


def lowest_of_face(values, mesh):
    """The least value at the corners of each face, at each of its corners."""
    return np.repeat(np.minimum.reduceat(values, mesh.offsets[:-1]), np.diff(mesh.offsets))


@pytest.mark.parametrize("name", [*SHAPES, *PLANAR])
def test_edges_known_beforehand_are_those_of_the_faces(name):
    mesh = mesh_of(name)
    known = {tuple(sorted(edge)) for edge in mesh.edges.tolist()}
    edges, ends, _ = faces_at_edges(mesh)
    assert known == {tuple(sorted(edge)) for edge in ends.tolist()}
    assert len(known) == len(mesh.edges), "an edge twice"
    assert (np.sort(mesh.edges[edges], axis=1) == np.sort(ends, axis=1)).all()
    for array in (mesh.corners, mesh.offsets, mesh.edges, edges):
        assert array.dtype == np.int32


@pytest.mark.parametrize("name", [*SHAPES, *PLANAR])
def test_every_vertex_edge_and_face_has_what_belongs_to_it(name):
    mesh = mesh_of(name)
    assert mesh.topology.sharp.shape == (len(mesh.edges),) and mesh.topology.material.shape == (len(mesh.offsets) - 1,)
    assert mesh.uv.shape == (len(mesh.corners), 2)
    assert {key: value.shape for key, value in mesh.attributes.items()} == dict.fromkeys(
        ("u", "v", "arc_length"), (len(mesh.vertices),)
    )


@pytest.mark.parametrize(
    ("name", "sides", "caps"), [("tube", 15, 2), ("open", 0, 0), ("glyphs", 0, 0), ("pencil", 12, 0)]
)
def test_sides_and_caps_have_a_material_each(name, sides, caps):
    mesh = mesh_of(name)
    normals = mesh.normals / np.linalg.norm(mesh.normals, axis=1, keepdims=True)
    across = np.abs(normals[:, 2]) > 0.999
    assert (mesh.topology.material == np.where(across, CAP, SIDE)).all()
    if sides:
        assert np.bincount(mesh.topology.material, minlength=2).tolist() == [sides, caps]


def stretches(mesh, material):
    """How much longer each edge of each face is in the texture than in space, and how much larger the face: (n,)."""
    _, ends, face = faces_at_edges(mesh)
    chosen = mesh.topology.material[face] == material
    texture = mesh.uv[mesh.topology.following] - mesh.uv
    space = np.linalg.norm(mesh.vertices[ends[:, 1]] - mesh.vertices[ends[:, 0]], axis=1)
    return (np.linalg.norm(texture, axis=1) / space)[chosen]


@pytest.mark.parametrize("contour", [Circle(0.05), Rectangle(0.2, 0.1), Rectangle(1.0, 2.0, 0.3), GLYPHS["@"][0]])
def test_textures_of_a_tube_are_as_long_as_the_tube_however_uneven_its_points(contour):
    uneven = Polyline([(0, 0, z) for z in (0, 0.1, 0.2, 0.3, 5, 10)])
    for trajectory, samples in ((uneven, Tolerance()), (Line(end=(0, 0, 10)), Count(7))):
        mesh = GeneralizedCylinder(contour, trajectory, samples).mesh()
        for material in (SIDE, CAP):
            stretch = stretches(mesh, material)
            assert stretch.max() / stretch.min() <= 1 + 1e-9 and abs(stretch.mean() - 1) < 1e-9


def test_textures_of_a_bent_tube_are_as_long_as_its_trajectory():
    """Each row of faces is as long in the texture as the arc from contour to contour, whatever the samples."""
    shape = GeneralizedCylinder(Circle(0.01), TorusKnot(), Tolerance(1e-5))
    stretch = stretches(shape.mesh(), SIDE)
    assert stretch.max() / stretch.min() < 1.001 * (1 + 0.01 * 4) / (1 - 0.01 * 4)  # radius times curvature under 4


@pytest.mark.parametrize("texture", ["lengths", "unit"])
@pytest.mark.parametrize("name", [name for name in SHAPES if name != "two"])
def test_no_texture_is_seen_in_a_mirror(name, texture):
    """Seen from outside, the corners of a face run the same way round in the texture as in space: counter-clockwise."""
    mesh = replace(SHAPES[name], texture=texture).mesh()
    (x, y), (ahead_x, ahead_y) = mesh.uv.T, mesh.uv[mesh.topology.following].T
    assert (np.add.reduceat(x * ahead_y - y * ahead_x, mesh.offsets[:-1]) > 0).all()


@pytest.mark.parametrize("name", ["tube", "open", "glyphs", "ring", "one side", "one side and a hole", "mirrored"])
def test_the_seam_runs_along_edges_one_for_each_loop(name):
    """A texture is torn only where a loop begins, where a closed trajectory does, and round the caps."""
    mesh, shape = mesh_of(name), SHAPES[name]
    edges, ends, face = faces_at_edges(mesh)
    order = np.argsort(edges, kind="stable")
    twice = order[np.flatnonzero(np.diff(edges[order]) == 0)], order[1:][np.diff(edges[order]) == 0]
    here = mesh.uv[twice[0]], mesh.uv[mesh.topology.following[twice[0]]]
    there = mesh.uv[mesh.topology.following[twice[1]]], mesh.uv[twice[1]]  # the other face runs the other way
    torn = np.maximum(*(np.abs(a - b).max(axis=1) for a, b in zip(here, there, strict=True))) > 1e-9
    rim = mesh.topology.material[face[twice[0]]] != mesh.topology.material[face[twice[1]]]
    section = shape.contour.section()
    loops, columns = len(section.offsets) - 1, len(section.points)
    bands = mesh.rings if shape.trajectory.closed else mesh.rings - 1
    closing = columns if shape.trajectory.closed else 0
    assert (torn[rim]).all() and torn[~rim].sum() == loops * bands + closing


def test_sharp_edges_are_the_contours_corners_the_rims_and_the_mitres():
    straight = GeneralizedCylinder(Rectangle(), Line(), Count(4)).mesh()
    assert straight.topology.sharp.sum() == 4 * 3 + 2 * 4
    along = np.abs(np.diff(straight.vertices[straight.edges], axis=1)[:, 0, 2]) > 0
    assert straight.topology.sharp[along].all()
    tube = GeneralizedCylinder(Circle(0.1, points=5), Line(), Count(4), start=Open()).mesh()
    assert straight.topology.sharp.dtype == bool and tube.topology.sharp.sum() == 5
    for degrees, sharp in ((10, 0), (19, 0), (21, 5), (90, 5)):
        turn = np.radians(degrees)
        bent = Polyline([(0, 0, 0), (0, 0, 1), (0, np.sin(turn), 1 + np.cos(turn))])
        mesh = GeneralizedCylinder(Circle(0.1, points=5), bent, start=Open(), end=Open()).mesh()
        assert mesh.topology.sharp.sum() == sharp
    rounded = GeneralizedCylinder(Rectangle(rounding=0.2), Line(), start=Open(), end=Open()).mesh()
    assert rounded.topology.sharp.sum() == 0


def test_attributes_say_where_on_the_sweep_a_vertex_is():
    shape = GeneralizedCylinder(Circle(0.5, points=64), Line(end=(0, 0, 3)), Count(4), end=Taper(1.0))
    mesh = shape.mesh()
    height = mesh.vertices[:, 2]
    angle = np.arctan2(mesh.vertices[:, 1], mesh.vertices[:, 0]) % (2 * np.pi)
    assert np.abs(mesh.attributes["arc_length"] - height).max() < 1e-12
    assert np.abs(mesh.attributes["u"] - height / 3).max() < 1e-12
    turned = (angle - angle[0]) % (2 * np.pi)
    perimeter = 64 * 2 * 0.5 * np.sin(np.pi / 64)  # of the polygon, in metres
    around = mesh.attributes["v"] / perimeter * 2 * np.pi
    rings = height < 3
    assert np.abs(np.cos(turned - around)[rings] - 1).max() < 1e-12


def test_equal_grids_share_their_arrays_and_unequal_ones_have_other_keys():
    tube = SHAPES["tube"]
    thicker = GeneralizedCylinder(Circle(0.2, points=5), Line(), Count(4))
    assert tube.mesh().topology is thicker.mesh().topology
    keys = {mesh_of(name).topology.key for name in [*SHAPES, *PLANAR]}
    assert len(keys) == len(SHAPES) + len(PLANAR)
    (_, along, across), (_, same, other), (_, longer, _) = (
        made.chart.keys for made in (tube.mesh(), thicker.mesh(), mesh_of("pencil"))
    )
    assert along == same != longer and across != other


@pytest.mark.parametrize("name", [name for name in SHAPES if name not in ("two", "mirrored")])
def test_unit_texture_runs_from_0_to_1_along_and_round_each_loop_in_proportion_to_lengths(name):
    lengths, unit = SHAPES[name].mesh(), replace(SHAPES[name], texture="unit").mesh()
    side = np.repeat(lengths.topology.material == SIDE, np.diff(lengths.offsets))
    perimeters = SHAPES[name].contour.section().perimeters
    starts = np.cumsum(perimeters) - perimeters
    metres = lengths.uv[:, 1] * perimeters.sum() / lengths.chart.around[-1]
    loop = np.searchsorted(starts, lowest_of_face(metres, lengths)[side] + 1e-9) - 1
    (along, _), shares, around = lengths.uv[side].T, unit.uv[side].T, metres[side]
    assert np.abs(shares[0] - along / lengths.chart.total).max() < 1e-12
    assert np.abs(shares[1] - (around - starts[loop]) / perimeters[loop]).max() < 1e-9
    assert unit.uv.min() >= 0 and unit.uv.max() <= 1 + 1e-12


def test_textures_and_attributes_that_are_not_wanted_are_not_made():
    bare = replace(SHAPES["tube"], texture="none", attributes=False).mesh()
    assert bare.uv is None and bare.attributes == {} and bare.chart.keys == ("", "", "")
    assert joined([bare, bare]).uv is None


def test_a_concave_cap_has_the_area_of_its_outline():
    """The surface of a prism: twice its base, and its height times the perimeter."""
    for glyph, _ in GLYPHS.values():
        section = glyph.section()
        mesh = GeneralizedCylinder(Outline(glyph.loops), Line(end=(0, 0, 3))).mesh()
        assert mesh.area() == pytest.approx(2 * section.area + 3 * section.perimeters.sum(), rel=1e-12)
        assert mesh.volume() == pytest.approx(3 * section.area, rel=1e-12)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is written into a Blender mesh: the arrays of the shape, which Blender itself finds nothing wrong with."""

from dataclasses import replace

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

import bmesh
from scenes import places

import sweep_addon as sw
from sweep_addon import presets
from sweep_addon.bridge import meshes
from sweep_addon.bridge.own_arrays import MANY
from sweep_addon.core.meshes.joining import joined

WASHER = sw.contours.Outline(loops=[[(-1, -1), (1, -1), (1, 1), (-1, 1)], [(-0.5, -0.5), (0.5, -0.5), (0, 0.5)]])
HALF = sw.contours.Outline([[(0, -1), (0, 1)]], bulges=[(1, 0)])
LINE, HELIX, KNOT = sw.trajectories.Line(end=(0, 0, 2)), sw.trajectories.Helix(), sw.trajectories.TorusKnot()
WIDE_KNOT = sw.trajectories.TorusKnot(major=9, minor=3)
CORNER = sw.trajectories.Polyline([(0, 0, 0), (0, 0, 2), (0, 2, 2)])


def shape(contour, trajectory, contours=40, **others):
    return sw.GeneralizedCylinder(contour, trajectory, sw.sampling.Count(contours), **others)


SHAPES = {
    "tube": shape(sw.contours.Circle(0.2), HELIX),
    "open at both ends": shape(sw.contours.Circle(0.2), LINE, start="open", end="open"),
    "tips at both ends": shape(sw.contours.Circle(0.2), LINE, start="taper", end="taper"),
    "cone by a law": shape(sw.contours.Rectangle(), LINE, scale_x="1 - t", scale_y="1 - t"),
    "waist of a point": shape(sw.contours.Circle(0.2), LINE, scale_x="abs(2*t - 1)", scale_y="abs(2*t - 1)"),
    "hole": shape(WASHER, LINE),
    "hole, corner": shape(WASHER, CORNER),
    "closed": shape(sw.contours.Circle(0.1), KNOT),
    "closed with a hole": shape(WASHER, WIDE_KNOT, contours=1000),
    "closed with a turn": shape(sw.contours.Rectangle(0.1, 0.1), KNOT, contours=400, twist="pi/2*t"),
    "triangles": shape(sw.contours.Circle(0.2, points=3), LINE),
    "frustum": sw.TranslationalSweep(WASHER, taper=0.1, hole_taper=-0.1),
    "draft beyond its fillets": sw.TranslationalSweep(sw.contours.Rectangle(3.0, 2.0, 0.25), taper=0.5),
    "walls that end in a ridge": sw.TranslationalSweep(WASHER, 2.0, "symmetric", taper=0.3, hole_taper=0.3),
    "open sheets": sw.TranslationalSweep(sw.contours.Outline([[(0, 0), (1, 0), (1, 1)]], closed=False)),
    "ball": sw.RotationalSweep(HALF),
    "wedge": sw.RotationalSweep(HALF, 2.0),
    "apple and lemon": sw.RotationalSweep(sw.contours.Circle(0.5), axis_point=(0.3, 0), crossing="split"),
}


MIXED = {
    "points": sw.TranslationalSweep(sw.contours.Mixed([], [], [(0, 0), (1, 0)])),
    **{p.title: presets.shape(p.name) for p in presets.PRESETS if p.group == "mixed_dimension"},
}


@pytest.fixture(params=SHAPES)
def name(request, scene):
    return request.param


def mesh_of(shape):
    return sw.to_object(shape).data


def attribute(mesh, name, kind, count, dtype=np.float32):
    values = np.empty(count * len(mesh.attributes[name].data), dtype)
    mesh.attributes[name].data.foreach_get(kind, values)
    return values.reshape(-1, count) if count > 1 else values


def normals(mesh):
    """The normal at each vertex and at each corner: (n, 3)."""
    found = []
    for kept in (mesh.vertex_normals, mesh.corner_normals):
        found.append(np.empty(3 * len(kept), np.float32))
        kept.foreach_get("vector", found[-1])
    return np.concatenate(found).reshape(-1, 3)


def same_as_arrays(mesh, made):
    """Assert that a Blender mesh holds every array of a mesh of arrays."""
    assert np.array_equal(places(mesh), made.vertices.astype(np.float32))
    assert attribute(mesh, ".corner_vert", "value", 1, np.int32).tolist() == made.corners.tolist()
    assert [p.loop_start for p in mesh.polygons] == made.offsets[:-1].tolist()
    assert [p.loop_total for p in mesh.polygons] == np.diff(made.offsets).tolist()
    assert [tuple(e.vertices) for e in mesh.edges] == [tuple(pair) for pair in made.edges.tolist()]
    assert [loop.edge_index for loop in mesh.loops] == made.topology.corner_edges.tolist()
    assert [e.use_edge_sharp for e in mesh.edges] == made.topology.sharp.tolist()
    assert [p.material_index for p in mesh.polygons] == made.topology.material.tolist()
    assert [layer.name for layer in mesh.uv_layers] == ["UVMap"]
    assert np.allclose(attribute(mesh, "UVMap", "vector", 2), made.uv, rtol=1e-5, atol=1e-6)
    assert set(made.attributes) == {"u", "v", "arc_length"}
    for key, values in made.attributes.items():
        assert np.allclose(attribute(mesh, key, "value", 1), values, rtol=1e-5, atol=1e-6)


def test_mesh_holds_every_array_of_the_shape(name):
    mesh = mesh_of(SHAPES[name])
    same_as_arrays(mesh, SHAPES[name].mesh(dtype=np.float32))
    assert len(mesh.materials) == 2
    assert {p.material_index for p in mesh.polygons} <= {0, 1}


def test_blender_finds_nothing_to_repair(name):
    mesh = mesh_of(SHAPES[name])
    assert not mesh.validate(verbose=True)
    assert not any(e.is_loose for e in mesh.edges)


@pytest.mark.parametrize("name", MIXED)
def test_mesh_of_mixed_dimension_holds_its_loose_edges_and_points(scene, name):
    """Blender finds as many loose edges as the report has in curves, and loose vertices as it has points."""
    mesh, made = mesh_of(MIXED[name]), MIXED[name].mesh(dtype=np.float32)
    same_as_arrays(mesh, made)
    assert not mesh.validate(verbose=True) and mesh.sweep.told == f"Parts: {made.dimensions()}."
    kept = np.isin(np.arange(len(mesh.edges)), made.topology.corner_edges)
    assert [e.is_loose for e in mesh.edges] == (~kept).tolist()
    seen = bmesh.new()
    seen.from_mesh(mesh)
    assert sum(not v.link_edges for v in seen.verts) == made.dimensions().points
    assert sum(len(e.link_faces) > 2 for e in seen.edges) == len(made.dimensions().non_manifold_edges)
    seen.free()


def test_edges_are_those_that_blender_finds(name):
    """`update(calc_edges=True)` is what the analytic edges save."""
    mesh = mesh_of(SHAPES[name])
    found = bpy.data.meshes.new("found")
    found.from_pydata(places(mesh).tolist(), [], [list(p.vertices) for p in mesh.polygons])
    assert {frozenset(e.vertices) for e in mesh.edges} == {frozenset(e.vertices) for e in found.edges}
    assert len(mesh.edges) == len(found.edges)


@pytest.mark.parametrize("name", [name for name in SHAPES if "open" not in name])
def test_faces_look_outwards_and_enclose_the_volume_of_the_shape(scene, name):
    """bmesh sums a signed tetrahedron for each triangle of its own triangulation."""
    measured = bmesh.new()
    measured.from_mesh(mesh_of(SHAPES[name]))
    assert all(edge.is_manifold and edge.is_contiguous for edge in measured.edges)
    assert measured.calc_volume(signed=True) == pytest.approx(SHAPES[name].mesh().volume(), rel=2e-3)
    assert measured.calc_volume(signed=True) > 0
    measured.free()


def test_one_mesh_becomes_each_of_the_others_and_itself_again(scene):
    mesh = bpy.data.meshes.new("many")
    known = "", ""
    shapes = SHAPES | MIXED
    for each in [*shapes, *reversed(shapes)]:
        made = shapes[each].mesh(dtype=np.float32)
        *known, _ = meshes.write(mesh, made, *known)
        same_as_arrays(mesh, made)
        assert not mesh.validate()


def test_where_only_places_change_only_they_are_written(scene, monkeypatch):
    mesh, written = mesh_of(SHAPES["closed"]), []
    before = places(mesh)
    monkeypatch.setattr(meshes, "write_topology", lambda *_: written.append("topology"))
    monkeypatch.setattr(meshes, "attribute", lambda mesh, name, *_: written.append(name))
    mesh.sweep.generalized_cylinder.twist_constant_value = 0.1
    assert written == [] and not np.array_equal(places(mesh), before)


def test_where_lengths_alone_change_u_stays_and_is_what_it_would_be_anew(scene):
    """The angle of a helix is the same at every part of its length, however steep it is."""
    steeper = sw.trajectories.Helix(pitch=0.75)
    ob = sw.to_object(shape(sw.contours.Circle(0.2), HELIX))
    ob.data.attributes["u"].data[7].value = 12345.0  # what is written again would not keep it
    ob.data.sweep.generalized_cylinder.trajectory_helix_pitch = 0.75
    made = shape(sw.contours.Circle(0.2), steeper).mesh(np.float32)
    found = {name: attribute(ob.data, name, "value", 1) for name in ("u", "v", "arc_length")}
    assert found["u"][7] == 12345.0
    found["u"][7] = made.attributes["u"][7]
    for name, values in found.items():
        assert (values == made.attributes[name].astype(np.float32)).all(), name


def test_u_is_written_again_where_it_changes_too_and_where_it_was_removed(scene):
    ob = sw.to_object(shape(sw.contours.Circle(0.2), HELIX))
    group = ob.data.sweep.generalized_cylinder
    group.trajectory_helix_turns = 3.0
    assert attribute(ob.data, "u", "value", 1).max() == np.float32(6 * np.pi)
    ob.data.attributes.remove(ob.data.attributes["u"])
    group.trajectory_helix_pitch = 0.75
    assert attribute(ob.data, "u", "value", 1).max() == np.float32(6 * np.pi)


def test_large_attributes_are_written_in_place_and_a_copy_of_the_mesh_keeps_its_own(scene):
    """So many vertices that the array is Blender's own, which a copy shares until either is written."""
    tube = shape(sw.contours.Circle(0.2), HELIX, contours=1 + MANY // 64)
    mesh = mesh_of(tube)
    copy, before = mesh.copy(), attribute(mesh, "arc_length", "value", 1)
    mesh.sweep.generalized_cylinder.trajectory_helix_pitch = 0.75
    same_as_arrays(mesh, replace(tube, trajectory=sw.trajectories.Helix(pitch=0.75)).mesh(dtype=np.float32))
    assert (attribute(copy, "arc_length", "value", 1) == before).all()
    assert (attribute(mesh, "arc_length", "value", 1)[1:] != before[1:]).any()


def test_texture_and_attributes_that_are_not_wanted_go_and_come_again(scene):
    mesh = mesh_of(SHAPES["tube"])
    group, names = mesh.sweep.generalized_cylinder, {"UVMap", "u", "v", "arc_length"}
    group.texture = "NONE"
    assert names & set(mesh.attributes.keys()) == {"u", "v", "arc_length"}
    group.attributes = False
    assert not names & set(mesh.attributes.keys())
    group.texture, group.attributes = "UNIT", True
    assert names <= set(mesh.attributes.keys())
    same_as_arrays(mesh, replace(SHAPES["tube"], texture="unit").mesh(dtype=np.float32))


def test_where_only_the_seam_moves_only_what_faces_join_is_written(scene, monkeypatch):
    """And Blender forgets what it had found out: its normals are those of a mesh that was written at once."""
    frames = [sw.frames.RotationMinimizing(extra_sectors=sectors) for sectors in range(4)]
    turned = [shape(sw.contours.Rectangle(0.1, 0.1), KNOT, frame=frame).mesh(dtype=np.float32) for frame in frames]
    expected = []
    for made in turned:
        meshes.write(bpy.data.meshes.new("fresh"), made)
        expected.append(normals(bpy.data.meshes["fresh"]))
        bpy.data.meshes.remove(bpy.data.meshes["fresh"])
    mesh = bpy.data.meshes.new("turned")
    *known, _ = meshes.write(mesh, turned[-1])
    monkeypatch.setattr(meshes, "write_topology", None)
    for made, found in zip(turned, expected, strict=True):
        normals(mesh)
        *known, _ = meshes.write(mesh, made, *known)
        same_as_arrays(mesh, made)
        assert np.abs(normals(mesh) - found).max() < 1e-6
        assert not mesh.validate()


def test_tubes_along_several_splines_are_one_valid_mesh(scene):
    parts = [SHAPES[name].mesh(dtype=np.float32) for name in ("tube", "hole", "tips at both ends")]
    mesh, made = bpy.data.meshes.new("several"), joined(parts)
    meshes.write(mesh, made)
    same_as_arrays(mesh, made)
    assert not mesh.validate()


def test_attribute_of_a_person_in_the_way_is_replaced_and_others_stay(scene):
    ob = sw.to_object(SHAPES["tube"])
    ob.data.attributes.remove(ob.data.attributes["u"])
    ob.data.attributes.new("u", "INT", "FACE")
    ob.data.attributes.new("weight", "FLOAT", "POINT")
    ob.data.sweep.generalized_cylinder.trajectory_helix_pitch = 2
    same_as_arrays(ob.data, sw.from_object(ob).mesh(dtype=np.float32))
    assert "weight" in ob.data.attributes


def test_large_mesh_changes_its_mark_when_a_hundred_and_twenty_eighth_of_it_moves(scene):
    """Only a sample is read where there are many vertices: 0.2 ms where all of them take 2 (Edit Mode compares all)."""
    mesh = mesh_of(shape(sw.contours.Circle(0.2), HELIX, contours=4000))
    before = meshes.mark(mesh)
    assert len(mesh.vertices) > 200_000 and before == mesh.sweep.mark
    moved = places(mesh)
    moved[100_000 : 100_000 + len(moved) // 128 + 1] += 0.1
    mesh.attributes["position"].data.foreach_set("vector", moved.astype(np.float32).ravel())
    assert meshes.mark(mesh) != before

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh that a person edits by hand is left alone while they do, and says that the next change replaces it."""

import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

import bmesh
from scenes import extent, parameters_of, select, sweep

from sweep_addon.bridge import meshes


def mode(name):
    bpy.ops.object.mode_set(mode=name)
    bpy.context.view_layer.update()


@pytest.fixture
def ob(scene):
    made = sweep()
    select(made)
    return made


def lift(ob, by):
    """Move the vertices of a mesh in Edit Mode."""
    edited = bmesh.from_edit_mesh(ob.data)
    edited.verts.ensure_lookup_table()
    edited.verts[0].co.z += by
    bmesh.update_edit_mesh(ob.data)
    bpy.context.view_layer.update()


def test_edit_mode_alone_is_no_edit(ob):
    mode("EDIT")
    mode("OBJECT")
    assert not ob.data.sweep.edited


def test_an_edit_is_kept_and_said_until_the_next_change_replaces_it(ob):
    mode("EDIT")
    lift(ob, 5)
    mode("OBJECT")
    bpy.context.scene.frame_set(7)
    assert ob.data.sweep.edited and extent(ob) == pytest.approx((1, 1, 5))
    parameters_of(ob).contour_circle_radius = 1.5
    assert not ob.data.sweep.edited and extent(ob) == pytest.approx((3, 3, 2))


def test_an_edit_that_is_taken_back_is_none(ob):
    mode("EDIT")
    lift(ob, 5)
    mode("OBJECT")
    mode("EDIT")
    lift(ob, -5)
    mode("OBJECT")
    assert not ob.data.sweep.edited


@pytest.mark.parametrize("applied_first", [True, False])
def test_an_applied_modifier_lasts_where_the_sweep_was_applied_first(ob, applied_first):
    ob.data.sweep.generalized_cylinder.keyframe_insert("contour_circle_radius", frame=1)
    parameters_of(ob).contour_circle_radius = 1.5
    ob.data.sweep.generalized_cylinder.keyframe_insert("contour_circle_radius", frame=9)
    before = len(ob.data.vertices)
    if applied_first:
        assert bpy.ops.object.sweep_apply() == {"FINISHED"}
    ob.modifiers.new("Shell", "SOLIDIFY")
    assert bpy.ops.object.modifier_apply(modifier="Shell") == {"FINISHED"}
    assert len(ob.data.vertices) == 2 * before
    bpy.context.view_layer.update()
    assert ob.data.sweep.edited != applied_first  # which the sidebar says
    bpy.context.scene.frame_set(5)
    assert len(ob.data.vertices) == (2 * before if applied_first else before)


def test_an_edit_of_faces_is_replaced_whole(ob):
    faces = len(ob.data.polygons)
    mode("EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.delete(type="ONLY_FACE")
    mode("OBJECT")
    assert ob.data.sweep.edited and not ob.data.polygons
    parameters_of(ob).trajectory_line_end = (0, 0, 3)  # the faces stay which they were
    assert len(ob.data.polygons) == faces and extent(ob)[2] == 3


def test_an_edit_that_turns_faces_round_is_replaced_whole(ob):
    """As many vertices and faces as before, in their places."""
    corners = [loop.vertex_index for loop in ob.data.loops]
    mode("EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.flip_normals()
    mode("OBJECT")
    assert ob.data.sweep.edited and [loop.vertex_index for loop in ob.data.loops] != corners
    parameters_of(ob).twist_constant_value = 1
    assert not ob.data.sweep.edited and [loop.vertex_index for loop in ob.data.loops] == corners


def test_a_change_while_in_edit_mode_waits_for_its_end(ob, monkeypatch):
    written, write = [], meshes.write
    monkeypatch.setattr(meshes, "write", lambda mesh, *others: written.append(mesh.name) or write(mesh, *others))
    mode("EDIT")
    parameters_of(ob).contour_circle_radius = 1.5
    bpy.context.view_layer.update()
    assert written == [] and max(v.co.x for v in bmesh.from_edit_mesh(ob.data).verts) == pytest.approx(0.5)
    mode("OBJECT")
    assert extent(ob) == pytest.approx((3, 3, 2)) and not ob.data.sweep.edited


def test_keyframes_wait_for_the_end_of_edit_mode(ob):
    parameters_of(ob).keyframe_insert("contour_circle_radius", frame=1)
    parameters_of(ob).contour_circle_radius = 2.5
    parameters_of(ob).keyframe_insert("contour_circle_radius", frame=11)
    bpy.context.scene.frame_set(1)
    mode("EDIT")
    bpy.context.scene.frame_set(11)
    assert max(v.co.x for v in bmesh.from_edit_mesh(ob.data).verts) == pytest.approx(0.5)
    mode("OBJECT")
    assert extent(ob)[0] == pytest.approx(5)


def test_a_mesh_moved_by_a_script_says_so(ob):
    ob.data.vertices[0].co.z += 5
    ob.data.update()
    bpy.context.view_layer.update()
    assert ob.data.sweep.edited and extent(ob)[2] == 5


def test_a_mesh_joined_to_a_sweep_says_so(ob):
    bpy.ops.mesh.primitive_plane_add(location=(0, 0, 9))
    select(ob, bpy.context.active_object)
    bpy.ops.object.join()
    bpy.context.view_layer.update()
    assert ob.data.sweep.edited and extent(ob)[2] == 9


def test_an_applied_scale_says_so(ob):
    ob.scale = (1, 1, 3)
    bpy.ops.object.transform_apply(location=False, rotation=False, scale=True)
    bpy.context.view_layer.update()
    assert ob.data.sweep.edited and extent(ob)[2] == 6

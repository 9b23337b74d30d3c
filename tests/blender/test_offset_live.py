# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Offset surfaces of mesh objects follow these, and refuse what is not closed."""

import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import add, curve, extent, select

import sweep_addon as sw
from sweep_addon.bridge import objects
from sweep_addon.properties import finding, live, solving

CORNERS = [(x, y, z) for x in (-0.2, 0.2) for y in (-0.2, 0.2) for z in (-0.2, 0.2)]
FACES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def cube(faces):
    mesh = bpy.data.meshes.new("cube")
    mesh.from_pydata(CORNERS, [], faces)
    return add("cube", mesh)


def test_a_mesh_object_is_offset_and_followed(scene):
    model = cube(FACES)
    ob = add("offset", objects.new_mesh(sw.OffsetSurface(radius=0.1), body=model))
    assert extent(ob) == pytest.approx((0.6, 0.6, 0.6), abs=1e-5)
    ob.data.sweep.offset_surface.radius = 0.2
    assert extent(ob) == pytest.approx((0.8, 0.8, 0.8), abs=1e-5)
    ob.data.sweep.offset_surface.side = "INSIDE"
    assert "must leave something" in ob.data.sweep.error
    for vertex in model.data.vertices:
        vertex.co *= 2
    model.data.update()
    bpy.context.view_layer.update()
    assert extent(ob) == pytest.approx((0.4, 0.4, 0.4), abs=1e-5) and ob.data.sweep.error == ""


def test_an_open_mesh_object_is_refused(scene):
    model = cube(FACES[1:])
    with pytest.raises(sw.ShapeError, match="body: must be closed, got '4 open edges'"):
        objects.new_mesh(sw.OffsetSurface(), body=model)


def test_the_active_mesh_is_offset_where_it_stands(scene):
    model = cube(FACES)
    model.location, model.scale = (1, 2, 3), (2, 2, 2)
    select(model)
    assert bpy.ops.object.sweep_offset_selected() == {"FINISHED"}
    ob = bpy.context.active_object
    bpy.context.view_layer.update()
    assert ob.parent == model and objects.inputs(ob.data) == {"body": model}
    radius = ob.data.sweep.offset_surface.radius
    assert radius == pytest.approx(0.4 / 20)
    assert extent(ob) == pytest.approx([0.4 + 2 * radius] * 3, abs=1e-4)  # in the mesh's own space, which is scaled
    assert ob.matrix_world.translation[:] == pytest.approx((1, 2, 3))


def test_nothing_is_offset_but_a_mesh(scene):
    select(curve("POLY", [(0, 0, 0), (0, 0, 1)]))
    with pytest.raises(RuntimeError, match="Select a closed mesh"):
        bpy.ops.object.sweep_offset_selected()


def test_in_a_window_a_rough_offset_stands_until_the_true_one_is_made(scene, monkeypatch):
    monkeypatch.setattr(live, "waits", lambda depsgraph: True)
    ob = sw.to_object(sw.OffsetSurface(sw.solids.Ball(0.2, 16), radius=0.1))
    assert ob.data.sweep.solid == live.AWAITED and extent(ob)[2] == pytest.approx(0.6, rel=0.02)
    work = solving.work_of(ob.data)
    work.thread.join()
    solving.finish(ob.data, work)
    assert ob.data.sweep.solid == "" and "Offset by" in ob.data.sweep.told


def test_it_meets_itself_nowhere_and_has_no_frames(scene):
    ob = sw.to_object(sw.OffsetSurface())
    assert finding.find(ob.data) == ()

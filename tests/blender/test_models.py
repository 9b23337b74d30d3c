# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh objects as generators: read as they are shown, followed live, refused where they cannot be."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import add, curve, extent, places, select

import sweep_addon as sw
from sweep_addon.bridge import objects
from sweep_addon.core.shapes.general_sweep import GeneralSweep
from sweep_addon.core.solids import Block, Triangles
from sweep_addon.properties import live, solving


def update():
    bpy.context.view_layer.update()


def mesh_object(vertices, faces, name="model"):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], faces)
    return add(name, mesh)


def square(size=1.0):
    h = size / 2
    return mesh_object([(-h, -h, 0), (h, -h, 0), (h, h, 0), (-h, h, 0)], [(0, 1, 2, 3)])


def cube(size=0.4):
    h = size / 2
    corners = [(x, y, z) for x in (-h, h) for y in (-h, h) for z in (-h, h)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return mesh_object(corners, faces)


def general(model, trajectory=None, **given):
    """A live general sweep of a mesh object."""
    shape = GeneralSweep(trajectory=trajectory or sw.trajectories.Line(), **given)
    mesh = objects.new_mesh(shape, generator=model)
    return add("sweep", mesh)


def test_a_surface_is_swept_and_followed_when_it_is_edited(scene):
    model = square()
    ob = general(model)
    assert extent(ob) == pytest.approx((1, 1, 1)) and ob.data.sweep.error == ""
    for vertex in model.data.vertices:
        vertex.co *= 2
    model.data.update()
    update()
    assert extent(ob) == pytest.approx((2, 2, 1))


def test_a_solid_is_swept_with_its_modifiers(scene):
    model = cube()
    ob = general(model, cells=16)
    assert extent(ob) == pytest.approx((0.4, 0.4, 1.4), abs=0.01)
    array = model.modifiers.new("mirror", "ARRAY")
    array.count = 2
    array.use_relative_offset, array.use_constant_offset = False, True
    array.constant_offset_displace = (1.0, 0.0, 0.0)
    update()
    assert extent(ob) == pytest.approx((1.4, 0.4, 1.4), abs=0.02)


def test_the_scale_of_the_object_counts(scene):
    model = square()
    ob = general(model)
    model.scale = (3, 1, 1)
    update()
    assert extent(ob) == pytest.approx((3, 1, 1))


def test_a_curve_may_be_the_generator_too(scene):
    outline = curve("POLY", [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], use_cyclic_u=True)
    assert extent(general(outline)) == pytest.approx((2, 2, 1))


def test_from_object_has_the_triangles(scene):
    shape = sw.from_object(general(square()))
    assert isinstance(shape.generator, Triangles) and len(shape.generator.faces) == 2
    assert sw.load(sw.dump(shape)) == shape


def test_a_deleted_model_keeps_the_last_mesh_and_says_so(scene):
    model = square()
    ob = general(model)
    before = places(ob.data)
    bpy.data.objects.remove(model)
    update()
    ob.data.sweep.general_sweep.turn_z_constant_value = 0.1
    assert np.array_equal(places(ob.data), before) and ob.data.sweep.error.startswith("generator: must be an object")


def test_a_mesh_without_faces_is_refused(scene):
    model = mesh_object([(0, 0, 0), (1, 0, 0)], [])
    with pytest.raises(sw.ShapeError, match="^generator: must be a mesh with faces, got 'model'"):
        general(model)


def test_a_sweep_may_move_another_one_but_not_itself(scene):
    first = general(square())
    second = general(first, cells=8)
    assert second.data.sweep.error == "" and extent(second) == pytest.approx((1, 1, 2), abs=0.02)
    first.data.sweep.general_sweep.trajectory_line_end = (0, 0, 2)
    update()
    assert extent(second) == pytest.approx((1, 1, 3), abs=0.03)  # it follows what follows
    group = first.data.sweep.general_sweep
    group.generator_object = second
    assert first.data.sweep.error.startswith("generator: must not be made from this sweep, as 'sweep.001' is")


def test_add_operator_makes_the_default(scene):
    """But for the size of cells, which makes it quick."""
    assert bpy.ops.mesh.general_sweep_add(cells=12) == {"FINISHED"}
    ob = bpy.context.active_object
    assert objects.is_sweep(ob) and sw.from_object(ob) == GeneralSweep(cells=12)
    assert GeneralSweep().generator != Block()


def test_in_a_window_a_coarse_mesh_stands_until_the_fine_one_is_made(scene, monkeypatch):
    monkeypatch.setattr(live, "waits", lambda depsgraph: True)
    ob = sw.to_object(GeneralSweep(Block(0.4, 0.4, 0.4), sw.trajectories.Line(), cells=40))
    coarse = len(ob.data.vertices)
    assert ob.data.sweep.solid == live.AWAITED and "cells of 0.07 m" in ob.data.sweep.told
    work = solving.work_of(ob.data)
    work.thread.join()
    solving.finish(ob.data, work)
    assert ob.data.sweep.solid == "" and len(ob.data.vertices) > 3 * coarse and work.part > 0.5
    assert "cells of 0.035 m" in ob.data.sweep.told


def test_a_planar_generator_does_not_wait(scene, monkeypatch):
    monkeypatch.setattr(live, "waits", lambda depsgraph: True)
    assert general(square()).data.sweep.solid == ""


def test_a_mesh_that_is_edited_is_followed(scene):
    model = square()
    ob = general(model)
    select(model)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.transform.resize(value=(2, 2, 2))
    update()
    assert ob.data.sweep.error == "" and extent(ob) == pytest.approx((2, 2, 1))
    ob.data.sweep.general_sweep.trajectory_line_end = (0, 0, 3)  # read without a depsgraph, as the sidebar does
    assert ob.data.sweep.error == "" and extent(ob) == pytest.approx((2, 2, 3))
    bpy.ops.object.mode_set(mode="OBJECT")
    update()
    assert extent(ob) == pytest.approx((2, 2, 3))


def test_shape_keys_of_the_model_are_followed_whoever_asks(scene):
    model = square()
    model.shape_key_add(name="Basis")
    key = model.shape_key_add(name="large")
    for point in key.data:
        point.co *= 2
    ob = general(model)
    key.value = 1.0
    update()
    assert extent(ob) == pytest.approx((2, 2, 1))
    ob.data.sweep.general_sweep.trajectory_line_end = (0, 0, 3)
    assert extent(ob) == pytest.approx((2, 2, 3))

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Machined stock in Blender: a program that people edit, a part of the scene, and what the sidebar tells."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from mathutils import Matrix
from scenes import places, select

import sweep_addon as sw
from sweep_addon.batch import job
from sweep_addon.bridge import objects
from sweep_addon.properties import reading
from sweep_addon.properties.live import rebuild

M = sw.machining
BOX = M.Box(low=(-0.02, -0.02, -0.01), high=(0.02, 0.02, 0.0))
SLOT = "G21 F9\nG0 X-9 Y0 Z5\nG1 Z-2\nX9\nG0 Z5\n"


def stock(program=SLOT, **told):
    return sw.MachinedStock(program, **{"tool": M.FlatEnd(0.006), "stock": BOX, "cell": 0.001} | told)


def deepest(ob):
    """How deep the cut is in the middle of the block, in millimetres."""
    at = places(ob.data)
    return round(-1e3 * at[(np.abs(at[:, :2]) < 1e-6).all(axis=1) & (at[:, 2] > -0.0099), 2].max(), 4)


def attribute(mesh, name):
    values = np.empty(len(mesh.vertices), np.float32)
    mesh.attributes[name].data.foreach_get("value", values)
    return values


def test_a_shape_comes_back_from_its_object(scene):
    shape = stock(tools=[(3, M.Cone())], tool=M.BullNose(0.006, corner=0.002))
    ob = sw.to_object(shape)
    assert sw.from_object(ob) == shape and deepest(ob) == 2
    assert ob.data.sweep.machined_stock.program_text.as_string() == SLOT


def test_parameters_are_live(scene):
    ob = sw.to_object(stock())
    group = ob.data.sweep.machined_stock
    group.stock_box_high = (0.02, 0.02, 0.003)
    assert places(ob.data)[:, 2].max() == pytest.approx(0.003)
    group.tool = "BALL_NOSE"
    assert deepest(ob) == 2 and not ob.data.sweep.error
    assert ob.data.validate() is False  # nothing to mend


def test_an_edited_program_is_read_when_it_has_stood_still(scene):
    ob = sw.to_object(stock())
    ob.data.sweep.machined_stock.program_text.from_string(SLOT.replace("Z-2", "Z-3"))
    reading.watch()
    assert deepest(ob) == 2
    reading.watch()
    assert deepest(ob) == 3


def test_a_mistake_leaves_the_mesh_and_names_the_line(scene):
    ob = sw.to_object(stock())
    ob.data.sweep.machined_stock.program_text.from_string(SLOT + "G33 K2\n")
    rebuild(ob.data)
    assert ob.data.sweep.error == "program: line 6 has G33, a move that the spindle times, which is not read"
    assert deepest(ob) == 2
    ob.data.sweep.machined_stock.program_text.from_string(SLOT.replace("Z-2", "Z-1"))
    rebuild(ob.data)
    assert not ob.data.sweep.error and deepest(ob) == 1


def test_a_deleted_program_is_remembered(scene):
    ob = sw.to_object(stock())
    bpy.data.texts.remove(ob.data.sweep.machined_stock.program_text)
    rebuild(ob.data)
    assert sw.from_object(ob) == stock()
    select(ob)
    bpy.ops.object.sweep_grammar_text_new()
    assert ob.data.sweep.machined_stock.program_text.as_string() == SLOT


def part_of(scene, top):
    data = bpy.data.meshes.new("part")
    block = sw.solids.Block(0.04, 0.04, 0.01 + top).mesh()
    shifted = block.vertices + (0, 0, (top - 0.01) / 2)
    data.from_pydata(shifted.tolist(), [], [face.tolist() for face in block.corners.reshape(-1, 4)])
    ob = bpy.data.objects.new("part", data)
    scene.collection.objects.link(ob)
    return ob


def test_a_mesh_of_the_scene_is_the_part_and_what_is_wrong_is_told(scene):
    part = part_of(scene, -0.0015)
    ob = sw.to_object(stock(), part=part)
    assert ob.parent == part
    told = ob.data.sweep.told.split("\n")
    assert told[0].startswith("The program cuts up to 0.5 mm into the part, ") and ", by lines 3 and 4." in told[0]
    deviation = attribute(ob.data, "deviation")
    assert deviation.min() == pytest.approx(-0.0005, abs=1e-7)
    part.data.transform(Matrix.Translation((0, 0, -0.001)))
    part.data.update()
    part.update_tag()
    bpy.context.view_layer.update()
    assert "into the part" not in ob.data.sweep.told


def test_attributes_are_those_of_the_shape(scene):
    mesh, made = sw.to_object(stock()).data, stock().mesh(np.float32)
    for name in ("depth", "line"):
        assert np.array_equal(attribute(mesh, name), made.attributes[name].astype(np.float32))
    assert mesh.attributes.get("deviation") is None


def test_a_file_keeps_program_and_mesh(scene, tmp_path):
    sw.to_object(stock(), "milled")
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "a.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "a.blend"))
    ob = bpy.data.objects["milled"]
    assert sw.from_object(ob) == stock() and deepest(ob) == 2
    assert ob.data.sweep.machined_stock.program_text.as_string() == SLOT


def test_the_operator_adds_a_rosette(scene):
    bpy.ops.mesh.machined_stock_add(cell=0.001)
    ob = bpy.context.active_object
    assert objects.is_written(ob.data) and not objects.is_grown(ob.data)
    assert sw.from_object(ob) == sw.MachinedStock(cell=0.001)


def test_machined_stock_is_an_operand_of_a_tree(scene):
    drilled = stock() - sw.solids.Cylinder(0.003, 0.1)
    ob = sw.to_object(drilled)
    assert sw.from_object(ob).base == stock()


def test_a_part_in_a_blend_file_is_read_by_a_job(scene, tmp_path):
    part_of(scene, -0.0015)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "part.blend"), copy=True)
    (tmp_path / "part.nc").write_text(SLOT)
    (tmp_path / "job.toml").write_text(
        'kind = "machined-stock"\nprogram = { file = "part.nc" }\ncell = 0.001\n'
        'tool = { kind = "flat-end" }\npart = { file = "part.blend", object = "part" }\n'
        'stock = { kind = "box", low = [-0.02, -0.02, -0.01], high = [0.02, 0.02, 0] }\n'
    )
    found = job.read(tmp_path / "job.toml").shape.verify()
    assert set(found.gouging) == {3, 4} and found.gouge == pytest.approx(0.0005, abs=1e-7)

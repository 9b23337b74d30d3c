# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Find Removal Path: what it makes of objects of a scene, and what it says where there is no path."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")
pytest.importorskip("fcl", reason="removal paths are asked of python-fcl")

from planted_assemblies import bayonet, drawer, shelled
from scenes import add, places, select

import sweep_addon as sw
from sweep_addon.bridge import meshes
from sweep_addon.core.removal import volumes
from sweep_addon.core.solids import Block


def planted(assembly):
    """The objects of a part and of what stays, which are selected, the part active."""
    part, others = assembly
    made = []
    for name, operand in {"part": part, **others}.items():
        data = bpy.data.meshes.new(name)
        meshes.write(data, operand.mesh().astype("f4"))
        made.append(add(name, data))
    select(*made)
    return made


def frames(ob, *numbers):
    """Where an object is at some frames: (n, 4, 4)."""
    found = []
    for number in numbers:
        bpy.context.scene.frame_set(number)
        found.append(np.array(ob.matrix_world))
    return np.array(found)


def test_a_drawer_is_animated_out_of_its_case_and_its_way_drawn(scene):
    part, _ = planted(drawer())
    assert bpy.ops.object.sweep_find_removal_path(frames=10) == {"FINISHED"}
    places_of_part = frames(part, 1, 6, 11, 20)[:, :3, 3]
    assert places_of_part[:, 1] == pytest.approx([0, -0.2002, -0.4004, -0.4004], abs=2e-3)
    assert np.abs(places_of_part[:, [0, 2]]).max() < 1e-6
    volume = bpy.data.objects["part Removal"]
    assert (volume.display_type, volume.hide_render) == ("WIRE", True)
    low, high = places(volume.data).min(axis=0), places(volume.data).max(axis=0)
    assert np.allclose(low, (-0.2, -0.6004, -0.1), atol=2e-3) and np.allclose(high, (0.2, 0.2, 0.1), atol=1e-6)


def test_keys_that_the_part_had_elsewhere_stay_as_they_are(scene):
    part, _ = planted(drawer())
    part.keyframe_insert("location", frame=-20)
    part.keyframe_insert("scale", frame=3)
    (layer,) = part.animation_data.action.layers
    bag = layer.strips[0].channelbag(part.animation_data.action_slot)
    for curve in bag.fcurves:
        curve.keyframe_points[0].interpolation = "CONSTANT"
    assert bpy.ops.object.sweep_find_removal_path(frames=10) == {"FINISHED"}
    kept = [key for curve in bag.fcurves for key in curve.keyframe_points if key.interpolation == "CONSTANT"]
    assert sorted(key.co.x for key in kept) == [-20] * 3 + [3] * 3


def test_objects_are_read_where_they_stand(scene):
    """Moved, turned and mirrored together they come apart along the same way."""
    part, case = planted(drawer())
    for ob in (part, case):
        ob.location, ob.rotation_euler, ob.scale = (1, 2, 3), (0, 0, np.pi / 2), (-2, 2, 2)
    bpy.context.view_layer.update()
    assert bpy.ops.object.sweep_find_removal_path(frames=1) == {"FINISHED"}
    start, end = frames(part, 1, 2)
    assert end[:3, 3] - start[:3, 3] == pytest.approx([0.8, 0, 0], abs=5e-3)  # -y turned to +x, twice as long
    assert np.allclose(end[:3, :3], start[:3, :3], atol=1e-6)


def test_objects_told_in_python_are_refused_with_what_takes_them(scene):
    part, case = planted(drawer())
    shape = Block()
    for told in ((part, [case]), (shape, [case]), (shape, {"case": case}), (shape, case)):
        with pytest.raises(
            sw.ShapeError, match="; sw.from_object reads .* and Find Removal Path takes any meshes, got"
        ):
            sw.removal_path(*told)


def test_a_leg_that_turns_has_a_key_at_each_frame(scene, monkeypatch):
    monkeypatch.setattr(volumes, "CELLS", 16)  # whose finer mesh takes ten seconds
    part, _ = planted(bayonet())
    assert bpy.ops.object.sweep_find_removal_path(frames=8) == {"FINISHED"}
    turned = frames(part, *range(1, 10))
    angles = np.unwrap(np.arctan2(turned[:, 1, 0], turned[:, 0, 0]))
    assert np.allclose(np.diff(angles), angles[-1] / 8, atol=1e-4) and abs(angles[-1]) > 1
    assert len(places(bpy.data.objects["part Removal"].data)) > 100


def test_without_animation_the_part_stays_as_it_is(scene):
    part, _ = planted(drawer())
    assert bpy.ops.object.sweep_find_removal_path(animate=False) == {"FINISHED"}
    assert part.animation_data is None


@pytest.mark.parametrize("alone", [False, True])
def test_where_there_is_no_path_it_is_said_why_and_nothing_is_made(scene, alone):
    """With the part alone selected the others are all visible meshes."""
    part, _ = planted(shelled())
    if alone:
        select(part)
    before = set(bpy.data.objects)
    with pytest.raises(RuntimeError, match="shell encloses the part"):
        bpy.ops.object.sweep_find_removal_path()
    assert set(bpy.data.objects) == before and part.animation_data is None


def test_a_mesh_that_is_open_is_refused(scene):
    part, case = planted(drawer())
    data = bpy.data.meshes.new("sheet")
    data.from_pydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [], [(0, 1, 2)])
    select(case, add("sheet", data))
    with pytest.raises(RuntimeError, match="must be closed"):
        bpy.ops.object.sweep_find_removal_path()


def test_it_needs_an_active_mesh_and_another_one(scene):
    part, case = planted(drawer())
    bpy.data.objects.remove(case)
    select(part)
    with pytest.raises(RuntimeError, match="must have at least one"):
        bpy.ops.object.sweep_find_removal_path()
    part.select_set(False)
    bpy.context.view_layer.objects.active = None
    assert not bpy.ops.object.sweep_find_removal_path.poll()

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A drawer is taken out of its case by one click, undone by one step, and a search that lasts is stopped by Esc."""

import bpy
from _window import run

from bl_ext.user_default import sweep_addon as sw
from bl_ext.user_default.sweep_addon.sweep_addon.bridge import meshes

FIND = (0.4, 73)  # read off pictures


def linked(name, operand):
    data = bpy.data.meshes.new(name)
    meshes.write(data, operand.mesh().astype("f4"))
    ob = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(ob)
    ob.select_set(True)
    return ob


def removal(person):
    yield 0.5
    bpy.data.batch_remove(list(bpy.data.objects))
    block, ball = sw.solids.Block, sw.solids.Ball
    linked("case", block(3.0, 2.5, 2.0).moved(y=0.25) - block(2.0, 2.5, 1.0).moved(y=-0.25))
    drawer = linked("drawer", block(2.0, 2.0, 1.0))
    bpy.context.view_layer.objects.active = drawer
    yield from person.open_sidebar("Sweep")
    yield from person.over_view()
    yield from person.picture("removal-1-assembly")
    bpy.ops.ed.undo_push(message="Drawer")
    yield from person.click(*person.top(*FIND))
    for _ in range(100):
        yield 0.1
        if "drawer Removal" in bpy.data.objects:
            break
    assert "drawer Removal" in bpy.data.objects
    bpy.context.scene.frame_set(25)
    assert drawer.location.y < -1.9
    yield from person.over_view()
    yield from person.picture("removal-2-out")
    yield from person.undo()
    assert set(bpy.data.objects.keys()) == {"case", "drawer"}
    assert bpy.data.objects["drawer"].animation_data is None

    bpy.data.batch_remove(list(bpy.data.objects))
    bars = block(1.0, 1.0, 1.0) - block(0.9, 0.9, 0.9)
    linked("cage", bars - block(2.0, 0.5, 0.5) - block(0.5, 2.0, 0.5) - block(0.5, 0.5, 2.0))
    bpy.context.view_layer.objects.active = linked("ball", ball(0.3))
    yield 0.5
    yield from person.click(*person.top(*FIND))
    yield 0.5
    yield from person.press("ESC")
    yield 1.0
    assert set(bpy.data.objects.keys()) == {"cage", "ball"}
    yield from person.picture("removal-3-stopped")


run(removal)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of Convert to Sweep: a curve with a bevel as Blender draws it, and the sweep that it becomes.

Run by `scripts/gallery` in Blender: convert.py -- PICTURE.
"""

import sys
from pathlib import Path

import bpy

from bl_ext.user_default.sweep_addon.sweep_addon.batch import scene, studio
from bl_ext.user_default.sweep_addon.sweep_addon.batch.job import Render

RENDER = Render(width=1200, height=480, azimuth=-1.35, elevation=0.7, margin=0.03, samples=64)
BEFORE = Render(side=(0.45, 0.47, 0.5), caps=(0.45, 0.47, 0.5))
PATH = [(0, 0.9, 0), (0, 0, 0), (1.1, 0.9, 0), (1.2, 0, 0), (2.3, 0, 0), (2.3, 0, 0.8)]
PROFILE = [(0.11, 0.11, 0), (-0.11, 0.11, 0), (-0.11, -0.11, 0), (0.11, -0.11, 0)]
APART = 3.2


def curve(name, points, closed=False):
    data = bpy.data.curves.new(name, "CURVE")
    data.dimensions = "2D" if closed else "3D"
    spline = data.splines.new("POLY")
    spline.points.add(len(points) - 1)
    for point, place in zip(spline.points, points, strict=True):
        point.co = (*place, 1)
    spline.use_cyclic_u = closed
    ob = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(ob)
    return ob


def main(picture):
    scene.empty()
    path, profile = curve("Path", PATH), curve("Profile", PROFILE, closed=True)
    path.data.bevel_mode, path.data.bevel_object, path.data.use_fill_caps = "OBJECT", profile, True
    drawn = bpy.data.meshes.new_from_object(path.evaluated_get(bpy.context.evaluated_depsgraph_get()))
    before = bpy.data.objects.new("Before", drawn)
    bpy.context.scene.collection.objects.link(before)

    bpy.context.view_layer.objects.active = path
    path.select_set(True)
    bpy.ops.object.sweep_convert()
    after = bpy.context.active_object
    path.location.x = APART
    studio.paint(before.data, BEFORE)
    studio.paint(after.data, RENDER)
    scene.stage([before, after], RENDER)
    profile.hide_render = True
    scene.render_picture(RENDER, picture)


main(Path(sys.argv[sys.argv.index("--") + 1]))

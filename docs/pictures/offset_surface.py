# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of offset surfaces: a drilled block and its offsets outside, inside and on both sides, cut open.

Run by `scripts/gallery` in Blender: offset_surface.py -- PICTURE.
"""

import sys
from pathlib import Path

import bpy
import numpy as np

from bl_ext.user_default import sweep_addon as sw
from bl_ext.user_default.sweep_addon.sweep_addon.batch import scene, studio
from bl_ext.user_default.sweep_addon.sweep_addon.batch.job import Render
from bl_ext.user_default.sweep_addon.sweep_addon.core.meshes.booleans import body_of, combined, mesh_of
from bl_ext.user_default.sweep_addon.sweep_addon.core.solids import Block, DrilledBlock

RENDER = Render(width=1000, height=360, azimuth=-1.2, elevation=0.75, margin=0.03, samples=24)
SOLID = Render(side=(0.16, 0.42, 0.66), caps=(0.16, 0.42, 0.66))
BLOCK, APART = DrilledBlock(1.0, 1.0, 0.6, radius=0.2, points=96), 1.75
SHOWN = ((0.15, "outside"), (0.08, "inside"), (0.08, "shell"), (0.3, "outside"))


def main(picture):
    scene.empty()
    shown = []
    for place, (radius, side) in enumerate(SHOWN):
        offset = sw.OffsetSurface(BLOCK, radius, side, tolerance=radius / 60, engine="rounded-faces").mesh()
        block = BLOCK.mesh()
        if side == "inside":
            block = without_a_corner(block)
        else:
            offset = without_a_corner(offset)
        parts = [(offset, RENDER)] if side == "shell" else [(offset, RENDER), (block, SOLID)]
        for mesh, look in parts:
            shown.append(placed(mesh, APART * place))
            studio.paint(shown[-1].data, look)
    scene.stage(shown, RENDER)
    scene.render_picture(RENDER, picture)


def without_a_corner(mesh):
    """A solid without what is in front of its middle on the right."""
    cutter = Block(4.0, 4.0, 4.0).mesh()
    cutter = type(cutter)(cutter.vertices + (2.0, -2.0, 0.0), cutter.topology)
    return mesh_of(combined("difference", body_of(mesh), body_of(cutter)))


def placed(mesh, x):
    """An object of a mesh, moved along x."""
    data = bpy.data.meshes.new("Offset")
    faces = np.split(mesh.corners, mesh.offsets[1:-1])
    data.from_pydata(mesh.vertices + (x, 0, 0), [], [face.tolist() for face in faces])
    data.polygons.foreach_set("use_smooth", np.ones(len(data.polygons), dtype=bool))
    data.set_sharp_from_angle(angle=0.5)
    ob = bpy.data.objects.new("Offset", data)
    bpy.context.scene.collection.objects.link(ob)
    return ob


main(Path(sys.argv[sys.argv.index("--") + 1]))

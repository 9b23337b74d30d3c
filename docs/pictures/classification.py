# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of the lecture's whole classification of sweeps: a row of each kind of generator, each sweep labelled.

Run by `scripts/gallery` in Blender: classification.py -- PICTURE.
"""

import sys
from math import pi
from pathlib import Path

import bpy
import numpy as np
from mathutils import Matrix

from bl_ext.user_default import sweep_addon as sw
from bl_ext.user_default.sweep_addon.sweep_addon import presets
from bl_ext.user_default.sweep_addon.sweep_addon.batch import scene, studio
from bl_ext.user_default.sweep_addon.sweep_addon.batch.job import Render
from bl_ext.user_default.sweep_addon.sweep_addon.bridge import meshes

RENDER = Render(width=1400, height=1300, azimuth=-pi / 2, elevation=0.95, margin=0.02, samples=32)
DARK = Render(side=(0.10, 0.12, 0.16), caps=(0.10, 0.12, 0.16))
COLUMN, ROW, SIZE, TALL, HEAD = 1.5, 2.2, 1.05, 0.85, 0.2
STAR = sw.contours.Star(5, 0.5, 0.25)
RING = sw.trajectories.Arc(5.0, 2 * pi)
ROWS = {
    "Planar generator": {
        "translational": sw.TranslationalSweep(STAR, height=0.4, taper=0.3),
        "rotational": sw.RotationalSweep(sw.contours.Star(5, 0.3, 0.15), angle=4.7, axis_point=(-0.6, 0)),
        "PD curve": sw.PDCurveSweep(sw.contours.Star(5, 0.2, 0.1)),
        "generalized cylinder": sw.GeneralizedCylinder(
            sw.contours.Star(5, 0.3, 0.15), sw.trajectories.TorusKnot(2, 3, 1.0, 0.4), scale_x=0.8, scale_y=0.8
        ),
    },
    "Solid generator": {
        "canal surface, of a disc": sw.CanalSurface(RING, 1.0, generator="disc", make_solid=True),
        "of a ball": sw.CanalSurface(sw.trajectories.Helix(0.5, 0.35, 2.0), "0.1 + 0.05*sin(6*pi*t)"),
        "offset surface, of a disc": sw.TranslationalSweep(sw.contours.offset(STAR, 0.12), height=0.02),
        "of a ball ": sw.OffsetSurface(sw.solids.Bracket(0.8, 0.8, 0.25, 0.4), 0.12),
    },
    "General sweeping": {
        "by a cylinder": presets.shape("general_sweep_by_a_cylinder"),
        "by a CSG solid": presets.shape("general_sweep_by_a_csg_solid"),
        "L-bracket, sinusoidal": presets.shape("general_sweep_l_bracket"),
        "changing topology": presets.shape("general_sweep_parting_loop"),
    },
}


def drawn(name, faces, place, look):
    """A mesh of arrays, painted, at a place."""
    mesh = bpy.data.meshes.new(name)
    meshes.write(mesh, faces)
    studio.paint(mesh, look)
    ob = studio.linked(bpy.context.scene, name, mesh)
    ob.matrix_world = place
    return ob


def label(text, middle, size, align="CENTER"):
    """A text that lies on the ground."""
    data = bpy.data.curves.new("label", "FONT")
    data.body, data.size, data.align_x = text, size, align
    ob = studio.linked(bpy.context.scene, "text", data)
    bpy.context.view_layer.update()
    mesh = bpy.data.meshes.new_from_object(ob)
    bpy.data.objects.remove(ob)
    studio.paint(mesh, DARK)
    lying = studio.linked(bpy.context.scene, "label", mesh)
    lying.location = middle
    return lying


def main(picture):
    scene.empty()
    shown = []
    for row, (kind, sweeps) in enumerate(ROWS.items()):
        shown.append(label(kind, (-0.5 * COLUMN, 0.96 - ROW * row, 0.002), HEAD, "LEFT"))
        for column, (name, shape) in enumerate(sweeps.items()):
            mesh = shape.mesh()
            low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
            scale = SIZE / np.ptp(mesh.vertices, axis=0)[:2].max()
            scale = min(scale, TALL / max(high[2] - low[2], 1e-9))
            middle = np.array((COLUMN * column, -ROW * row, 0.0))
            moved = middle - scale * np.array((*(low + high)[:2] / 2, low[2])) + (0, 0, 0.004)
            shown.append(drawn(name, mesh, Matrix.Translation(moved) @ Matrix.Scale(scale, 4), RENDER))
            shown.append(label(name.strip(), (middle[0], middle[1] - 0.8, 0.002), 0.135))
    bpy.context.view_layer.update()
    scene.stage(shown, RENDER)
    scene.render_picture(RENDER, picture)


main(Path(sys.argv[sys.argv.index("--") + 1]))

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of the lecture's six sweeps of mixed dimension, (a) to (f).

A render shows faces alone: loose edges and points are drawn here, dark, as thin tubes and balls, and so are, red, what
is singular. They are of the picture and not of the meshes.

Run by `scripts/gallery` in Blender: mixed_dimension.py -- PICTURE.
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

RENDER = Render(width=1200, height=740, azimuth=-pi / 2, elevation=0.55, margin=0.02, samples=64)
DARK = Render(side=(0.10, 0.12, 0.16), caps=(0.10, 0.12, 0.16))
RED = Render(side=(0.85, 0.08, 0.10), caps=(0.85, 0.08, 0.10))
SIX = "dangling_edges", "joined_by_an_edge", "dangling_faces", "every_dimension", "singular_point", "non_manifold_edge"
LYING = "dangling_faces"  # the only one whose plane is the ground; the others stand in theirs
COLUMN, ROW, THICK, BALL = 2.9, 5.2, 0.022, 0.05


def drawn(name, faces, place, look):
    """A mesh of arrays, painted, at a place."""
    mesh = bpy.data.meshes.new(name)
    meshes.write(mesh, faces)
    studio.paint(mesh, look)
    ob = studio.linked(bpy.context.scene, name, mesh)
    ob.matrix_world = place
    return ob


def marks(mesh, place):
    """Tubes for edges and balls for points: dark what is loose, red what is singular."""
    found = mesh.dimensions()
    loose = np.setdiff1d(np.arange(len(mesh.edges)), mesh.topology.corner_edges)
    points = np.setdiff1d(np.arange(len(mesh.vertices)), mesh.edges)
    for edges, balls, look in (
        (mesh.edges[loose], points, DARK),
        (found.non_manifold_edges, found.singular_points, RED),
    ):
        ends = mesh.vertices[edges]
        for start, end in ends:
            tube = sw.GeneralizedCylinder(
                sw.contours.Circle(THICK, 16), sw.trajectories.Line(start, end), start="round", end="round"
            )
            yield drawn("edge", tube.mesh(), place, look)
        half = sw.contours.Outline([[(0, -BALL), (0, BALL)]], bulges=[(1, 0)], tolerance=0.0005)
        for point in mesh.vertices[balls]:
            yield drawn("point", sw.RotationalSweep(half).mesh(), place @ Matrix.Translation(point), look)


def label(text, middle):
    """A letter that lies on the ground."""
    data = bpy.data.curves.new("label", "FONT")
    data.body, data.size, data.align_x = text, 0.42, "CENTER"
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
    for number, name in enumerate(SIX):
        shape = presets.shape(f"mixed_dimension_{name}")
        turn = Matrix.Rotation(-0.5, 4, "Z") if name == LYING else Matrix.Rotation(pi / 2, 4, "X")
        mesh = shape.mesh()
        turned = mesh.vertices @ np.array(turn.to_3x3()).T
        low, high = turned.min(axis=0), turned.max(axis=0)
        middle = (COLUMN * (number % 3), -ROW * (number // 3), 0.0)
        place = Matrix.Translation((*(middle - (low + high) / 2)[:2], 0.03 - low[2])) @ turn
        shown += [drawn(name, mesh, place, RENDER), *marks(mesh, place)]
        shown.append(label(f"({'abcdef'[number]})", (middle[0], middle[1] - (high - low)[1] / 2 - 0.5, 0.002)))
    bpy.context.view_layer.update()
    scene.stage(shown, RENDER)
    scene.render_picture(RENDER, picture)


main(Path(sys.argv[sys.argv.index("--") + 1]))

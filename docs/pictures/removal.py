# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of removal paths: three assemblies, and below each what must stay empty so that its part gets out.

Run by `scripts/gallery` in Blender: removal.py -- PICTURE.
"""

import sys
from math import cos, sin
from pathlib import Path

import bpy
from mathutils import Matrix

from bl_ext.user_default import sweep_addon as sw
from bl_ext.user_default.sweep_addon.sweep_addon.batch import scene, studio
from bl_ext.user_default.sweep_addon.sweep_addon.batch.job import Render
from bl_ext.user_default.sweep_addon.sweep_addon.bridge import meshes

RENDER = Render(width=1000, height=700, azimuth=-1.1, elevation=0.62, margin=0.03, samples=64)
COLUMN, ROW = 2.2, 2.4
LOOKS = {
    "stays": Render(side=(0.62, 0.64, 0.67), caps=(0.62, 0.64, 0.67)),
    "part": Render(side=(0.12, 0.30, 0.52), caps=(0.20, 0.42, 0.68)),
    "empty": Render(side=(0.62, 0.24, 0.10), caps=(0.80, 0.36, 0.16)),
}
Block, Cylinder = sw.solids.Block, sw.solids.Cylinder


def drawer():
    case = Block(1.0, 0.9, 0.7).moved(y=0.05, z=0.35) - Block(0.8, 0.9, 0.5).moved(y=-0.05, z=0.35)
    return Block(0.8, 0.8, 0.5).moved(z=0.35) - Block(0.7, 0.7, 0.5).moved(z=0.42), case


def bayonet():
    plug = Cylinder(0.24, 1.3).moved(z=0.15) | Block(0.72, 0.12, 0.12)
    socket = Cylinder(0.55, 0.7) - Cylinder(0.25, 2.0) - Cylinder(0.39, 0.22)
    turn = ((cos(1.2), -sin(1.2), 0, 0), (sin(1.2), cos(1.2), 0, 0), (0, 0, 1, 0.5))
    return plug.moved(z=0.5), sw.Placed(socket - sw.Placed(Block(0.78, 0.15, 1.0), turn), RAISED)


def curved_tube():
    tube, sleeve, hole = (
        sw.GeneralizedCylinder(sw.contours.Circle(radius, points=24), sw.trajectories.Arc(0.9, angle))
        for radius, angle in ((0.14, 1.6), (0.24, 1.3), (0.15, 1.7))
    )
    return sw.Placed(tube, UPRIGHT), sw.Placed(sleeve - hole, UPRIGHT)


RAISED = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0.5))
UPRIGHT = ((1, 0, 0, -0.6), (0, 0, -1, 0), (0, 1, 0, 0.1))  # the arc stands on the ground


def drawn(name, mesh, place):
    """A mesh of the library, painted, with its origin at a place."""
    data = bpy.data.meshes.new(name)
    meshes.write(data, mesh)
    studio.paint(data, LOOKS[name])
    ob = studio.linked(bpy.context.scene, name, data)
    ob.matrix_world = Matrix.Translation(place)
    return ob


def main(picture):
    scene.empty()
    shown = []
    for column, (part, other) in enumerate((drawer(), bayonet(), curved_tube())):
        path = sw.removal_path(part, [other])
        shown += [drawn("stays", other.mesh(), (COLUMN * column, -ROW * row, 0)) for row in (0, 1)]
        shown.append(drawn("part", part.mesh(), (COLUMN * column, 0, 0)))
        shown.append(drawn("empty", path.swept().mesh(), (COLUMN * column, -ROW, 0)))
    bpy.context.view_layer.update()
    scene.stage(shown, RENDER)
    scene.render_picture(RENDER, picture)


main(Path(sys.argv[sys.argv.index("--") + 1]))

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of Sweep-to-CSG conversion: an outline taken apart step by step, and the solid of the tree.

Run by `scripts/gallery` in Blender: sweep_to_csg.py -- PICTURE.
"""

import sys
from math import pi
from pathlib import Path

import bpy
from mathutils import Matrix

from bl_ext.user_default import sweep_addon as sw
from bl_ext.user_default.sweep_addon.sweep_addon.batch import scene, studio
from bl_ext.user_default.sweep_addon.sweep_addon.batch.job import Render
from bl_ext.user_default.sweep_addon.sweep_addon.bridge import meshes
from bl_ext.user_default.sweep_addon.sweep_addon.core.conversion import decompose

RENDER = Render(width=1000, height=840, azimuth=-pi / 2, elevation=1.1, margin=0.02, samples=64)
HEIGHT, COLUMN, ROW, COLUMNS = 0.5, 8.4, 7.6, 3
LOOKS = {
    "outline": Render(side=(0.62, 0.64, 0.67), caps=(0.62, 0.64, 0.67)),
    "union": Render(side=(0.16, 0.42, 0.24), caps=(0.24, 0.56, 0.34)),
    "difference": Render(side=(0.62, 0.24, 0.10), caps=(0.80, 0.36, 0.16)),
    "start": Render(side=(0.12, 0.30, 0.52), caps=(0.20, 0.42, 0.68)),
    "text": Render(side=(0.10, 0.12, 0.16), caps=(0.10, 0.12, 0.16)),
}
SIGNS = {"union": "+", "difference": "-", "start": "="}
FILLET = 2**0.5 - 1  # the tangent of a quarter of a right angle
PART = [
    (0, 0, 0), (1.4, 0, 0), (1.9, 0.6, 0), (2.4, 0, 0), (5.2, 0, FILLET), (6, 0.8, 0), (6, 2, 0), (4.8, 2, -FILLET),
    (4.2, 2.6, 0), (4.2, 4, 0), (3, 4, -1), (1.8, 4, 0), (0, 4, 0), (0, 3.2, 0), (-0.8, 3.2, 1), (-0.8, 2.2, 0),
    (0, 2.2, 0),
]  # fmt: skip


def drawn(name, mesh, look, place):
    """A mesh of the library, painted, with its origin at a place."""
    data = bpy.data.meshes.new(name)
    meshes.write(data, mesh)
    studio.paint(data, LOOKS[look])
    ob = studio.linked(bpy.context.scene, name, data)
    ob.matrix_world = Matrix.Translation(place)
    return ob


def label(text, place):
    """A text that lies on the ground."""
    data = bpy.data.curves.new("label", "FONT")
    data.body, data.size, data.align_x = text, 0.62, "CENTER"
    ob = studio.linked(bpy.context.scene, "text", data)
    bpy.context.view_layer.update()
    mesh = bpy.data.meshes.new_from_object(ob)
    bpy.data.objects.remove(ob)
    studio.paint(mesh, LOOKS["text"])
    lying = studio.linked(bpy.context.scene, "label", mesh)
    lying.location = place
    return lying


def extruded(outline):
    return sw.TranslationalSweep(outline, HEIGHT)


def series():
    """What each cell shows: parts, each an extrusion and its look, and a line below."""
    corners, bulges = [(x, y) for x, y, _ in PART], [bulge for *_, bulge in PART]
    before = sw.contours.Outline([corners], [bulges])
    for number, step in enumerate(decompose(corners, bulges).steps, 1):
        parts = [(extruded(step.primitive.outline), step.operation)]
        if step.operation != "start":
            parts.append((extruded(before if step.operation == "difference" else step.outline), "outline"))
        yield parts, f"{number}   {SIGNS[step.operation]} {step.primitive.kind}"
        before = step.outline
    yield [(sw.sweep_to_csg(extruded(sw.contours.Outline([corners], [bulges]))), "outline")], "the tree, evaluated"


def main(picture):
    scene.empty()
    shown = []
    for number, (parts, line) in enumerate(series()):
        row, column = divmod(number, COLUMNS)
        place = (COLUMN * column, -ROW * row, 0.0)
        shown += [drawn(line, shape.mesh(), look, place) for shape, look in parts]
        shown.append(label(line, (place[0] + 2.6, place[1] - 1.3, 0.002)))
    bpy.context.view_layer.update()
    scene.stage(shown, RENDER)
    scene.render_picture(RENDER, picture)


main(Path(sys.argv[sys.argv.index("--") + 1]))

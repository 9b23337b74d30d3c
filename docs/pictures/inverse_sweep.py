# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The lecture's figure of inverse sweeping: the contour's planes that pass through a point, and what it goes back to.

Run by `scripts/gallery` in Blender: inverse_sweep.py -- PICTURE.
"""

import sys
from dataclasses import replace
from math import pi
from pathlib import Path

import bpy
import numpy as np
from mathutils import Matrix

from bl_ext.user_default import sweep_addon as sw
from bl_ext.user_default.sweep_addon.sweep_addon.batch import scene, studio
from bl_ext.user_default.sweep_addon.sweep_addon.batch.job import Render
from bl_ext.user_default.sweep_addon.sweep_addon.bridge import meshes
from bl_ext.user_default.sweep_addon.sweep_addon.core.membership.members import member

RENDER = Render(width=1200, height=470, azimuth=-pi / 2, elevation=0.95, margin=0.02, samples=48)
CONTOUR = sw.contours.Rectangle(0.5, 0.36, rounding=0.1)
LOOP = sw.trajectories.Formula("0.85*(u^2 - 1)", "1.1*u*(u^2 - 1)", "0.4", start=-1.28, end=1.28)
SWEEP = sw.GeneralizedCylinder(CONTOUR, LOOP, {"kind": "tolerance", "chord": 1e-4}, frame="fixed-up")
MADE_AT, MADE_OF = -1.01, (-0.25, 0.05)  # the point lies on the contour where it stands there
DARK, RED = (0.10, 0.12, 0.16), (0.85, 0.08, 0.10)
COLOURS = {1: (0.10, 0.35, 0.75), 0: (0.90, 0.45, 0.05), -1: (0.40, 0.42, 0.45)}
WORDS = {1: "in", 0: "on", -1: "out"}
ASIDE = {
    "in": ((0.0, -0.27, 0.02), "CENTER"),
    "on": ((-0.1, -0.06, 0.02), "RIGHT"),
    "out": ((0.1, -0.06, 0.02), "LEFT"),
}
NUMBERS = (-0.33, -0.22, 0.2), (0.0, 0.0, 0.33), (0.0, 0.05, 0.36)  # where each is, from the middle of its contour
SCALE, PANEL = 1.55, np.array((1.65, 0.0, 0.01))


def drawn(name, faces, place, colour, alpha=1.0):
    """A mesh of arrays in one colour, at a place."""
    mesh = bpy.data.meshes.new(name)
    meshes.write(mesh, faces)
    studio.paint(mesh, replace(RENDER, side=colour, caps=colour))
    if alpha < 1:
        for material in mesh.materials:
            studio.tree(material).nodes["Principled BSDF"].inputs["Alpha"].default_value = alpha
    ob = studio.linked(bpy.context.scene, name, mesh)
    ob.matrix_world = place
    return ob


def label(text, place, size=0.2, align="LEFT"):
    """A text that lies on the ground."""
    data = bpy.data.curves.new("label", "FONT")
    data.body, data.size, data.align_x = text, size, align
    ob = studio.linked(bpy.context.scene, "text", data)
    bpy.context.view_layer.update()
    mesh = bpy.data.meshes.new_from_object(ob)
    bpy.data.objects.remove(ob)
    studio.paint(mesh, replace(RENDER, side=DARK, caps=DARK, roughness=1.0))
    lying = studio.linked(bpy.context.scene, "label", mesh)
    lying.location = place
    return lying


def ball(place, colour, radius):
    return drawn("ball", sw.solids.Ball(radius, 32).mesh(), Matrix.Translation(place), colour)


def standing(u):
    """Where the contour's origin and its axes are at parameters (n,): three (n, 3)."""
    s = [sw.trajectories.Formula(LOOP.x, LOOP.y, LOOP.z, LOOP.start, each).length() for each in u]
    at = member(SWEEP).plane.way.carried(np.append(0.0, s))
    return at.middle[1:], at.x[1:], at.y[1:]


def main(picture):
    scene.empty()
    upright = Matrix.Identity(4)
    (middle,), (x,), (y,) = standing([MADE_AT])
    point = middle + MADE_OF[0] * x + MADE_OF[1] * y
    found = sw.inverse_sweep(SWEEP, [point])
    flat = sw.TranslationalSweep(CONTOUR, 0.02)
    height = np.full(len(found.u), 0.01)
    told = sw.classify(flat, np.column_stack((found.images, height)), tolerance=1e-6)
    shown = [drawn("sweep", SWEEP.mesh(), upright, (0.95, 0.75, 0.62), 0.16)]
    rod = sw.GeneralizedCylinder(sw.contours.Circle(0.012, 16), LOOP, {"kind": "tolerance", "chord": 1e-4})
    shown += [drawn("trajectory", rod.mesh(), upright, DARK), ball(point, RED, 0.05)]
    plate = sw.TranslationalSweep(CONTOUR, 0.012, "symmetric").mesh()
    shown.append(label("P", point + (0.09, -0.02, 0.2)))
    for number, (middle, x, y, label_of) in enumerate(zip(*standing(found.u), told, strict=True)):
        place = Matrix(np.vstack((np.column_stack((x, y, np.cross(x, y), middle)), (0, 0, 0, 1))).tolist())
        colour = COLOURS[int(label_of)]
        shown.append(drawn("contour", plate, place, colour, 0.85))
        line = sw.GeneralizedCylinder(sw.contours.Circle(0.01, 12), sw.trajectories.Line(middle, point))
        shown.append(drawn("line", line.mesh(), upright, colour))
        shown.append(label(str(number + 1), middle + NUMBERS[number], align="CENTER"))
    panel = Matrix.Translation(PANEL) @ Matrix.Scale(SCALE, 4)
    shown.append(drawn("contour", flat.mesh(), panel, RENDER.caps))
    for number, (x, y) in enumerate(found.images):
        place = PANEL + SCALE * np.array((x, y, 0.02))
        colour = COLOURS[int(told[number])]
        shown.append(ball(place, colour, 0.055))
        word = WORDS[int(told[number])]
        aside, align = ASIDE[word]
        shown.append(label(f"Q{number + 1} {word}", place + aside, align=align))
    bpy.context.view_layer.update()
    scene.stage(shown, RENDER)
    scene.render_picture(RENDER, picture)


main(Path(sys.argv[sys.argv.index("--") + 1]))

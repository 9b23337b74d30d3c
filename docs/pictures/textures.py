# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of the textures: one horn with its texture in true lengths and from 0 to 1, the same checks on both.

Run by `scripts/gallery` in Blender: textures.py -- PICTURE.
"""

import sys
from pathlib import Path

import bpy

from bl_ext.user_default import sweep_addon as sw
from bl_ext.user_default.sweep_addon.sweep_addon.batch import scene, studio
from bl_ext.user_default.sweep_addon.sweep_addon.batch.job import Render

RENDER = Render(width=1200, height=480, azimuth=-1.35, elevation=0.5, margin=0.03, samples=64)
CHECKS = {"lengths": 1 / 0.15, "unit": 12}  # to a metre; in all
APART = 3.4


def horn(texture):
    path = sw.trajectories.Bezier([(0, 0, 0.5), (1.0, -1.2, 0.5), (1.7, 1.3, 0.6), (2.6, 0.1, 0.4)])
    return sw.GeneralizedCylinder(
        sw.contours.Rectangle(0.8, 0.8, rounding=0.2),
        path,
        scale_x="1 - 0.6*t",
        scale_y="1 - 0.6*t",
        texture=texture,
    )


def checked(scale, look):
    """A material of checks."""
    material = bpy.data.materials.new("Checks")
    nodes, links = studio.tree(material).nodes, studio.tree(material).links
    places, checks = nodes.new("ShaderNodeTexCoord"), nodes.new("ShaderNodeTexChecker")
    checks.inputs["Scale"].default_value = scale
    for name, colour in (("Color1", look.side), ("Color2", look.caps)):
        checks.inputs[name].default_value = (*studio.linear(colour), 1.0)
    surface = nodes["Principled BSDF"].inputs
    surface["Roughness"].default_value = look.roughness
    links.new(places.outputs["UV"], checks.inputs["Vector"])
    links.new(checks.outputs["Color"], surface["Base Color"])
    return material


def main(picture):
    scene.empty()
    shown = []
    for place, (texture, scale) in enumerate(CHECKS.items()):
        ob = sw.to_object(horn(texture), texture)
        ob.location.x = place * APART
        material = checked(scale, RENDER)
        for slot in range(2):
            ob.data.materials[slot] = material
        shown.append(ob)
    scene.stage(shown, RENDER)
    scene.render_picture(RENDER, picture)


main(Path(sys.argv[sys.argv.index("--") + 1]))

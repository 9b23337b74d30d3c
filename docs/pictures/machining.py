# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of machining: a real program's relief, and the same with a groove that it should not have, in red.

Run by `scripts/gallery` in Blender: machining.py -- PICTURE.
"""

import gzip
import sys
from dataclasses import replace
from pathlib import Path

import bpy
import numpy as np

from bl_ext.user_default import sweep_addon as sw
from bl_ext.user_default.sweep_addon.sweep_addon.batch import scene, studio
from bl_ext.user_default.sweep_addon.sweep_addon.batch.job import Render

RENDER = Render(width=1200, height=520, azimuth=-np.pi / 2, elevation=0.95, margin=0.02, samples=64,
                side=(0.66, 0.70, 0.73))  # fmt: skip
PROGRAM = Path(__file__).resolve().parents[2] / "tests" / "data" / "gcode" / "camotics_flower_mold.nc.gz"
TOOL = sw.machining.BallNose(diameter=0.0015875)
STOCK = sw.machining.Box(low=(-0.002, -0.002, -0.012), high=(0.0591, 0.0591, 0.0))
GROOVE = "G0 Z0.2\nX0.5 Y0.4\nG1 Z-0.34 F8\nX1.75 Y1.85\nG0 Z0.2\n"  # of a wrong program, in inches
FULL = 0.00025  # metres of deviation that are full red


def by_deviation(look):
    """A material whose colour tells how deep the part is cut into."""
    material = bpy.data.materials.new("Deviation")
    nodes, links = studio.tree(material).nodes, studio.tree(material).links
    told, scaled, colours = (nodes.new(f"ShaderNode{kind}") for kind in ("Attribute", "MapRange", "Mix"))
    told.attribute_name, colours.data_type = "deviation", "RGBA"
    for name, value in {"From Min": 0.0, "From Max": -FULL, "To Min": 0.0, "To Max": 1.0}.items():
        scaled.inputs[name].default_value = value
    ends = [socket for socket in colours.inputs if socket.type == "RGBA"]
    for socket, colour in zip(ends, (look.side, (0.85, 0.08, 0.06)), strict=True):
        socket.default_value = (*studio.linear(colour), 1.0)
    links.new(told.outputs["Fac"], scaled.inputs["Value"])
    links.new(scaled.outputs["Result"], colours.inputs[0])
    surface = nodes["Principled BSDF"].inputs
    surface["Roughness"].default_value = look.roughness
    mixed = next(socket for socket in colours.outputs if socket.type == "RGBA")
    links.new(mixed, surface["Base Color"])
    return material


def main(picture):
    scene.empty()
    text = gzip.open(PROGRAM, "rt").read()
    right = sw.MachinedStock(text, tool=TOOL, stock=STOCK, cell=0.00012)
    last = text.rindex("G0")
    part = sw.solids.Triangles.of(right.mesh())
    wrong = replace(right, program=text[:last] + GROOVE + text[last:], part=part)
    shown = []
    for number, stock in enumerate((right, wrong)):
        ob = sw.to_object(stock, f"stock {number}")
        studio.paint(ob.data, RENDER)
        if stock is wrong:
            ob.data.materials[0] = by_deviation(RENDER)
        ob.location.x = 0.07 * number
        shown.append(ob)
    bpy.context.view_layer.update()
    scene.stage(shown, RENDER)
    scene.render_picture(RENDER, picture)


main(Path(sys.argv[sys.argv.index("--") + 1]))

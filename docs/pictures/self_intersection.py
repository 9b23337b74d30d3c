# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of self-intersection: a clean loop, one too thick for its crossing, and a bend too tight, faces marked.

Run by `scripts/gallery` in Blender: self_intersection.py -- PICTURE.
"""

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

from bl_ext.user_default import sweep_addon as sw
from bl_ext.user_default.sweep_addon.sweep_addon.batch import scene, studio
from bl_ext.user_default.sweep_addon.sweep_addon.batch.job import Render
from bl_ext.user_default.sweep_addon.sweep_addon.bridge import crossings

RENDER = Render(width=1200, height=440, azimuth=-np.pi / 2, elevation=1.15, margin=0.03, samples=64)
MARKED = replace(RENDER, side=(0.16, 0.42, 0.66))
LOOP = sw.trajectories.Formula("1.4*sin(u)", "1.2*sin(u)*cos(u)", "0.15*cos(u)", start=0.0, end=2 * np.pi)
BEND = sw.trajectories.Formula("u", "0.9 - 1.6*u^2", "0", start=-1.0, end=1.0)
SAMPLES = {"kind": "tolerance", "chord": 1e-4}


def main(picture):
    scene.empty()
    shown = []
    for place, (radius, path) in enumerate(((0.14, LOOP), (0.29, LOOP), (0.45, BEND))):
        ob = sw.to_object(sw.GeneralizedCylinder(sw.contours.Circle(radius, 96), path, SAMPLES), f"tube {place}")
        mesh = ob.data
        studio.paint(mesh, RENDER)
        sides = mesh.materials[:]
        studio.paint(mesh, MARKED)
        mesh.materials.append(mesh.materials[0])
        mesh.materials[0], mesh.materials[1] = sides
        materials = np.empty(len(mesh.polygons), np.int32)
        mesh.polygons.foreach_get("material_index", materials)
        materials[crossings.crossing(mesh)] = 2
        mesh.polygons.foreach_set("material_index", materials)
        ob.location.x = 3.7 * place - 0.4 * (place == 2)
        shown.append(ob)
    scene.stage(shown, RENDER)
    scene.render_picture(RENDER, picture)


main(Path(sys.argv[sys.argv.index("--") + 1]))

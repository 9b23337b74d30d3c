# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of solids: a figure-eight and a tight bend as surfaces and as solids, cut open along their plane.

Run by `scripts/gallery` in Blender: solid.py -- PICTURE.
"""

import sys
from dataclasses import replace
from pathlib import Path

import bmesh
import numpy as np

from bl_ext.user_default import sweep_addon as sw
from bl_ext.user_default.sweep_addon.sweep_addon.batch import scene, studio
from bl_ext.user_default.sweep_addon.sweep_addon.batch.job import Render

RENDER = Render(width=1000, height=620, azimuth=-np.pi / 2, elevation=1.1, margin=0.02, samples=96)
SOLID = replace(RENDER, side=(0.16, 0.42, 0.66))
EIGHT = sw.trajectories.Formula("1.4*sin(u)", "1.2*sin(u)*cos(u)", "0", start=0.0, end=2 * np.pi)
BEND = sw.trajectories.Formula("u", "0.9 - 2*u^2", "0", start=-0.9, end=0.9)
SAMPLES = {"kind": "tolerance", "chord": 1e-4}


def main(picture):
    scene.empty()
    shown = []
    for row, made in enumerate((False, True)):
        for column, (radius, path) in enumerate(((0.25, EIGHT), (0.4, BEND))):
            tube = sw.GeneralizedCylinder(sw.contours.Circle(radius, 96), path, SAMPLES, make_solid=made)
            ob = sw.to_object(tube, f"tube {row} {column}")
            cut_open(ob.data)
            studio.paint(ob.data, SOLID if made else RENDER)
            ob.location = (3.3 * column, -2.1 * row, 0)
            shown.append(ob)
    scene.stage(shown, RENDER)
    scene.render_picture(RENDER, picture)


def cut_open(mesh):
    """Leave what is below the trajectory's plane."""
    half = bmesh.new()
    half.from_mesh(mesh)
    geometry = [*half.verts, *half.edges, *half.faces]
    bmesh.ops.bisect_plane(half, geom=geometry, plane_co=(0, 0, 0), plane_no=(0, 0, 1), clear_outer=True)
    half.to_mesh(mesh)
    half.free()


main(Path(sys.argv[sys.argv.index("--") + 1]))

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of points told from a figure-eight that meets itself, cut open: in, on and out.

Run by `scripts/gallery` in Blender: membership.py -- PICTURE.
"""

import sys
from dataclasses import replace
from pathlib import Path

import bmesh
import bpy
import numpy as np

from bl_ext.user_default import sweep_addon as sw
from bl_ext.user_default.sweep_addon.sweep_addon.batch import scene, studio
from bl_ext.user_default.sweep_addon.sweep_addon.batch.job import Render
from bl_ext.user_default.sweep_addon.sweep_addon.bridge import meshes

RENDER = Render(width=1000, height=560, azimuth=-np.pi / 2, elevation=1.15, margin=0.02, samples=48,
                side=(0.93, 0.78, 0.55))  # fmt: skip
COLOURS = {1: (0.10, 0.35, 0.75), 0: (0.85, 0.10, 0.10), -1: (0.45, 0.47, 0.50)}
TUBE = sw.GeneralizedCylinder(
    sw.contours.Circle(0.26, 96),
    sw.trajectories.Formula("1.4*sin(u)", "1.2*sin(u)*cos(u)", "0", start=0.0, end=2 * np.pi),
    {"kind": "tolerance", "chord": 1e-4},
)
STEP, BALL, REACH = 0.095, 0.022, (1.8, 1.0)


def grid():
    """Places in the plane of the trajectory: (n, 3)."""
    x, y = (np.arange(-reach, reach, STEP) + STEP / 3 for reach in REACH)
    return np.stack([axis.ravel() for axis in np.meshgrid(x, y, [0.0])], axis=1)


def on_the_boundary(places, labels):
    """Places between neighbours in and out, found by bisection of what `classify` says: (n, 3)."""
    inner = places[labels == 1]
    ways = np.concatenate([inner + way for way in STEP * np.array([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0)])])
    inner = np.tile(inner, (4, 1))
    crossing = sw.classify(TUBE, ways) == -1
    low, high = inner[crossing], ways[crossing]
    for _ in range(50):
        middle = (low + high) / 2
        inside = (sw.classify(TUBE, middle) == 1)[:, None]
        low, high = np.where(inside, middle, low), np.where(inside, high, middle)
    return high


def balls(places, colour):
    """A ball at each place."""
    mesh = bpy.data.meshes.new("ball")
    meshes.write(mesh, sw.solids.Ball(BALL, 16).mesh())
    studio.paint(mesh, replace(RENDER, side=colour, caps=colour))
    for place in places:
        ob = studio.linked(bpy.context.scene, "ball", mesh)
        ob.location = place
        yield ob


def cut_open(mesh):
    """Leave what is below the trajectory's plane."""
    half = bmesh.new()
    half.from_mesh(mesh)
    geometry = [*half.verts, *half.edges, *half.faces]
    bmesh.ops.bisect_plane(half, geom=geometry, plane_co=(0, 0, 0), plane_no=(0, 0, 1), clear_outer=True)
    half.to_mesh(mesh)
    half.free()


def main(picture):
    scene.empty()
    ob = sw.to_object(TUBE, "tube")
    cut_open(ob.data)
    studio.paint(ob.data, RENDER)
    places = grid()
    labels = sw.classify(TUBE, places)
    boundary = on_the_boundary(places, labels)
    told = sw.classify(TUBE, boundary)
    shown = [ob]
    for label, colour in COLOURS.items():
        shown += balls(np.concatenate((places[labels == label], boundary[told == label])), colour)
    bpy.context.view_layer.update()
    scene.stage(shown, RENDER)
    scene.render_picture(RENDER, picture)


main(Path(sys.argv[sys.argv.index("--") + 1]))

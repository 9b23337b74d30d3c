# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of bending: a straight footbridge and the same mesh along a PD curve that climbs and turns.

Run by `scripts/gallery` in Blender: bent.py -- PICTURE.
"""

import sys
from pathlib import Path

import bpy
import numpy as np

from bl_ext.user_default import sweep_addon as sw
from bl_ext.user_default.sweep_addon.sweep_addon.batch import scene, studio
from bl_ext.user_default.sweep_addon.sweep_addon.batch.camera import axes
from bl_ext.user_default.sweep_addon.sweep_addon.batch.job import Job, Render

RENDER = Render(width=960, height=540, azimuth=-1.25, elevation=0.55, margin=0.04, samples=64)
STRAIGHT = Render(side=(0.62, 0.64, 0.67), caps=(0.62, 0.64, 0.67))
LENGTH, BAY, STEP = 7.0, 0.5, 0.1
UP = sw.directions.Arrows([(0, 0, 0, 1)])
CURVE = sw.trajectories.Bezier([(-0.5, 0, 0), (2.2, -1.2, 0), (3.2, 3.0, 1.3), (6.6, 1.4, 1.3)])


def bar(low, high):
    """A box from corner to corner, x up and z along, in slices: the contour's x and y are those of the model."""
    (x, y, z), (width, breadth, long) = low, np.subtract(high, low)
    box = [[(x, y), (x + width, y), (x + width, y + breadth), (x, y + breadth)]]
    mesh = sw.TranslationalSweep(sw.contours.Outline(box), long, steps=max(1, round(long / STEP))).mesh()
    return mesh.vertices + (0, 0, z), mesh


def footbridge():
    """A deck, posts and handrails: points of the model, and faces as lists of them."""
    parts = [bar((0, -0.5, 0), (0.08, 0.5, LENGTH))]
    for y in (-0.46, 0.42):
        parts += [bar((x, y + thin, 0), (x + 0.05, y + 0.04 - thin, LENGTH)) for x, thin in ((0.45, 0.01), (0.85, 0))]
        parts += [bar((0.08, y, z), (0.85, y + 0.04, z + 0.05)) for z in np.arange(0.0, LENGTH, BAY)]
    points, faces = np.empty((0, 3)), []
    for vertices, mesh in parts:
        faces += [(part + len(points)).tolist() for part in np.split(mesh.corners, mesh.offsets[1:-1])]
        points = np.concatenate((points, vertices))
    return points, faces


def shown(trajectory, name, render):
    """The footbridge along a trajectory, as an object of the scene."""
    points, faces = footbridge()
    mesh = bpy.data.meshes.new(name)
    stretched = points * (1, 1, trajectory.length() / LENGTH)
    mesh.from_pydata(sw.PDCurveSweep(trajectory=trajectory, direction=UP).bend(stretched).tolist(), [], faces)
    studio.paint(mesh, render)
    ob = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(ob)
    return ob


def main(picture):
    job = Job(sw.PDCurveSweep(), RENDER, "")
    first = scene.compose(job, "first")
    bpy.data.objects.remove(first)
    line = sw.trajectories.Line((-0.5, -2.6, 0), (6.5, -2.6, 0))
    parts = [shown(line, "straight", STRAIGHT), shown(CURVE, "bent", RENDER)]
    bpy.context.view_layer.update()
    points = np.concatenate([scene.places(part) for part in parts])
    low, high = points.min(axis=0), points.max(axis=0)
    middle, radius = (low + high) / 2, float(np.linalg.norm(high - low)) / 2
    scene.stand(bpy.context.scene, points, axes(RENDER.azimuth, RENDER.elevation), RENDER)
    for lamp in list(bpy.data.lights):
        bpy.data.lights.remove(lamp)
    for ground in [ob for ob in bpy.context.scene.objects if ob.type == "MESH" and ob not in parts]:
        bpy.data.objects.remove(ground)
    studio.illuminate(bpy.context.scene, middle, radius, RENDER.azimuth)
    studio.lay_ground(bpy.context.scene, (*middle[:2], low[2]), radius, RENDER.background)
    scene.render_picture(job, picture)


main(Path(sys.argv[sys.argv.index("--") + 1]))

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What tests put into a scene of Blender, and what they read from it."""

import bpy
import numpy as np


def add(name, data):
    """A new object of the scene."""
    ob = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(ob)
    return ob


def curve(kind, *splines, name="curve", **options):
    """A curve object with a spline for each list of points: x y z, of BEZIER the handle, the knot and the handle."""
    data = bpy.data.curves.new(name, "CURVE")
    data.dimensions = "3D"
    for points in splines:
        draw(data, kind, np.asarray(points, dtype=float), options)
    return add(name, data)


def draw(data, kind, points, options):
    spline = data.splines.new(kind)
    if kind == "BEZIER":
        spline.bezier_points.add(len(points) - 1)
        for i, side in enumerate(("handle_left", "co", "handle_right")):
            spline.bezier_points.foreach_set(side, points[:, 3 * i : 3 * i + 3].ravel())
    else:
        spline.points.add(len(points) - 1)
        weights = points[:, 3:] if points.shape[1] == 4 else np.ones((len(points), 1))
        spline.points.foreach_set("co", np.hstack((points[:, :3], weights)).ravel())
    for key, value in options.items():
        setattr(spline, key, value)


def text(body, name="text"):
    """A text object in Blender's own font."""
    data = bpy.data.curves.new(name, "FONT")
    data.body = body
    ob = add(name, data)
    bpy.context.view_layer.update()
    return ob


def places(mesh):
    """The vertices of a Blender mesh, (n, 3) float64."""
    values = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", values)
    return values.reshape(-1, 3).astype(float)

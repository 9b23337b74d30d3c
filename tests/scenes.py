# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What tests put into a scene of Blender, and what they read from it."""

import itertools

import bmesh
import bpy
import numpy as np
import pytest

from sweep_addon.bridge import models, objects
from sweep_addon.core.contours import Circle
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.trajectories import Line


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


def shown(ob):
    """What an object shows, its modifiers applied, as a `Mesh` of triangles in its own space."""
    bpy.context.view_layer.update()
    return models.triangles(ob, scaled=False).mesh()


def cube(side=1.0, place=(0, 0, 0), name="cube"):
    """A plain mesh object: a cube about its place."""
    data = bpy.data.meshes.new(name)
    made = bmesh.new()
    bmesh.ops.create_cube(made, size=side)
    made.to_mesh(data)
    made.free()
    ob = add(name, data)
    ob.location = place
    return ob


def doubled(levels):
    """Cubes of which each takes the next one twice, as a list: 2 ** levels ways lead from the first to the last."""
    chain = [cube(1.0 + 0.1 * number, name=f"level {number}") for number in range(levels + 1)]
    for ob, taken in itertools.pairwise(chain):
        for _ in range(2):
            ob.modifiers.new("by hand", "BOOLEAN").object = taken
    return chain


def straight(height=2.0):
    """A curve object that goes straight up from its origin."""
    return curve("POLY", [(0, 0, 0), (0, 0, height)], name="path")


def square(side=1.0):
    """A curve object of a square about its origin."""
    corners = np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]) * side / 2
    return curve("POLY", corners, name="square", use_cyclic_u=True)


def sweep(**given):
    """A sweep of a circle of radius 0.5 straight up, 2 m high, or of what is given: values or objects."""
    inputs = {key: value for key, value in given.items() if isinstance(value, bpy.types.Object)}
    values = {key: value for key, value in given.items() if key not in inputs}
    shape = GeneralizedCylinder(**{"contour": Circle(0.5), "trajectory": Line(end=(0, 0, 2)), **values})
    mesh = objects.new_mesh(shape, "sweep", **inputs)
    ob = add("sweep", mesh)
    ob.parent = inputs.get("trajectory")
    bpy.context.view_layer.update()
    return ob


def parameters_of(ob):
    """The property group in which an object's mesh holds its parameters."""
    return ob.data.sweep.generalized_cylinder


def extent(ob):
    """How far an object's mesh reaches along x, y and z, in its own space."""
    return np.ptp(places(ob.data), axis=0)


def select(active, *others):
    """Select these objects alone, the first of them active."""
    bpy.context.view_layer.update()
    for ob in bpy.context.view_layer.objects:
        ob.select_set(ob in (active, *others))
    bpy.context.view_layer.objects.active = active


LONG = {
    "general_sweep_l_bracket",
    "general_sweep_by_a_csg_solid",
    "general_sweep_by_a_cylinder",
}  # their meshes take seconds: test_models moves smaller solids, and another of their kind stays


def tried(names):
    """Names as parameters of a test; those of long presets are thorough."""
    return [pytest.param(name, marks=pytest.mark.thorough) if name in LONG else name for name in names]

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Membership written on meshes: which of their vertices are in a sweep or a tree, on it or out of it."""

import numpy as np

from ..core.declared.parameters import require
from ..core.membership import classify
from . import objects, trees

NAME, COLOURS = "membership", "membership_colour"
IN, ON, OUT = 1, 0, -1
PAINT = {IN: (0.10, 0.45, 0.80, 1.0), ON: (0.95, 0.75, 0.10, 1.0), OUT: (0.80, 0.80, 0.80, 1.0)}
RELATIVE = 1e-6  # of the size: single precision, in which Blender keeps places, has no finer tolerance


def of_mesh(ob, other, tolerance=None):
    """Classify the own vertices of another object's mesh, and keep the answer as its attributes.

    Parameters
    ----------
    ob : bpy.types.Object
        A sweep or a tree.
    other : bpy.types.Object
        A mesh.
    tolerance : float, optional
        In metres of the object's space; by default a millionth of its size.

    Returns
    -------
    (n,) int8 array
        +1 in, 0 on, -1 out, as the attribute ``membership`` holds it.

    Raises
    ------
    ShapeError
        For an object that is no solid, or is scaled to nothing; nothing is written.
    """
    require(len(other.data.vertices), "must have vertices", other.name, "mesh")
    places = np.empty(3 * len(other.data.vertices), np.float32)
    other.data.attributes["position"].data.foreach_get("vector", places)
    matrix = np.array(other.matrix_world, dtype=float)
    found = of_points(ob, places.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3], tolerance)
    values = attribute(other.data, NAME, "INT8")
    values.data.foreach_set("value", found)
    colours = np.array([PAINT[IN], PAINT[ON], PAINT[OUT]], np.float32)[1 - found]
    attribute(other.data, COLOURS, "FLOAT_COLOR").data.foreach_set("color", colours.ravel())
    other.data.color_attributes.active_color_name = COLOURS
    other.data.update()
    return found


def of_points(ob, points, tolerance=None):
    """Classify points of the world, (n, 3), against the sweep or the tree that an object shows."""
    matrix = np.array(ob.matrix_world, dtype=float)
    trees.require_extent(ob, matrix)
    local = np.linalg.solve(matrix[:3, :3], (np.array(points, dtype=float) - matrix[:3, 3]).T).T
    return classify(objects.from_object(ob), local, tolerance or RELATIVE * size(ob))


def size(ob):
    """How far an object's own mesh reaches from its origin."""
    return float(np.abs(np.array(ob.bound_box)).max())


def attribute(mesh, name, kind):
    """An attribute of the vertices of a mesh; one of that name that is something else is replaced."""
    known = mesh.attributes.get(name)
    if known and (known.data_type, known.domain) != (kind, "POINT"):
        mesh.attributes.remove(known)
        known = None
    return known or mesh.attributes.new(name, kind, "POINT")

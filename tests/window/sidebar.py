# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Add a shape from the sidebar, drag and type its radius, undo and redo; then a pipe along a curve in three clicks.

The mesh is asserted after each step: the radius of the wire is measured on its vertices, not read from a property.
"""

import bpy
import numpy as np
from _window import run

ADD, SWEEP_SELECTED, RADIUS, POINTS = (0.25, 46), (0.7, 46), (0.55, 141), (0.55, 162)  # read off a picture
COPY_AS_PYTHON, COPY_AS_JOB = (0.25, 595), (0.75, 595)


def sweeps():
    return [ob for ob in bpy.data.objects if ob.type == "MESH" and ob.data.sweep.kind != "NONE"]


def wire_radius(mesh, trajectory_radius=1.0):
    """Half the width of a coil's wire, from the vertices' distances from the axis."""
    places = np.empty(len(mesh.vertices) * 3, np.float32)
    mesh.attributes["position"].data.foreach_get("vector", places)
    return float(np.hypot(*places.reshape(-1, 3)[:, :2].T).max()) - trajectory_radius


def close(a, b):
    return abs(a - b) < 1e-3 * max(abs(b), 0.1)


def sidebar(person):
    yield 0.5
    yield from person.open_sidebar("Sweep")
    yield from person.picture("1-nothing-active")
    yield from person.click(*person.top(*ADD))
    yield from person.picture("2-add-menu")
    yield from person.press("G")  # the letter that is underlined in the menu
    assert len(sweeps()) == 1, "a choice in the menu adds one sweep"
    mesh = sweeps()[0].data
    assert close(wire_radius(mesh), 0.1)
    yield from person.picture("3-added")

    for place, words in ((COPY_AS_PYTHON, "sw.to_object("), (COPY_AS_JOB, 'kind = "generalized-cylinder"')):
        yield from person.click(*person.top(*place))
        assert words in bpy.context.window_manager.clipboard

    yield from person.drag(*person.top(*RADIUS), right=12)  # a thicker coil meets itself, which the sidebar says
    dragged = wire_radius(mesh)
    assert dragged > 0.11 and close(dragged, mesh.sweep.generalized_cylinder.contour_circle_radius)
    yield from person.picture("4-dragged")
    yield from person.type_number(*person.top(*RADIUS), "0.2")
    assert close(wire_radius(mesh), 0.2)
    yield from person.type_number(*person.top(*POINTS), "7")
    assert mesh.sweep.generalized_cylinder.contour_circle_points == 7
    assert len(mesh.vertices) == 7 * mesh.sweep.rings
    yield from person.picture("5-typed")

    history = [(7, 0.2), (64, 0.2), (64, dragged), (64, 0.1)]
    for points, radius in history[1:]:
        yield from person.undo()
        yield from matches(points, radius)
    for points, radius in reversed(history[:-1]):
        yield from person.redo()
        yield from matches(points, radius)
    yield from person.picture("6-undone-and-redone")

    yield from pipe_along_a_curve(person)


def matches(points, radius):
    """Undo and redo bring the parameters and the mesh back together."""
    mesh = sweeps()[0].data
    assert mesh.sweep.generalized_cylinder.contour_circle_points == points
    assert len(mesh.vertices) == points * mesh.sweep.rings
    reach = radius if points == 64 else radius * np.cos(np.pi / points)
    assert reach * 0.97 < wire_radius(mesh) < radius * 1.01, (points, radius, wire_radius(mesh))
    yield 0.1


def pipe_along_a_curve(person):
    """A click on the curve, one on the tab, which is open already, and one on the button."""
    bpy.data.batch_remove(list(bpy.data.objects))
    bpy.ops.curve.primitive_bezier_curve_add(radius=2)
    yield 0.5
    yield from person.picture("7-curve-selected")
    yield from person.click(*person.top(*SWEEP_SELECTED))
    pipe = bpy.context.active_object
    assert sweeps() == [pipe] and pipe.parent.type == "CURVE"
    yield from person.picture("8-pipe")
    pipe.parent.data.splines[0].bezier_points[1].co.z = 3
    pipe.parent.data.update_tag()
    yield 0.5
    assert max(vertex.co.z for vertex in pipe.data.vertices) > 2.5, "the pipe follows its curve"
    yield from person.over_view()
    yield from person.press("F9")
    yield 0.3
    yield from person.picture("9-last-operation")


run(sidebar)

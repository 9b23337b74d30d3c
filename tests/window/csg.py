# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A hole through a body in three clicks: the tool, with Shift the body, and Difference; then the tool is moved and its
parameters are changed without leaving the result.

The volume of what is shown is measured after each step.
"""

import bmesh
import bpy
from _window import run
from bpy_extras.view3d_utils import location_3d_to_region_2d

DIFFERENCE = (0.84, 46)  # read off pictures
WIDTH = {"MANIFOLD": (0.55, 297), "EXACT": (0.55, 344)}  # where there is but the exact solver two lines say so

BODY, TOOL = (0, 0, 0.5), (3.0, 0, 1.0)  # points that are seen of them


def volume(ob):
    made = bmesh.new()
    made.from_mesh(ob.evaluated_get(bpy.context.evaluated_depsgraph_get()).data)
    return made.calc_volume(signed=True)


def clicked(person, place, **held):
    """A click on what is seen at a place of the scene."""
    space = next(area for area in person.window.screen.areas if area == person.area).spaces.active
    at = location_3d_to_region_2d(person.view, space.region_3d, place)
    person.held = held
    if held:
        person.send("LEFT_SHIFT", "PRESS")
    yield from person.click(person.view.x + at.x, person.view.y + at.y)
    person.held = {}
    if held:
        person.send("LEFT_SHIFT", "RELEASE")
    yield 0.3


def csg(person):
    yield 0.5
    bpy.data.batch_remove(list(bpy.data.objects))
    bpy.ops.mesh.translational_sweep_add(contour="RECTANGLE", height=1.0, location=(0, 0, 0))
    body = bpy.context.active_object
    group = body.data.sweep.translational_sweep
    group.contour_rectangle_width = group.contour_rectangle_height = 2.0
    bpy.ops.mesh.translational_sweep_add(contour="RECTANGLE", height=3.0, location=(3.0, 0, -1.0))
    tool = bpy.context.active_object
    group = tool.data.sweep.translational_sweep
    group.contour_rectangle_width = group.contour_rectangle_height = 0.5
    tool.select_set(False)
    bpy.context.view_layer.objects.active = None
    bpy.ops.ed.undo_push(message="a body and a tool")
    yield from person.open_sidebar("Sweep")

    yield from clicked(person, TOOL)
    assert bpy.context.active_object == tool
    yield from clicked(person, BODY, shift=True)
    assert bpy.context.active_object == body and tool.select_get()
    yield from person.picture("csg-1-selected")
    yield from person.click(*person.top(*DIFFERENCE))
    yield from person.picture("csg-2-difference")
    assert body.modifiers[0].object == tool and abs(volume(body) - 4.0) < 1e-5

    tool.location.x = 0.0
    bpy.ops.ed.undo_push(message="move the tool")
    yield 0.4
    assert abs(volume(body) - 3.75) < 1e-5, "the tool that is moved drills its hole"
    yield from person.picture("csg-3-moved")
    yield from person.type_number(*person.top(*WIDTH[body.modifiers[0].solver]), "1.0")
    yield from person.picture("csg-4-wider")
    assert abs(volume(body) - 3.5) < 1e-5, "its parameters are changed from the result"
    assert bpy.context.active_object == body

    yield from person.undo()
    body = bpy.context.active_object
    assert abs(volume(body) - 3.75) < 1e-5
    yield from person.redo()
    assert abs(volume(bpy.context.active_object) - 3.5) < 1e-5
    yield from person.picture("csg-5-redone")


run(csg)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Add > Mesh > Sweep by mouse: the last preset is in sight, and the panel of the last operation changes a shape."""

import bpy
from _window import run

ADD, MESH, ACROSS, SWEEP, INSIDE = (285, 860), (310, 836), (500, 836), (500, 613), (690, 613)  # read off a picture
GENERALIZED_CYLINDER, LAST_PRESET = (690, 529), (860, 89)
POINTS = (592, 461)


def add_menu(person):
    yield 0.5
    yield from opened(person)
    yield from person.picture("a1-add-menu")
    yield from person.move(*INSIDE)
    yield from person.click(*LAST_PRESET)
    assert bpy.context.active_object.name == "Wire Rope"
    yield from person.undo()
    yield from opened(person)
    yield from person.move(*INSIDE)
    yield from person.click(*GENERALIZED_CYLINDER)
    sweep = bpy.context.active_object
    assert sweep.data.sweep.kind == "GENERALIZED_CYLINDER"
    faces = len(sweep.data.polygons)
    yield from person.over_view()
    yield from person.press("F9")
    yield 0.5
    yield from person.picture("a2-last-operation")
    yield from person.type_number(*POINTS, "8")
    sweep = bpy.context.active_object
    assert sweep.data.sweep.generalized_cylinder.contour_circle_points == 8
    assert len(sweep.data.polygons) - 2 == (faces - 2) // 8
    yield from person.picture("a3-eight-points")


def opened(person):
    """The menu, opened by moving over the menus that it is in."""
    yield from person.click(*ADD)
    for place in (MESH, ACROSS, SWEEP):
        yield from person.move(*place)
        yield 0.4


run(add_menu)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A bevelled curve becomes a sweep by a click in the sidebar and by Object > Convert > Sweep; an undo takes it back."""

import bpy
from _window import run

CONVERT = (0.5, 142)  # read off a picture
OBJECT, CONVERT_MENU, ACROSS, SWEEP = (330, 860), (360, 235), (560, 235), (562, 115)


def sweeps():
    return [ob for ob in bpy.data.objects if ob.type == "MESH" and ob.data.sweep.kind != "NONE"]


def state():
    """How many sweeps there are, and whether the curve draws a bevel of its own."""
    (path,) = (ob for ob in bpy.data.objects if ob.type == "CURVE")
    return len(sweeps()), path.data.bevel_depth > 0


def convert(person):
    yield 0.5
    bpy.data.batch_remove(list(bpy.data.objects))
    bpy.ops.curve.primitive_bezier_curve_add(radius=2)
    bpy.context.active_object.data.bevel_depth = 0.3
    bpy.ops.ed.undo_push(message="a bevelled curve")
    yield from person.open_sidebar("Sweep")
    yield from person.picture("c1-bevelled")
    yield from person.click(*person.top(*CONVERT))
    yield from person.picture("c2-converted")
    assert state() == (1, False) and bpy.context.active_object == sweeps()[0]
    yield from person.undo()
    assert state() == (0, True), "one undo brings the bevel back"

    yield from person.click(*OBJECT)
    yield from person.picture("c3-object-menu")
    for place in (CONVERT_MENU, ACROSS):
        yield from person.move(*place)
        yield 0.4
    yield from person.picture("c4-convert-menu")
    yield from person.click(*SWEEP)
    assert state() == (1, False)


run(convert)

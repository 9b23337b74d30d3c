# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A coil that becomes too thick: the sidebar says so a moment later, a click selects the faces, undo takes all back.

Its reach is 0.2492 m: two turns are half a metre apart, nearly.
"""

import bpy
from _window import run

RADIUS, SELECT_FACES = (0.55, 141), (0.5, 654)  # read off pictures


def self_intersection(person):
    yield 0.5
    bpy.data.batch_remove(list(bpy.data.objects))
    bpy.ops.mesh.generalized_cylinder_add()
    mesh = bpy.context.active_object.data
    yield from person.open_sidebar("Sweep")
    yield 1.0
    assert mesh.sweep.looked_at == mesh.sweep.made and not mesh.sweep.places
    yield from person.type_number(*person.top(*RADIUS), "0.3")
    yield 1.5
    assert mesh.sweep.looked_at == mesh.sweep.made and "A radius up to 0.2492 m is clear of it." in mesh.sweep.places
    yield from person.over_view()
    yield from person.picture("self-intersection-1-told")
    yield from person.click(*person.top(*SELECT_FACES))
    yield from person.picture("self-intersection-2-selected")
    assert bpy.context.mode == "EDIT_MESH"
    yield from person.over_view()
    yield from person.press("TAB")
    assert any(face.select for face in mesh.polygons) and not all(face.select for face in mesh.polygons)
    for _ in range(3):
        yield from person.undo()
    mesh = bpy.context.active_object.data
    yield 1.5
    assert mesh.sweep.generalized_cylinder.contour_circle_radius < 0.11 and not mesh.sweep.places
    assert mesh.sweep.looked_at == mesh.sweep.made
    yield from person.picture("self-intersection-3-undone")


run(self_intersection)

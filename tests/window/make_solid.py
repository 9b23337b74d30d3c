# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A coil that is too thick is made a solid: by one click, a moment later, and again after each change; Esc stops it.

A roof of many points is waited for in the same way, and made when it is asked for again.
"""

import bpy
from _window import run

RADIUS, MAKE_SOLID = (0.55, 141), (0.5, 684)  # read off pictures


def make_solid(person):
    yield 0.5
    bpy.data.batch_remove(list(bpy.data.objects))
    bpy.ops.mesh.generalized_cylinder_add()
    mesh = bpy.context.active_object.data
    yield from person.open_sidebar("Sweep")
    yield from person.type_number(*person.top(*RADIUS), "0.3")
    yield 1.5
    surface = len(mesh.vertices)
    yield from person.over_view()
    yield from person.picture("make-solid-1-told")
    yield from person.click(*person.top(*MAKE_SOLID))
    assert mesh.sweep.generalized_cylinder.make_solid
    for _ in range(100):
        yield 0.1
        if not mesh.sweep.solid:
            break
    assert not mesh.sweep.solid and not mesh.sweep.told and len(mesh.vertices) != surface
    yield from person.over_view()
    yield from person.picture("make-solid-2-made")
    mesh.sweep.generalized_cylinder.samples = "COUNT"
    mesh.sweep.generalized_cylinder.contour_circle_points = 256
    mesh.sweep.generalized_cylinder.samples_count_contours = 4000
    assert mesh.sweep.solid == "AWAITED"
    for _ in range(200):
        yield 0.02
        if bpy.types.OBJECT_OT_sweep_make_solid.part() is not None:
            break
    yield from person.press("ESC")
    yield 0.5
    assert "Esc stopped it" in mesh.sweep.solid and len(mesh.vertices) == 256 * 4000, mesh.sweep.solid
    yield 1.0
    assert "Esc stopped it" in mesh.sweep.solid
    yield from person.picture("make-solid-3-stopped")
    yield from roof(person)


def roof(person):
    bpy.data.batch_remove(list(bpy.data.objects))
    bpy.ops.mesh.translational_sweep_add()
    mesh = bpy.context.active_object.data
    group = mesh.sweep.translational_sweep
    group.contour, group.height, group.contour_superellipse_quarter_points = "SUPERELLIPSE", 0.5, 1000
    prism = len(mesh.vertices)
    assert prism == 2 * 4 * 1000 and not mesh.sweep.solid
    group.taper = 0.98
    assert mesh.sweep.solid == "AWAITED" and len(mesh.vertices) == prism
    for _ in range(200):
        yield 0.02
        if bpy.types.OBJECT_OT_sweep_make_solid.part():
            break
    yield from person.press("ESC")
    yield 0.5
    yield from person.picture("make-solid-4-roof-stopped")
    assert "Esc stopped it" in mesh.sweep.solid and len(mesh.vertices) == prism, mesh.sweep.solid
    bpy.ops.object.sweep_make_solid("INVOKE_DEFAULT")
    for _ in range(600):
        yield 0.1
        if not mesh.sweep.solid:
            break
    assert not mesh.sweep.solid and len(mesh.vertices) != prism
    yield from person.picture("make-solid-5-roof")


run(make_solid)

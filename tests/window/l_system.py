# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Add > Mesh > L-System with the mouse, drag a constant, undo and redo; type in the text until it is wrong, go to that
line, and make it right again; too many steps are refused, many are waited for, and Esc stops them.

The mesh is asserted after each step: its height is measured on its vertices.
"""

import bpy
import numpy as np
from _window import run

ADD, MESH, ACROSS, L_SYSTEM, INSIDE = (285, 860), (310, 836), (500, 836), (500, 592), (690, 592)  # read off pictures
LENGTH_RATIO, EDIT, FIRST_PROBLEM = (0.55, 197), (0.82, 140), (0.8, 151)


def height(mesh):
    """How high a mesh is, measured on its vertices."""
    places = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.attributes["position"].data.foreach_get("vector", places)
    return float(np.ptp(places[2::3]))


def read(mesh, text, told=None):
    """Write a text and wait until the mesh has read it."""
    if told is not None:
        text.from_string(told)
    for _ in range(100):
        yield 0.1
        if mesh.sweep.plant.system == text.as_string():
            return
    raise AssertionError("nobody has read the text")


def l_system(person):
    yield 0.5
    bpy.data.batch_remove([bpy.data.objects["Cube"]])
    yield from person.open_sidebar("Sweep")
    yield from person.click(*ADD)
    for place in (MESH, ACROSS, L_SYSTEM):
        yield from person.move(*place)
        yield 0.4
    yield from person.picture("l1-add-menu")
    yield from person.click(*INSIDE)
    mesh = bpy.context.active_object.data
    group, first = mesh.sweep.plant, height(mesh)
    assert mesh.sweep.kind == "PLANT" and first > 1

    yield from person.drag(*person.top(*LENGTH_RATIO), right=-30)
    dragged = height(mesh)
    assert group.constants["r1"] < 0.9 and dragged < 0.9 * first
    yield from person.picture("l2-dragged")
    yield from person.undo()
    mesh = bpy.context.active_object.data
    assert abs(height(mesh) - first) < 1e-4 and mesh.sweep.plant.constants["r1"] == 0.9
    yield from person.redo()
    mesh = bpy.context.active_object.data
    assert abs(height(mesh) - dragged) < 1e-4

    yield from person.click(*person.top(*EDIT))
    yield 0.5
    editor = next(area for area in person.window.screen.areas if area.type == "TEXT_EDITOR")
    text = editor.spaces.active.text
    assert text == mesh.sweep.plant.system_text
    yield from person.picture("l3-text")
    region = next(region for region in editor.regions if region.type == "WINDOW")
    yield from person.move(region.x + region.width // 2, region.y + region.height // 2)
    yield from person.press("A", ctrl=True)
    yield from person.press("X", unicode="[")
    yield from read(mesh, text)
    assert "line 1" in mesh.sweep.error and abs(height(mesh) - dragged) < 1e-4
    yield from person.picture("l4-wrong")
    yield from read(mesh, text, "\n" * 40 + "axiom: F\nF ->")
    yield from person.click(*person.top(*FIRST_PROBLEM))
    assert text.current_line_index == 41
    yield from person.picture("l5-line")
    yield from read(mesh, text, "#define l 2  # 1 .. 3 m how long\naxiom: F(l)[&F]F(l)\n")
    assert not mesh.sweep.error and abs(height(mesh) - 4) < 1e-4 and mesh.sweep.plant.constants["l"] == 2
    yield from person.picture("l6-right")

    yield from too_large(person, mesh, text)


def too_large(person, mesh, text):
    yield from read(mesh, text, "#angle 20\naxiom: A(1)\nA(x) -> F(x)[+A(ran(1))][-A(ran(1))]&A(x*0.9)\n")
    assert not mesh.sweep.error
    mesh.sweep.plant.generations = 6
    yield 0.5
    small = len(mesh.vertices)
    mesh.sweep.plant.generations = 40
    assert "but 40 make" in mesh.sweep.error and len(mesh.vertices) == small
    yield from person.picture("l7-too-large")
    mesh.sweep.plant.budget = 20_000_000
    mesh.sweep.plant.generations = 12
    assert mesh.sweep.solid == "AWAITED" and len(mesh.vertices) == small
    for _ in range(200):
        yield 0.02
        if bpy.types.OBJECT_OT_sweep_make_solid.part() is not None:
            break
    yield from person.over_view()
    yield from person.press("ESC")
    yield 0.5
    assert "Esc stopped it" in mesh.sweep.solid and len(mesh.vertices) == small, mesh.sweep.solid
    yield from person.picture("l8-stopped")
    mesh.sweep.plant.generations = 11
    for _ in range(200):
        yield 0.1
        if not mesh.sweep.solid:
            break
    assert not mesh.sweep.solid and len(mesh.vertices) > 100 * small
    yield from person.picture("l9-made")


run(l_system)

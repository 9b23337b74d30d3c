# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Add > Mesh > Sweep > Machined Stock with the mouse; a mistake in the program is told, and a rapid move that cuts,
with a button that goes to its line; a long program is waited for.
"""

import bpy
import numpy as np
from _window import run

ADD, MESH, ACROSS, SWEEP, INSIDE = (285, 860), (310, 836), (500, 836), (500, 613), (690, 613)  # read off pictures
MACHINED_STOCK, LINE = (690, 382), (0.85, 126)
WRONG = "G21 F9\nG0 X-9 Y0 Z5\nG1 Z-2\nG0 X9\nZ5\n"


def deepest(mesh):
    """How deep the cut is, in millimetres."""
    values = np.empty(len(mesh.vertices), np.float32)
    mesh.attributes["depth"].data.foreach_get("value", values)
    return round(1e3 * float(values.max()), 3)


def read(mesh, told):
    """Write a program and wait until the mesh has read it."""
    group = mesh.sweep.machined_stock
    group.program_text.from_string(told)
    for _ in range(100):
        yield 0.1
        if group.program == told:
            return
    raise AssertionError("nobody has read the program")


def machining(person):
    yield 0.5
    bpy.data.batch_remove([bpy.data.objects["Cube"]])
    yield from person.open_sidebar("Sweep")
    yield from person.click(*ADD)
    for place in (MESH, ACROSS, SWEEP, INSIDE):
        yield from person.move(*place)
        yield 0.4
    yield from person.click(*MACHINED_STOCK)
    mesh = bpy.context.active_object.data
    assert mesh.sweep.kind == "MACHINED_STOCK" and 1.9 < deepest(mesh) < 23 / 12
    person.area.spaces.active.region_3d.view_distance = 0.08
    yield from person.picture("m1-added")

    yield from read(mesh, WRONG + "G33 K2\n")
    assert "line 6 has G33" in mesh.sweep.error and deepest(mesh) < 23 / 12
    yield from person.picture("m2-mistake")
    yield from read(mesh, WRONG)
    assert not mesh.sweep.error and mesh.sweep.told == "Rapid moves cut up to 2 mm into the stock, by line 4."
    assert deepest(mesh) == 2
    yield from person.picture("m3-rapid")
    yield from person.click(*person.top(*LINE))
    yield 0.5
    editor = next(area for area in person.window.screen.areas if area.type == "TEXT_EDITOR")
    assert editor.spaces.active.text.current_line_index == 3
    yield from person.picture("m4-line")
    yield from waited_for(person, mesh)


def waited_for(person, mesh):
    long = "G21 F9\nG0 X0 Y0 Z5\nG1 Z-1\n" + "".join(f"X{i % 97 - 48} Y{i % 89 - 44} Z-1\n" for i in range(8000))
    yield from read(mesh, long)
    assert mesh.sweep.solid == "AWAITED" and deepest(mesh) == 2
    for _ in range(200):
        yield 0.1
        if not mesh.sweep.solid:
            break
    assert not mesh.sweep.solid and not mesh.sweep.error and deepest(mesh) == 1
    yield from person.picture("m5-made")


run(machining)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trees: a plate from which fifty operands are taken, after one change, beside Blender's modifiers on plain meshes."""

import bpy
import numpy as np
from measuring import medians, short, table, tell, verdict

from bl_ext.user_default import sweep_addon as sw
from bl_ext.user_default.sweep_addon.sweep_addon.bridge import trees

OPERANDS, ROUNDS, TARGET = 50, 9, 1.2
OURS, THEIRS = (
    "A slider of one operand, in a tree of sweeps",
    "One vertex moved, in plain meshes with the same modifiers",
)
BASE = "A slider of the plate, in the same tree"

INTRODUCTION = f"""### Trees

A plate of which {OPERANDS} cylinders of 32 sides are taken, by Blender's {{solver}} solver. Beside it the same meshes
without parameters, with the same modifiers, one vertex of the same operand moved; medians of {ROUNDS} rounds, dragged.
"""


def tree():
    """The result, and its operands."""
    plate = sw.TranslationalSweep(sw.contours.Rectangle(10.0, 5.0), height=0.5)
    drill = sw.TranslationalSweep(sw.contours.Circle(0.3, points=32), height=2.0)
    value = plate
    for number in range(OPERANDS):
        value = value - drill.moved(x=number % 10 - 4.5, y=number // 10 - 2.0, z=-1.0)
    result = sw.to_object(value, "result")
    return result, trees.operands(result)


def plain(result):
    """The same objects, their meshes copied and without parameters, their modifiers the same Booleans."""
    copies = {}
    for ob in (result, *trees.operands(result)):
        twin = copies[ob] = bpy.data.objects.new(ob.name, bare(ob.data))
        twin.matrix_world, twin.display_type, twin.hide_render = ob.matrix_world, ob.display_type, ob.hide_render
        bpy.context.scene.collection.objects.link(twin)
    for step in trees.booleans(result):
        modifier = copies[result].modifiers.new(step.name, "BOOLEAN")
        modifier.object, modifier.operation, modifier.solver = copies[step.object], step.operation, step.solver
    return copies[result], [copies[ob] for ob in trees.operands(result)]


def bare(mesh):
    """A copy of a mesh that nothing is made anew for."""
    made = mesh.copy()
    made.sweep.kind = "NONE"
    return made


def vertices(ob):
    """How many vertices are shown: the modifiers are evaluated for it."""
    return len(ob.evaluated_get(bpy.context.evaluated_depsgraph_get()).data.vertices)


def main():
    result, operands = tree()
    other, others = plain(result)
    assert vertices(result) == vertices(other)
    group, plate = (ob.data.sweep.translational_sweep for ob in (operands[20], result))
    place = np.array(others[20].data.vertices[0].co)

    def slide(number):
        group.contour_circle_radius = 0.3 - 0.001 * (number % 50)
        vertices(result)

    def slide_base(number):
        plate.height = 0.5 + 0.001 * number
        vertices(result)

    def move(number):
        others[20].data.vertices[0].co = place + (0.001 * (number % 50), 0, 0)
        others[20].data.update()
        vertices(other)

    _, dragged = medians({OURS: slide, BASE: slide_base, THEIRS: move}, ROUNDS)
    rows = [(name, short(taken), short(taken / dragged[THEIRS])) for name, taken in dragged.items()]
    solver = trees.booleans(result)[0].solver.lower()
    page = [INTRODUCTION.format(solver=solver), table(["", "ms", "to Blender's own"], rows)]
    page += ["\nTarget:\n", f"- {OURS}, to Blender's own: {verdict(dragged[OURS] / dragged[THEIRS], TARGET)}"]
    tell("\n".join(page))


main()

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the sidebar shows of an L-system beside its parameters: its text, what is wrong in it, and its constants."""

from ..sweep_addon.core.declared.parameters import ShapeError
from ..sweep_addon.core.later import later
from . import written

growing, objects, texts = later("core.shapes.growing"), later("bridge.objects"), later("bridge.texts")

MOST_PROBLEMS = 6  # that are shown; one is mended at a time
MOST_CONSTANTS = 50  # that are shown
BESIDE = 22  # letters of a line of the text, beside its number and the button that goes there
UNITS = {"angle": " (deg)"}


def problems(group):
    """What is wrong in the text of a mesh's grammar."""
    return growing.problems(group.system)


def draw_text(layout, group, say):
    """The text that people edit, and each line of it that is wrong."""
    written.draw_text(layout, group, "system", say)
    found = problems(group)
    for problem in found[:MOST_PROBLEMS]:
        box = layout.box().column(align=True)
        box.alert = True
        head = box.row()
        head.label(text=f"Line {problem.line}: {problem.around(BESIDE)}", icon="ERROR")
        go = head.operator("object.sweep_grammar_edit", text="", icon="VIEWZOOM", emboss=False)
        go.line, go.column = problem.line, problem.column
        say(box, f"Column {problem.column}: expected {problem.expected}, found {problem.found}", "BLANK1")
    if len(found) > MOST_PROBLEMS:
        say(layout, f"There are {len(found) - MOST_PROBLEMS} more.", "BLANK1")


def draw_size(layout, mesh, say):
    """How large the word will be, which is known before it is derived."""
    if problems(mesh.sweep.plant):
        return
    try:
        say(layout, growing.size(objects.shapes(mesh)[0]), "BLANK1")
    except ShapeError:
        pass  # why is told already


def followed(group):
    """The parameters that stand for nothing, since the text says them by its constants."""
    return () if problems(group) else growing.followed(group.system)


def draw_constants(layout, group):
    """A slider for each constant, and the values of those that follow from others."""
    if problems(group) or not growing.read(group.system).constants:
        return
    header, body = layout.panel("sweep_constants")
    header.label(text="Constants")
    header.operator("object.sweep_grammar_reset", text="", icon="LOOP_BACK", emboss=False)
    if body is None:
        return
    column = body.column(align=True)
    column.use_property_split = column.use_property_decorate = True
    for constant in texts.system(group).constants[:MOST_CONSTANTS]:
        name, key = constant.name + UNITS.get(constant.unit, ""), texts.key(constant.name)
        if key in group.constants:
            column.prop(group.constants, f'["{key}"]', text=name, slider=constant.low is not None)
        else:
            row = column.split(factor=0.4)
            row.alignment = "RIGHT"
            row.label(text=name)
            row.label(text=f"{constant.value:.6g}")

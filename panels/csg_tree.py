# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A sweep-CSG tree in the sidebar: a row for each step, what is wrong, and the operand that is picked."""

from ..sweep_addon.core.declared.parameters import parameters
from ..sweep_addon.core.later import later
from .csg import ICONS
from .sentences import sentences

declared_layout, objects = later("bridge.layout"), later("bridge.objects")
operands, solvers, trees = later("bridge.operands"), later("bridge.solvers"), later("bridge.trees")

MOST_ROWS = 8
MOST_PARTS = 100  # that are looked at in a draw


def draw_tree(layout, context, ob):
    """What the tree is, what is wrong with it, its steps, and the parameters of the operand that is picked."""
    say = sentences(context)
    steps, rest = trees.parted(ob)
    held, bent = held_by(steps)
    used = {step.solver for step in steps}
    layout.label(text=summary(len(steps), used))
    draw_warnings(layout, ob, steps, rest, held, bent, used, say)
    picked = trees.picked(ob)
    row = layout.row()
    draw_rows(row.column(align=True), ob, steps, held, bent, picked)
    draw_buttons(row.column(align=True), ob, picked)
    if picked and trees.operand_of(picked[1]):
        draw_operand(layout, trees.operand_of(picked[1]), say)
    row = layout.row(align=True)
    row.operator("object.sweep_tree_duplicate", text="Duplicate")
    row.operator("object.sweep_tree_collapse")
    row.operator("object.sweep_tree_take_apart")
    row = layout.row(align=True)
    row.operator("object.sweep_classify")
    row.operator("object.sweep_tree_evaluate")
    if not objects.is_sweep(ob):  # the panel of a sweep has these too
        row = layout.row(align=True)
        row.operator("object.sweep_copy", text="Copy as Python").form = "PYTHON"
        row.operator("object.sweep_copy", text="Copy as Job").form = "JOB"


def draw_rows(layout, ob, steps, held, bent, picked):
    """A row for each step, of very many those about the one that is picked; a click on what is left out goes there.

    Known are what the steps hold, and which of that has modifiers.
    """
    rows = [((ob, step), 0) for step in steps] if not bent else list(lines(ob, steps, held, bent, 0, {ob}))
    at = next((number for number, (row, _) in enumerate(rows) if row == picked), 0) if picked else 0
    first = max(0, min(at - MOST_ROWS // 2, len(rows) - MOST_ROWS))
    last = min(first + MOST_ROWS, len(rows))
    if first:
        name_step(layout.operator("object.sweep_step_pick", text=f"{first} more above"), ob, *rows[first - 1][0])
    for (owner, modifier), depth in rows[first:last]:
        draw_step(layout, ob, owner, modifier, depth, picked)
    if last < len(rows):
        name_step(layout.operator("object.sweep_step_pick", text=f"{len(rows) - last} more below"), ob, *rows[last][0])


def name_step(button, active, owner, modifier):
    """Say of which step a button is."""
    button.step = modifier.name
    if owner != active:
        button.owner = owner.name


def summary(count, used):
    """How many operands there are, and which solver computes the steps."""
    solver = solvers.NAMES[min(used)] + " solver" if len(used) == 1 else "several solvers"
    return f"{count} operand{'' if count == 1 else 's'}, {solver}"


def lines(ob, steps, held, bent, depth, entered):
    """Each step of a tree with the object that has it and how deep it is, those of an operand below its first one."""
    for modifier, operand in zip(steps, held, strict=True):
        yield (ob, modifier), depth
        if operand in bent and operand not in entered:
            entered.add(operand)
            inner = trees.booleans(operand)
            yield from lines(operand, inner, *held_by(inner), depth + 1, entered)


def held_by(steps):
    """What steps hold, a list, and which of that has modifiers, a set."""
    held = [trees.operand_of(step) for step in steps]
    return held, {operand for operand in held if operand and operand.modifiers}


def draw_warnings(layout, ob, steps, rest, held, bent, used, say):
    """What keeps the tree from being what it says, each with what mends it; known is what else the object has."""
    fast = solvers.FAST in used
    bare = dict.fromkeys(operand for operand in held[:MOST_PARTS] if operand and operand not in bent)
    others = solvers.parts_of(list(bent), {ob: None})[: max(MOST_PARTS - len(bare), 1)]
    mirrored = ob.matrix_world.is_negative
    doubtful = solvers.doubtful(bare, mirrored)
    why = solvers.seen_exact((*doubtful, *others), mirrored)
    lacking = solvers.lacking()
    if why or lacking:
        say(layout, f"{why}." if why and not (lacking and fast) else lacking, "ERROR" if fast else "INFO")
    meeting = solvers.known_to_cross([*others, *doubtful])
    for part in meeting:
        say(layout, f"{part.name!r} meets itself: make it a solid first.", "ERROR")
    if meeting or bool(why or lacking) == fast:
        layout.operator("object.sweep_tree_choose_solver")
    for sentence in filter(None, map(solvers.lost_faces, (ob, *others, *doubtful))):
        say(layout, sentence, "ERROR")
    if trees.is_empty(ob):
        say(layout, "Nothing is left: the steps take all of it away.", "ERROR")
    lost = [trees.is_lost(step) for step, operand in zip(steps, held, strict=True) if operand is None]
    if any(lost):
        say(layout, "An operand was deleted: its step does nothing.", "ERROR")
    moved = (operand for operand in held if operand and operand.parent != ob)
    elsewhere = (operand for operand in moved if ob not in operands.ancestors(operand))
    shared = next(((operand, owner) for operand in elsewhere if (owner := owner_of(operand))), None)
    if shared:
        sentence = "{0.name!r} is an operand of {1.name!r} too: Duplicate copies operands."
        say(layout, sentence.format(*shared), "INFO")
    if rest or not all(lost):  # some take a collection
        say(layout, "Modifiers that are no Booleans of an object are no part of the tree.", "INFO")


def owner_of(operand):
    """The tree that an operand moves with, or None."""
    return next((above for above in operands.ancestors(operand) if operand in trees.operands(above)), None)


def draw_step(layout, active, owner, modifier, depth, picked):
    """A step: its operation, its operand's name, which picks it, and whether it is done."""
    row = layout.row(align=True)
    if depth:
        row.separator(factor=2.0 * depth)
    row.prop_menu_enum(modifier, "operation", text="", icon=ICONS[modifier.operation])
    of_object = modifier.operand_type == "OBJECT"
    held = modifier.object if of_object else modifier.collection
    lost = of_object and not held
    if lost:
        row.alert = True
    name = held.name if held else "Deleted"
    pick = row.operator("object.sweep_step_pick", text=name, depress=picked == (owner, modifier))
    if lost:
        row.alert = False
    icon = "HIDE_OFF" if modifier.show_viewport else "HIDE_ON"
    mute = row.operator("object.sweep_step_mute", text="", icon=icon)
    remove = None
    if lost:
        remove = row.operator("object.sweep_step_extract", text="", icon="X")
    for button in filter(None, (pick, mute, remove)):
        name_step(button, active, owner, modifier)


def draw_buttons(layout, ob, picked):
    """What can be done with the step that is picked."""
    layout.enabled = bool(picked)
    layout.operator("object.sweep_step_move", text="", icon="TRIA_UP").direction = "UP"
    layout.operator("object.sweep_step_move", text="", icon="TRIA_DOWN").direction = "DOWN"
    layout.operator("object.sweep_step_select", text="", icon="RESTRICT_SELECT_OFF")
    layout.operator("object.sweep_step_extract", text="", icon="EXPORT")


def draw_operand(layout, operand, say):
    """The operand's place and its own parameters, to be changed without leaving the result."""
    box = layout.box()
    box.context_pointer_set("active_object", operand)  # of which the buttons of a list's items are
    column = box.column()
    column.use_property_split = True
    sweep = objects.is_sweep(operand)
    kind = objects.title(objects.group_of(operand.data)[0]) if sweep else "Mesh"
    say(column, f"{operand.name}: {kind}", "OBJECT_DATA")
    if sweep and operand.data.sweep.error:
        say(column, operand.data.sweep.error, "ERROR", alert=True)
    column.prop(operand, "location")
    if sweep and operand.data.is_editable:
        shape, group = objects.group_of(operand.data)
        declared_layout.draw(column, group, parameters(shape))

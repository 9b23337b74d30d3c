# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Declared parameters as a layout: the same lines in the sidebar and in the panel of the last operation."""

from functools import cache

from ..core.declared.names import titled
from ..core.declared.parameters import inside, parameters, spelled
from ..core.declared.texts import ASIDE
from .rna import chosen_kinds, listed
from .table import label

TYPED = 400  # characters of a list that can still be read and typed as text


def draw(layout, group, declared):
    """Every parameter; those of one group in a sub-panel that starts folded, below those of none.

    Returns the bodies of the open sub-panels, by the groups' names.
    """
    bodies, declared = {"": layout}, in_order(tuple(declared))
    idle = {p.group for p in declared if p.item and not hasattr(group, p.name)}  # of an operator, which has no lists
    for p in (p for p in declared if p.group not in idle):
        if p.group not in bodies:
            header, body = layout.panel(f"sweep_{p.group.lower().replace(' ', '_')}", default_closed=True)
            header.label(text=p.group)
            bodies[p.group] = body
        if bodies[p.group]:
            draw_one(bodies[p.group], group, p, p.name)
    return {name: body for name, body in bodies.items() if body}


@cache
def in_order(declared):
    """Parameters as they are drawn, those of no group first, without those that have a place of their own."""
    return sorted((p for p in declared if p.type not in ASIDE), key=lambda p: bool(p.group))


def draw_one(layout, group, p, name):
    """One parameter, and of a union the chosen kind's own, joined to it."""
    if p.is_list:
        draw_list(layout, group, p, name)
        return
    if p.item:
        draw_items(layout, group, p, name)
        return
    if not p.kinds:
        layout.prop(group, name)
        return
    column = layout.column(align=True)
    column.prop(group, name, text="" if label(p) == p.group else label(p))  # its sub-panel may have said it
    chosen = getattr(group, name)
    kind = chosen_kinds(p).get(chosen)
    if kind is None:
        if p.accepts and chosen == "OBJECT":
            column.prop(group, f"{name}_object", text=" ")
            draw_beside(column, group, p, name)
        return
    inner = inside(p, kind)
    for q in inner:
        if q.kinds or q.is_list:
            draw_one(column, group, q, f"{name}_{spelled(kind, '_')}_{q.name}")
        else:
            column.prop(group, f"{name}_{spelled(kind, '_')}_{q.name}", text=" " if q.shorthand else label(q))


def draw_beside(layout, group, p, name):
    """What an object that stands for a value does not say itself: the corners of a curve with straight legs."""
    curve = getattr(getattr(group, f"{name}_object"), "data", None)  # nobody may have chosen one yet
    held = {spline.type for spline in getattr(curve, "splines", ())}
    for kind in p.kinds:
        for q in inside(p, kind):
            if held.intersection(q.splines):
                draw_one(layout, group, q, f"{name}_{spelled(kind, '_')}_{q.name}")


def draw_items(layout, group, p, name):
    """What is in a list, each with a button that takes it out, and one more button that adds to it."""
    for number, each in enumerate(getattr(group, name), 1):
        box = layout.box()
        head = box.row()
        head.label(text=f"{titled(p.item)} {number}")
        remove = head.operator("object.sweep_item_remove", text="", icon="X", emboss=False)
        remove.parameter, remove.number = name, number
        for q in parameters(p.item):
            draw_one(box, each, q, q.name)
    layout.operator("object.sweep_item_add", text=f"Add {titled(p.item)}", icon="ADD").parameter = name


def draw_list(layout, group, p, name):
    """A law's few points are text to type in; of any other list, how long it is."""
    text = getattr(group, name)
    if p.shorthand and len(text) <= TYPED:
        layout.prop(group, name, text=" ")
        return
    values = listed(text)
    size = len(values) if isinstance(values, list) else 0  # somebody may have written any text there
    if size:
        row = layout.split(factor=0.4)
        row.alignment = "RIGHT"
        row.label(text=label(p))
        row.label(text=f"{size:,}")

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What an object is, told without importing what makes it: the sidebar asks of every active object."""


def is_sweep(ob):
    """Whether an object's mesh is made from parameters."""
    sweep = getattr(ob.data, "sweep", None) if ob is not None and ob.type == "MESH" else None
    return sweep is not None and sweep.kind != "NONE"  # None too where the extension is not enabled


def booleans(ob):
    """The Boolean modifiers of an object, muted ones and those without an operand among them."""
    return [modifier for modifier in getattr(ob, "modifiers", ()) if modifier.type == "BOOLEAN"]


def is_tree(ob):
    """Whether an object is the result of set operations."""
    return any(modifier.type == "BOOLEAN" for modifier in getattr(ob, "modifiers", ()))


def operand_of(modifier):
    """The object that a Boolean modifier takes; None for a collection, and where it was deleted."""
    return modifier.object if modifier.operand_type == "OBJECT" else None


def operands(ob):
    """The objects that an object's Boolean modifiers name, each once."""
    return list(dict.fromkeys(filter(None, map(operand_of, booleans(ob)))))

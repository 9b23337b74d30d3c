# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grammars and programs in texts of Blender, where people edit them, and the constants in grammars as properties.

The mesh keeps its own copy of the text, so that it outlives the text. Numbers that nobody has turned follow the text.
"""

from itertools import islice

import bpy
import numpy as np

from ..core.declared.parameters import ShapeError, require
from ..core.declared.texts import Grammar, Values
from ..core.shapes import growing
from ..core.shapes.plant import SAID
from . import objects, rna

LARGEST = 2**31 - 1  # whole number of a property
LONGEST, MOST = 63, 500  # characters of a property's name, and properties: further constants have the text's values
TAKEN = ("name", "rna_type")  # by every group, so that a path with them leads elsewhere
NUMBER = int | float  # what a property of a constant holds; a script may have given it something else
SUBTYPES = {"length": "DISTANCE"}
STEP = 1.0  # hundredths of the value, by which a pixel changes a number without a range


def numbers(values):
    """What the properties of constants hold: a tuple of names and numbers; anything else is refused."""
    for name, value in values.items():
        require(isinstance(value, NUMBER), "must be a number", value, f"constants.{name.rstrip()}")
    return tuple((name.rstrip(), meant(value)) for name, value in values.items())


def key(name):
    """The name of a constant's property: its own, with a blank behind it where Blender has one of that name."""
    return f"{name} " if name in TAKEN else name


def meant(value):
    """The number that is meant by one that animation may have made single."""
    return float(str(np.float32(value))) if np.float32(value) == value else float(value)


def system(group):
    """The system of a group's grammar, with the values that its constants have there if it can have these."""
    try:
        return growing.read(group.system, Values(dict(numbers(group.constants))))
    except ShapeError:
        return growing.read(group.system)


def hold(group, name, text):
    """Put a text into a mesh's parameters, and into a text of the file for people to edit."""
    setattr(group, name, text)
    if hasattr(group, f"{name}_understood"):
        setattr(group, f"{name}_understood", text)
    held = held_by(group, name)
    if held is None or held.as_string() != text:
        held = bpy.data.texts.new(group.id_data.name)
        held.from_string(text)
        held.cursor_set(0)
        held.use_fake_user = False  # it goes with the last mesh that is made of it
        setattr(group, f"{name}_text", held)


def held_by(group, name):
    """The text of the file that people edit, or None where it was deleted."""
    return getattr(group, f"{name}_text")


def turn(group, values):
    """Give the constants of a group's grammar their properties, some of them with other values than the text's."""
    sliders(group.constants, {}, growing.free(Grammar(group.system)))
    for name, value in values.items():
        group.constants[key(name)] = value


def follow(mesh):
    """Read the text that a mesh is made of, if somebody has changed it, and make the mesh anew."""
    group, name = objects.text_of(mesh)
    held = held_by(group, name)
    if held is None or not mesh.is_editable or held.as_string() == getattr(group, name):
        return
    with rna.at_once(mesh.sweep):
        setattr(group, name, held.as_string())
        if objects.is_grown(mesh):
            settle(group)


def settle(group):
    """Let numbers follow a new text that nobody has turned since the last one; not while it has mistakes."""
    try:
        text = Grammar.coerced(group.system)
        new, free = growing.read(text), growing.free(text)
    except ShapeError:
        return
    old, known = last(group)
    for name in SAID:
        if old is None or np.float32(getattr(old, name)) == np.float32(getattr(group, name)):
            setattr(group, name, min(getattr(new, name), LARGEST))
    sliders(group.constants, known, free)
    group.system_understood = text


def last(group):
    """The system and the free constants of the last text without mistakes; None where this version reads none."""
    before = Grammar(group.system_understood)
    try:
        return growing.read(before), growing.free(before)
    except ShapeError:
        return None, {}


def reset(mesh):
    """Give all numbers the values that the text says."""
    group = mesh.sweep.plant
    with rna.at_once(mesh.sweep):
        for name in list(group.constants.keys()):
            del group.constants[name]
        group.system_understood = ""
        settle(group)


def sliders(values, known, free):
    """Let a group have a property for each constant; one that was turned, and is still there, keeps its value.

    Parameters
    ----------
    values : SWEEP_PG_values
    known, free : dict of str to Constant
        Those of the text before, and of the text now.
    """
    free = {name: constant for name, constant in free.items() if len(key(name)) <= LONGEST}
    free = dict(islice(free.items(), MOST))
    for stale in [held for held, value in values.items() if held.rstrip() not in free or not isinstance(value, NUMBER)]:
        del values[stale]
    for name, constant in free.items():
        own = key(name)
        turned = own in values and (name not in known or meant(values[own]) != known[name].value)
        values[own] = float(values[own]) if turned else constant.value  # a script may have given a whole number
        low, high = (constant.low, constant.high) if constant.low is not None else (-1e6, 1e6)
        size = high - low if constant.low is not None else abs(constant.value) or 1.0
        values.id_properties_ui(own).update(
            default=constant.value,
            soft_min=low,
            soft_max=high,
            step=STEP * size,
            precision=3,
            subtype=SUBTYPES.get(constant.unit, "NONE"),
            description=constant.doc or f"The constant {name} of the grammar",
        )

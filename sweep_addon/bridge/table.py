# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What Blender is to register of the declarations, as a table of plain data: property groups, operators and choices.

A union is an enum beside the flat, prefixed properties of all its kinds, `contour` and `contour_circle_radius`, so
that operators, presets, scripts and keyframes reach each by a plain name. A list is JSON in one hidden string.
The table says everything of a property but the functions that Blender is to call, so that it can be kept in a file.
"""

import json
from enum import Enum, EnumMeta
from functools import cache

from ..core.declared.names import number_of, spelled, titled
from ..core.declared.parameters import inside, parameters
from ..core.declared.plain import VERSION, plain
from ..core.declared.texts import ASIDE, Grammar, Values
from ..core.declared.wording import summary
from ..core.shapes.kinds import SHAPES, SWEPT

UNITS = {None: "NONE", "length": "LENGTH", "angle": "ROTATION"}
WIDEST = (3.4028234663852886e38, 2**31 - 1)  # of a float32, and of an int32
LIMITS = {"min", "max", "soft_min", "soft_max"}
LOCAL = {"LIBRARY_OVERRIDABLE"}
OBJECT = ("OBJECT", "Object", "An object of the scene", 0)
SMALLEST = 1e-6  # where a slider stops that must be more than 0; what is typed and scripts may go below
VALUES = "SWEEP_PG_values"
NAMED = "Numbers whose names a text gives, each a property of the group that only it has"


def table():
    """All of it.

    Returns
    -------
    dict
        Of what `marshal` can write. ``properties``: those of all groups and operators, each once: its
        maker in ``bpy.props`` and what that is told. ``groups`` and ``shapes``: names, docs, and the numbers of their
        properties by name, a group after those that it refers to; of a shape the name of its group too. ``kinds`` and
        ``along_curves``: the items of enums. ``version``: of the parameters.
    """
    made = {}
    items = {p.item: None for shape in SHAPES for p in parameters(shape) if p.item}
    groups = [{"name": VALUES, "doc": NAMED, "properties": {}}]
    groups += [
        {"name": group_name(kind), "doc": summary(kind), "properties": numbered(annotations(kind, True), made)}
        for kind in (*items, *SHAPES)
    ]
    shapes = [
        {
            "name": spelled(shape, "_"),
            "group": group_name(shape),
            "title": titled(shape),
            "doc": summary(shape),
            "properties": numbered(annotations(shape), made),
        }
        for shape in SHAPES
    ]
    return {
        "version": VERSION,
        "properties": [told for _, told in made.values()],
        "groups": groups,
        "shapes": shapes,
        "kinds": items_of(SHAPES),
        "along_curves": items_of(filter(is_along_curve, SWEPT)),
    }


def numbered(properties, made):
    """Properties as the numbers of equal ones, most of which are another shape's too."""
    return {name: made.setdefault(repr(told), (len(made), told))[0] for name, told in properties.items()}


def is_along_curve(shape):
    """Whether a curve can be the trajectory or the contour."""
    return not {"trajectory", "contour"}.isdisjoint(p.name for p in parameters(shape))


def group_name(kind):
    return f"SWEEP_PG_{spelled(kind, '_')}"


def annotations(kind, pointers=False):
    """The properties of a kind; an operator can hold no pointers, and no lists of what may hold some."""
    made = {}
    for p in parameters(kind):
        if p.item:
            if pointers:
                told_of = told(p) | {"override": LOCAL | {"USE_INSERTION"}}
                made[p.name] = "CollectionProperty", {"type": group_name(p.item), **told_of}
        elif pointers and p.type in ASIDE:
            made |= held_aside(p)
        else:
            made |= annotated((p,), "")
            if pointers and p.accepts:
                made |= by_object(p)
    return made


@cache
def annotated(declared, start):
    """The properties of parameters and of their kinds, whose names begin so; most shapes share most of theirs."""
    made = {}
    for p in declared:
        made[start + p.name] = define(p)
        for kind in p.kinds:
            made |= annotated(inside(p, kind), f"{start}{p.name}_{spelled(kind, '_')}_")
    return made


def by_object(p):
    """The choice of a parameter's kind with one more, an object of the scene, and that object."""
    chosen = {"type": "Object", "poll": list(p.accepts), "update": True, **told(p)}
    return {p.name: define(p, OBJECT), f"{p.name}_object": ("PointerProperty", chosen)}


def held_aside(p):
    """The properties of a text, which a text of the file holds too, or of the numbers in one."""
    if p.type is Values:
        return {p.name: ("PointerProperty", {"type": VALUES, **told(p)})}
    text = {"type": "Text", "update": True, **told(p)}
    made = {p.name: define(p), f"{p.name}_text": ("PointerProperty", text)}
    if p.type is Grammar:
        told_of = {"options": {"HIDDEN"}, "name": "Understood", "description": "The last text without a mistake"}
        made[f"{p.name}_understood"] = "StringProperty", told_of
    return made


def told(p):
    """What people are told of a parameter's property."""
    return {"name": label(p), "description": p.doc, "override": LOCAL}


def define(p, *more):
    """The property of one parameter, whatever its name is where it is used; of a choice with more items."""
    common = {**told(p), "default": stored(p, p.shown if p.default is None else p.default), "update": True}
    if p.type in ASIDE:
        return "StringProperty", {"options": {"HIDDEN"}, **common}
    if p.type is bool:
        return "BoolProperty", common
    if p.type is str or p.is_list:
        return "StringProperty", {"options": {"HIDDEN" if p.is_list else "ANIMATABLE"}, **common}
    if p.type is float or p.type is int or isinstance(p.default, tuple):
        return number(p, common)
    return "EnumProperty", {"items": [*items_of(p.kinds or p.type), *more], **common}


def number(p, common):
    """The property of a number, or of several.

    A slider stops at the limits. What is set below a minimum becomes that, as Blender has it, also where a curve of
    keyframes dips. What is set beyond another limit is not made to fit but refused as it is, in the value's own words.
    """
    whole = p.type is int
    widest, above = WIDEST[whole], p.above
    highest = p.maximum if p.soft_maximum is None else p.soft_maximum
    common["min"], common["max"] = max(p.minimum, -widest), widest
    if above > p.minimum:
        common["soft_min"] = above + SMALLEST
    if highest < widest:
        common["soft_max"] = highest
    if whole:
        return "IntProperty", common | {key: int(common[key]) for key in LIMITS.intersection(common)}
    common |= {"unit": UNITS[p.unit], "precision": 3, "step": 1 if p.unit == "length" else 10}
    if p.type is float:
        return "FloatProperty", common
    return "FloatVectorProperty", {"size": len(p.default), "subtype": "XYZ", **common}


def items_of(choices):
    """The items of some kinds, or of an Enum."""
    return list(map(item, choices))


@cache
def item(choice):
    """An enum's item."""
    name, doc = spelled(choice, "_"), choice.value if isinstance(choice, Enum) else summary(choice)
    return name.upper(), titled(choice), doc, number_of(name)


def label(p):
    return p.name.replace("_", " ").title()


def stored(p, value):
    """A value as its property holds it."""
    if p.kinds:
        return spelled(type(value), "_").upper()
    if isinstance(p.type, EnumMeta):
        return value.name
    if isinstance(value, str):
        return str(value)  # a grammar is a kind of text
    return json.dumps(plain(value)) if p.is_list or p.type is Values else value

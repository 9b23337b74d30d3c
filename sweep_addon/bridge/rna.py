# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Declared parameters as Blender properties: define, read, assign.

A union is an enum beside the flat, prefixed properties of all its kinds, `contour` and `contour_circle_radius`, so
that operators, presets, scripts and keyframes reach each by a plain name. A list is JSON in one hidden string.
"""

import json
import zlib
from contextlib import contextmanager
from dataclasses import replace
from enum import Enum, EnumMeta
from functools import cache, lru_cache

import bpy
import numpy as np

from ..core.declared.parameters import ShapeError, at, coerce, inside, parameters, require, spelled
from ..core.declared.plain import plain
from ..core.declared.texts import Grammar, Program, Values
from ..core.declared.wording import summary, titled
from ..core.later import later

texts = later("bridge.texts")

UNITS = {None: "NONE", "length": "LENGTH", "angle": "ROTATION"}
WIDEST = (3.4028234663852886e38, 2**31 - 1)  # of a float32, and of an int32
LOCAL = {"LIBRARY_OVERRIDABLE"}
LIMITS = {"min", "max", "soft_min", "soft_max"}
TEXTS = (Grammar, Program)  # a group has a text of the file for each, an operator hidden text
ASIDE = (*TEXTS, Values)  # and sliders for these
OBJECT = ("OBJECT", "Object", "An object of the scene", 0)
SMALLEST = 1e-6  # where a slider stops that must be more than 0; what is typed and scripts may go below


def annotations(declared, pointers=False, update=None):
    """The properties of some parameters; an operator can hold no pointers, and no lists of what may hold some."""
    made = {}
    for p in declared:
        if p.item:
            if pointers:
                kept = told(p) | {"override": LOCAL | {"USE_INSERTION"}}
                made[p.name] = bpy.props.CollectionProperty(type=item_group(p.item, update), **kept)
        elif pointers and p.type in ASIDE:
            made |= held_aside(p, update)
        else:
            made |= annotated((p,), "", update)
            if pointers and p.accepts:
                made |= by_object(p, update)
    return made


@cache
def annotated(declared, start, update):
    """The properties of parameters and of their kinds, whose names begin so; shared, for most are another shape's."""
    made = {}
    for p in declared:
        made[start + p.name] = define(p, update)
        for kind in p.kinds:
            made |= annotated(inside(p, kind), f"{start}{p.name}_{spelled(kind, '_')}_", update)
    return made


def by_object(p, update):
    """The choice of a parameter's kind with one more, an object of the scene, and that object."""
    poll = only(p.accepts)
    chosen = bpy.props.PointerProperty(type=bpy.types.Object, poll=poll, update=update, **told(p))
    return {p.name: define(p, update, OBJECT), f"{p.name}_object": chosen}


VALUES = type(
    "SWEEP_PG_values",
    (bpy.types.PropertyGroup,),
    {"__doc__": "Numbers whose names a text gives, each a property of the group that only it has"},
)


def held_aside(p, update):
    """The properties of a text, which a text of the file holds too, or of the numbers in one."""
    if p.type is Values:
        return {p.name: bpy.props.PointerProperty(type=VALUES, **told(p))}
    text = bpy.props.PointerProperty(type=bpy.types.Text, update=update, **told(p))
    made = {p.name: define(p, update), f"{p.name}_text": text}
    if p.type is Grammar:
        made[f"{p.name}_understood"] = bpy.props.StringProperty(
            options={"HIDDEN"}, name="Understood", description="The last text without a mistake"
        )
    return made


def told(p):
    """What people are told of a parameter's property."""
    return {"name": label(p), "description": p.doc, "override": LOCAL}


@cache
def item_group(kind, update):
    """The property group of what is in a list: to be registered before a group that has the list."""
    made = annotations(parameters(kind), pointers=True, update=update)
    name = f"SWEEP_PG_{spelled(kind, '_')}"
    return type(name, (bpy.types.PropertyGroup,), {"__annotations__": made, "__doc__": summary(kind)})


@cache
def define(p, update, *more):
    """The property of one parameter, whatever its name is where it is used; of a choice with more items."""
    default = stored(p, p.shown if p.default is None else p.default)
    common = {"name": label(p), "description": p.doc, "default": default, "update": update, "override": LOCAL}
    if p.type in ASIDE:
        return bpy.props.StringProperty(options={"HIDDEN"}, **common)
    if p.type is bool:
        return bpy.props.BoolProperty(**common)
    if p.type is str or p.is_list:
        return bpy.props.StringProperty(options={"HIDDEN"} if p.is_list else {"ANIMATABLE"}, **common)
    if p.type is float or p.type is int or isinstance(p.default, tuple):
        return number(p, common)
    return bpy.props.EnumProperty(items=[*items_of(p.kinds or p.type), *more], **common)


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
        return bpy.props.IntProperty(**common | {key: int(common[key]) for key in LIMITS.intersection(common)})
    common |= {"unit": UNITS[p.unit], "precision": 3, "step": 1 if p.unit == "length" else 10}
    if p.type is float:
        return bpy.props.FloatProperty(**common)
    return bpy.props.FloatVectorProperty(size=len(p.default), subtype="XYZ", **common)


@cache
def items_of(choices):
    """The items of some kinds, or of an Enum."""
    return tuple(map(item, choices))


def item(choice):
    """An enum's item."""
    name, doc = spelled(choice, "_"), choice.value if isinstance(choice, Enum) else summary(choice)
    return name.upper(), titled(choice), doc, number_of(name)


def number_of(name):
    """The number of an item, which is saved in files; keyframes add a half to it in float32: 23 bits."""
    return zlib.crc32(name.encode()) % 2**23


def only(types):
    return lambda group, ob: ob.type in types


@cache
def label(p):
    return p.name.replace("_", " ").title()


def stored(p, value):
    """A value as its property holds it."""
    if p.kinds:
        return spelled(type(value), "_").upper()
    if isinstance(p.type, EnumMeta):
        return value.name
    return json.dumps(plain(value)) if p.is_list or p.type is Values else value


def meant(p, held):
    """What a property holds, as a job would write it."""
    if p.kinds and isinstance(held, tuple):
        kind, *values = held
        kind = chosen_kinds(p)[kind]
        return {"kind": spelled(kind)} | {q.name: meant(q, v) for q, v in zip(inside(p, kind), values, strict=True)}
    if p.is_list:
        return listed(held)
    if p.type is Values:
        return listed(held) if isinstance(held, str) else dict(held)
    if isinstance(p.type, EnumMeta):
        return held.lower().replace("_", "-")
    if p.type is float:
        return decimal(held, p.default, p.minimum, p.maximum)
    if isinstance(p.default, tuple):
        return [decimal(number) for number in held]
    return held


@lru_cache(maxsize=64)
def listed(text):
    """The list in a hidden string; any other text is left for the check to refuse in its own words."""
    try:
        return json.loads(text)
    except (ValueError, RecursionError):
        return text


def decimal(single, *declared):
    """The number that a person meant by a float32: a declared one, or the shortest decimal."""
    return next((n for n in declared if n is not None and np.float32(n) == single), float(str(np.float32(single))))


def read(group, shape, resolve=None):
    """The shape that a group or an operator describes; resolve turns an object into a value."""
    held = tuple(raw(group, p, p.name) for p in parameters(shape))
    pairs = list(zip(parameters(shape), held, strict=True))
    if any(is_object(p, part) or p.item and part for p, part in pairs):
        return shape(**{p.name: value(group, p, part, resolve) for p, part in pairs})
    return described(shape, held)


@lru_cache(maxsize=8)
def described(shape, held):
    """A shape of properties alone: they are read twice for each change."""
    return shape(**{p.name: plainly(p, part) for p, part in zip(parameters(shape), held, strict=True)})


def value(group, p, held, resolve):
    """The value of one parameter of a shape."""
    if p.item:
        return items(p, held, resolve)
    if not is_object(p, held):
        return plainly(p, held)
    chosen = getattr(group, f"{p.name}_object")
    with at(p.name):
        require_usable(chosen, p.accepts)
    return completed(resolve(chosen, p), group, p)


def is_object(p, held):
    """Whether an object stands for a value."""
    return bool(p.accepts) and held == "OBJECT"


def plainly(p, held):
    """The value that a property holds itself."""
    if not p.kinds:
        return meant(p, held)
    with at(p.name):
        return understood(p, held)


def items(p, groups, resolve):
    """The values in a list."""
    made = []
    for number, each in enumerate(groups, 1):
        with at(f"{p.name}.{number}"):
            made.append(read(each, p.item, resolve))
    return made


def raw(group, p, name):
    """What the property of a parameter holds; of a chosen kind its identifier, and what its own properties hold."""
    held = getattr(group, name, ()) if p.item else getattr(group, name)  # an operator has no lists
    if isinstance(p.default, tuple) and not p.is_list:
        return tuple(held)
    if p.type is Values and not isinstance(held, str):
        return texts.numbers(held)
    kind = chosen_kinds(p).get(held) if p.kinds else None
    if kind is None:
        return held
    return held, *(raw(group, q, f"{name}_{held.lower()}_{q.name}") for q in inside(p, kind))


@lru_cache(maxsize=256)
def understood(p, held):
    """The value of a union: most of a shape's are the same each time it is read, which is twice for each change."""
    return coerce(p, meant(p, held))


def completed(value, group, p):
    """A value read from an object, with what a curve does not say: what becomes of the corners of a polyline."""
    kind = type(value)
    asked = [(q, raw(group, q, f"{p.name}_{spelled(kind, '_')}_{q.name}")) for q in inside(p, kind) if q.splines]
    with at(p.name):
        return replace(value, **{q.name: meant(q, held) for q, held in asked}) if asked else value


def require_usable(ob, types):
    """Refuse an object that is not there; a deleted one lives on in no scene, because the mesh still uses it."""
    if ob is None:
        raise ShapeError("must be an object of the scene; none is chosen, or it was deleted")
    if ob.original.is_missing:  # Blender puts an empty in its place
        raise ShapeError(f"must be an object of the scene; {ob.name!r} is missing, of the file {ob.library.filepath!r}")
    if not (ob.library or ob.original.users_scene or ob.original.users_collection):
        raise ShapeError(f"must be an object of the scene; {ob.name!r} was deleted, or is in no scene yet")
    wanted, got = (text.lower().replace("font", "text") for text in (" or ".join(types), ob.type))
    require(ob.type in types, f"must be a {wanted} object", got)


@cache
def chosen_kinds(p):
    """The kinds of a union by the identifiers of their items."""
    return {spelled(kind, "_").upper(): kind for kind in p.kinds}


def objects(group, declared):
    """The objects that stand for values in a group, by the keys of their parameters: ``morph.2.contour`` in a list."""
    found = {
        p.name: getattr(group, f"{p.name}_object") for p in declared if p.accepts and getattr(group, p.name) == "OBJECT"
    }
    for p in (p for p in declared if p.item):
        for number, each in enumerate(getattr(group, p.name), 1):
            inner = objects(each, parameters(p.item))
            found |= {f"{p.name}.{number}.{key}": ob for key, ob in inner.items()}
    return found


def holder(group, key):
    """The group that holds a parameter, which may be in a list, and its name there."""
    *path, name = key.split(".")
    for listed_in, number in zip(path[::2], path[1::2], strict=True):
        group = getattr(group, listed_in)[int(number) - 1]
    return group, name


def assign(sweep, shape, **objects):
    """Make a mesh's parameters describe a shape, some of them given by objects, and rebuild once."""
    name = spelled(type(shape), "_")
    group = getattr(sweep, name)
    with at_once(sweep):
        sweep.kind = name.upper()
        write(group, parameters(type(shape)), shape)
        for key, ob in objects.items():
            held_by, name = holder(group, key)
            setattr(held_by, f"{name}_object", ob)
            setattr(held_by, name, "OBJECT")


@contextmanager
def at_once(sweep):
    """Change as much as you like of a sweep's parameters: it is rebuilt once, at the end."""
    sweep.paused = True
    try:
        yield
    finally:
        sweep.paused = False


def write(group, declared, value, prefix=""):
    """Set the properties of some parameters, and of a union only those of the chosen kind."""
    for p in declared:
        name, part = prefix + p.name, getattr(value, p.name)
        if p.item:
            held = getattr(group, name)
            held.clear()
            for item in part:
                write(held.add(), parameters(p.item), item)
            continue
        if p.type in ASIDE and not isinstance(group, bpy.types.Operator):
            texts.hold(group, p.name, part) if p.type in TEXTS else texts.turn(group, part)
            continue
        setattr(group, name, stored(p, part))
        if p.kinds:
            write(group, inside(p, type(part)), part, f"{name}_{spelled(type(part), '_')}_")

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Declared parameters as Blender properties, which `table` says: read and assign them."""

import json
from contextlib import contextmanager
from dataclasses import replace
from enum import EnumMeta
from functools import cache, lru_cache

import bpy
import numpy as np

from ..core.declared.coercing import coerce
from ..core.declared.parameters import ShapeError, at, inside, parameters, require, spelled
from ..core.declared.texts import ASIDE, TEXTS, Values
from ..core.later import later
from .table import stored

texts = later("bridge.texts")


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
    own = names_inside(p, name, held) if p.kinds else None
    return held if own is None else (held, *(raw(group, q, within) for q, within in own))


@cache
def names_inside(p, name, identifier):
    """The parameters of a chosen kind with the names of their properties; None where no kind is chosen."""
    kind = chosen_kinds(p).get(identifier)
    return kind and tuple((q, f"{name}_{identifier.lower()}_{q.name}") for q in inside(p, kind))


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

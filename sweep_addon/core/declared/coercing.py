# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Coercing: the value that is meant by what is given for a parameter, or what is wrong with it in one sentence."""

from contextlib import contextmanager, suppress
from enum import EnumMeta
from functools import cache
from math import inf
from numbers import Real
from typing import get_args, get_origin

import numpy as np

from .frozen import altered
from .names import spelled
from .parameters import LARGEST, Array, completed, inside, parameters, proven
from .refusals import MOST, ShapeError, at, require, together
from .wording import MEASURES, longest, named, shown


def coerce(p, value):
    """The value that was meant, or a `ShapeError`."""
    if value is None and p.default is None and p.shown is not None:  # it need not be given
        return None
    if p.type is float or p.type is int:
        return coerce_number(p, value)
    if p.kinds:
        return coerce_kind(p, value)
    if isinstance(p.type, EnumMeta):
        return coerce_option(p, value)
    if p.type is Array:
        return coerce_array(p, value)
    if p.item:
        return coerce_items(p, value)
    if get_origin(p.type) is tuple:
        first, *rest = get_args(p.type)
        require(isinstance(value, (list, tuple)) or getattr(value, "ndim", 0), "must be a list", value)
        require(rest == [...] or len(value) == 1 + len(rest), f"must be a list of {1 + len(rest)}", value)
        require_few(p, sum(max(1, rows(item)) for item in value))
        flat = p.columns and rest == [...] and len(value) and rows(value[0]) and not any(map(rows, value[0]))
        require(not flat, f"must be a list of lists of {p.columns} numbers each", value)
        part = altered(p, type=first)
        return tuple(coerce(part, item) for item in value)
    if hasattr(p.type, "coerced"):
        return p.type.coerced(value)
    require(isinstance(value, p.type), {bool: "must be true or false", str: "must be text"}[p.type], value)
    return value


def coerce_option(p, value):
    """A member of an Enum from itself, from its name, or from what the Enum takes for it."""
    if not isinstance(value, str):
        with suppress(ValueError, TypeError):  # TypeError: a list, of which no Enum can ask whether it is one of some
            return p.type(value)
    return pick({spelled(member): member for member in p.type}, value)


def coerce_number(p, value):
    number = isinstance(value, Real) and not isinstance(value, (bool, np.bool_)) and abs(value) < inf
    within = number and p.above < value <= min(p.maximum, LARGEST) and value >= max(p.minimum, -LARGEST)
    if not (within and (p.type is float or value % 1 == 0)):
        refuse_number(p, value, number)
    return p.type(value) + 0  # turns -0.0 to 0.0


def refuse_number(p, value, number):
    """Say which limit a number is beyond, or that it is none."""
    require(number, "must be a whole number" if p.type is int else f"must be {MEASURES[p.unit]}", value)
    require(abs(value) <= LARGEST, f"must be at most {LARGEST:g} in size", value)
    require(p.type is float or value % 1 == 0, "must be a whole number", value)
    require(value > p.above, f"must be more than {p.above:g}", value)
    require(value >= p.minimum, f"must be at least {p.minimum:g}", value)
    require(value <= p.maximum, f"must be at most {p.maximum:g}", value)


def require_few(p, size):
    """Refuse a long list before anything is done that takes time for each of its rows."""
    require(size <= p.most, f"must have {longest(p.most, p.columns, p.item)}", size)


def rows(value):
    """The length of what may stand for an array; 0 for anything else."""
    return len(value) if isinstance(value, (Array, list, tuple)) or getattr(value, "ndim", 0) else 0


def coerce_array(p, value):
    require_few(p, rows(value))
    try:
        array = array_of(p, value)
    except (TypeError, ValueError, OverflowError):
        array = None
    row = (p.columns,) if p.columns else ()
    fits = array is not None and array.values.ndim == 1 + len(row) and array.values.shape[1:] == row
    if not fits:
        from .hints import first_wrong

        needed = f"{p.columns} numbers each" if p.columns else "numbers"
        raise ShapeError(f"must be a list of {needed}, got {first_wrong(value, p.columns)}")
    wrong = ~(np.abs(array.values) <= LARGEST)
    if wrong.any():
        got = f"{array.values[wrong][0]:g} in row {np.argwhere(wrong)[0, 0] + 1}"
        raise ShapeError(f"must have finite numbers up to {LARGEST:g} in size, got {got}")
    return array


def has_truths(values):
    """Whether true or false is among numbers, or among those of rows."""
    rows = (each if isinstance(each, (list, tuple)) else (each,) for each in values)
    return any(item is True or item is False for row in rows for item in row)


def array_of(p, value):
    """An array from what has the form of one; with rows of none where nothing is what is meant by default."""
    if isinstance(value, (list, tuple)) and has_truths(value):
        raise TypeError  # else they would count as 1 and 0
    array = value if isinstance(value, Array) else Array(value)
    nothing = p.columns and not array.values.size and not len(p.default)
    return Array(np.zeros((0, p.columns))) if nothing else array


def coerce_items(p, value):
    """Declared values from themselves, from their tables, or from what they hold in the order of its declaration."""
    require(isinstance(value, (list, tuple)), "must be a list", value)
    require_few(p, len(value))
    declared, made, refused = parameters(p.item), [], []
    for number, item in enumerate(value, 1):
        try:
            made.append(coerce_item(p, declared, item))
        except ShapeError as error:
            refused.append(error.inside(f"{number}"))
            if len(refused) == MOST:
                break
    if refused:
        raise together(refused)
    return tuple(made)


def coerce_item(p, declared, item):
    if isinstance(item, (list, tuple)):
        require(len(item) <= len(declared), f"must have at most {len(declared)} values", len(item))
        item = {q.name: part for q, part in zip(declared, item, strict=False)}
    elif len(declared) == 1 and not isinstance(item, (dict, p.item)):
        item = {declared[0].name: item}
    return item if isinstance(item, p.item) else filled(p.item, declared, item)


def coerce_kind(p, value):
    """A kind from itself, from its name, from its table, or from the one value that is its shorthand."""
    if isinstance(value, p.kinds):
        return value
    names = names_of(p.kinds)
    if isinstance(value, str) and value in names:
        value = {"kind": value}
    with measured(p.unit):
        for form, kind in shorthands(p.kinds):
            if isinstance(value, form):
                return kind(value)
        if isinstance(value, dict):
            return from_table(names, value, lambda kind: inside(p, kind))
    return pick(names, value)


@cache
def names_of(kinds):
    """Kinds by their names."""
    return {spelled(kind): kind for kind in kinds}


@cache
def shorthands(kinds):
    """What stands for a kind, and for which."""
    forms = {float: Real, str: str, Array: (list, tuple, np.ndarray, Array)}
    return [(forms[q.type], kind) for kind in kinds for q in parameters(kind) if q.shorthand]


@contextmanager
def measured(unit):
    """Say in a refusal what a number would be, of a formula too: it may have been meant as one with its unit."""

    def said(refusal):
        sentence = refusal.sentence.replace("must be a number,", f"must be {MEASURES[unit]},")
        formula = f"must be {MEASURES[unit]} or an expression" if unit else "must be an expression"
        law = f"must be {MEASURES[unit]}, a formula in text or a list of points [t, value]"
        listed = "must be a list of 2 numbers each"
        return sentence.replace("must be an expression", formula).replace(listed, listed if refusal.key else law)

    try:
        yield
    except ShapeError as error:
        raise error.worded(said) from error.__cause__


def from_table(names, table, declared, beside=()):
    """A value from a table of plain values whose ``kind`` is one of the names.

    Other keys that people may have meant, which were taken out of it, are told of too.
    """
    table = dict(table)
    if "kind" not in table:
        from .hints import kindless  # nobody needs it until something is refused

        raise kindless(names, table)
    word = table.pop("kind")
    try:
        with at("kind"):
            kind = pick(names, word)
    except ShapeError as refusal:
        from .hints import unmistakable

        kind = unmistakable(names, word)
        if kind is None:
            raise
        raise together([refusal, *wrong_in(kind, declared(kind), table, beside)]) from None
    return filled(kind, declared(kind), table, beside)


def wrong_in(kind, declared, table, beside):
    """What is wrong with a table of a kind: its refusal, or nothing."""
    try:
        filled(kind, declared, table, beside)
    except ShapeError as refusal:
        return [refusal]
    return []


def filled(kind, declared, table, beside=()):
    """A value of a kind from a table of some of its parameters."""
    require(isinstance(table, dict), f"must be a table of {', '.join(q.name for q in declared)}", table)
    known = {q.name: q.default for q in declared}
    unknown = [key for key in table if key not in known]
    given = known | completed(kind, table)
    if not unknown:
        return kind(**given)
    from .hints import has_none

    refused = [ShapeError(f"is {has_none(kind.__name__, key, known, beside)}", named(key)) for key in unknown[:MOST]]
    try:
        proven(kind, **{key: given[key] for key in known})  # what goes together is not asked where one is missing
    except ShapeError as error:
        refused.append(error)
    raise together(refused)


def pick(names, value):
    if isinstance(value, str) and value in names:
        return names[value]
    from .hints import hint, one_of

    raise ShapeError(f"must be {one_of(names, value)}, got {shown(value)}{hint(names, value)}")

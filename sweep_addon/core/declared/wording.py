# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Wording: how people read values and limits of parameters, in refusals, tables and docstrings."""

import re
from dataclasses import fields, is_dataclass
from enum import Enum, EnumMeta
from functools import partial
from math import floor, inf, isfinite, log10
from types import GenericAlias, UnionType
from typing import get_args, get_origin

import numpy as np

from .frozen import WhenAsked
from .names import spelled

MEASURES = {None: "a number", "length": "a number of metres", "angle": "a number of radians"}
UNITS = {"length": "in metres", "angle": "in radians"}
LIMITS = {"above": -inf, "minimum": -inf, "maximum": inf}
REFUSED = "ShapeError\n    For any other value."
LONGEST = 40  # characters of a default in a docstring; of a longer one only how it starts


def shown(value):
    """A value as a refusal has room for it: one line of at most 60 characters.

    >>> shown(0.1 + 0.2), shown([1, 2]), shown(16**5000)
    ('0.3', '[1, 2]', '0x1000000000000000000000000000000000000000000000000000000...')
    """
    if isinstance(value, (list, tuple, str, bytes)):
        value = value[:60]  # no more is shown
    if isinstance(value, np.generic):
        value = value.item()  # which NumPy 1 and 2 write alike
    try:
        text = f"{value:.9g}" if isinstance(value, float) else repr(value)
    except (ValueError, RecursionError):  # Python writes no number of 5,000 digits, and no list as deep
        text = hex(value) if isinstance(value, int) else f"a {type(value).__name__}"
    line = " ".join(part.strip() for part in text.splitlines())
    return line if len(line) <= 60 else f"{line[:57]}..."


def near(u, start, end):
    """A place on a trajectory in four digits of its domain: what is 0 but for rounding is 0.

    >>> near(-6.561e-14, 0.0, 1.0), near(1570.796, 0.0, 6283.2), near(0.15652, -2.6, 2.6)
    ('0', '1571', '0.157')
    """
    return f"{round(float(u), 3 - floor(log10(abs(end - start)))) + 0.0:.9g}"


def named(key):
    """A key as a refusal names it: itself where it is a name that fits, or else as a value."""
    return key if isinstance(key, str) and re.fullmatch(r"[\w-]{1,60}", key) else shown(key)


def longest(most, columns, items=False):
    """How many rows or items a list may have, in words."""
    return f"at most {most} {'items' if items else 'points' if columns else 'numbers'}" if isfinite(most) else ""


def within(unit, above=-inf, minimum=-inf, maximum=inf, size=""):
    """Unit and limits in words.

    >>> within("m", above=0.0, maximum=10.0)
    'm, more than 0, at most 10'
    """
    said = [unit]
    said.append(f"more than {above:g}" if above >= minimum and isfinite(above) else "")
    said.append(f"at least {minimum:g}" if minimum > above else "")
    said.append(f"at most {maximum:g}" if isfinite(maximum) else "")
    return ", ".join(filter(None, (*said, size)))


def summary(kind):
    """The first line of the docstring of a declared class, without making the rest of it."""
    return vars(kind)["__doc__"].written.strip().partition("\n")[0]


class Documented(WhenAsked):
    """The docstring of a declared class, as it is written and with what its fields say."""

    def __init__(self, written):
        super().__init__(partial(documented, written))
        self.written = written


def documented(doc, cls):
    """A docstring of a declared class, with sections of what its fields say, for they say it already.

    What is refused beyond the limits of single fields, the docstring of its ``check`` says.
    """
    declared = fields(cls)
    if not declared:
        return doc
    told = f"\n\nParameters\n----------\n{''.join(map(entry, declared))}\nRaises\n------\n{REFUSED}\n"
    check = getattr(cls, "check", None)
    if check and check.__doc__:
        told += f"    {check.__doc__.replace('Refuse', 'For', 1)}\n"
    indent = doc[len(doc.rstrip(" ")) :]  # before the quotes that end it
    return doc.rstrip() + told.replace("\n", f"\n{indent}")


def entry(field):
    """A parameter in a docstring: name, type, unit, limits and default, and below that what it means."""
    told, default = field.metadata, field.default
    default = repr(spelled(default) if isinstance(default, Enum) else default)
    default = default if len(default) <= LONGEST else f"{default[: LONGEST - 4]} ..."
    size = longest(told.get("most", inf), told.get("columns"), item_of(field.type))
    limits = within(UNITS.get(told.get("unit")), *(told.get(key, none) for key, none in LIMITS.items()), size)
    limits = f"{limits}, " if limits else ""
    return f"{field.name} : {typed(field.type, told)}, {limits}default {default}\n    {told['doc']}.\n"


def typed(type_, told):
    """The type of a parameter in a docstring."""
    if isinstance(type_, UnionType):
        return either([kind.__name__ for kind in get_args(type_)])
    if isinstance(type_, EnumMeta):
        return either([repr(spelled(member)) for member in type_])
    if item_of(type_):
        return f"sequence of {item_of(type_).__name__}"
    row = f"(n, {told['columns']}) float array" if "columns" in told else "(n,) float array"
    if get_origin(type_) is tuple:
        first, *rest = get_args(type_)
        return f"sequence of {row}s" if rest == [...] else f"sequence of {1 + len(rest)} {first.__name__}s"
    return row if type_.__name__ == "Array" else type_.__name__


def item_of(type_):
    """The declared class of which values of a type are lists, or None."""
    inner = type_.__args__ if isinstance(type_, GenericAlias) else ()
    return inner[0] if inner and is_dataclass(inner[0]) else None


def either(names):
    return " or ".join(filter(None, (", ".join(names[:-1]), names[-1])))

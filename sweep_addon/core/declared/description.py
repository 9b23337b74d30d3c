# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Descriptions: what a shape may be told, as rows for people and as a JSON Schema for editors."""

import json
from dataclasses import replace
from enum import EnumMeta
from math import inf, isfinite
from typing import NamedTuple, get_args, get_origin

from .forms import VERSION, plain, scalar, tidy
from .parameters import Array, inside, parameters, spelled
from .texts import Grammar, Program, Values
from .wording import longest, summary, within

WORDS = {Grammar: "text", Program: "text", Values: "table of numbers"}
TEXT = {"type": "string"}
SCHEMAS = {Grammar: TEXT, Program: TEXT, Values: {"type": "object", "additionalProperties": {"type": "number"}}}
UNITS = {None: "", "length": "m", "angle": "rad"}


class Row(NamedTuple):
    """One parameter for people."""

    key: str
    takes: str
    limits: str
    default: object
    doc: str


def describe(cls):
    """What a shape or a kind may be told.

    Parameters
    ----------
    cls : class
        A declared class.

    Returns
    -------
    iterator of Row
        The parameters in the order of their declaration, after each choice those of its kinds, whose keys name the
        kind: ``contour(circle).radius`` is ``radius`` in the table ``contour`` of a job, whose kind is a circle.

    Examples
    --------
    >>> from sweep_addon.core.contours import Circle
    >>> [tuple(row)[:4] for row in describe(Circle)][0]
    ('radius', 'number', 'm, more than 0', 1.0)
    """
    return rows(parameters(cls), "")


def markdown(cls):
    """What a shape or a kind may be told, as a table for the docs.

    >>> from sweep_addon.core.contours import Circle
    >>> print(markdown(Circle).splitlines()[2])
    | `radius` | number, m, more than 0 | 1.0 | Distance of the points from the centre |
    """
    lines = ["| parameter | takes | default | meaning |", "|---|---|---|---|"]
    for row in describe(cls):
        took = ", ".join(filter(None, (row.takes, row.limits))).replace("|", "or")
        default = "" if row.default is None else toml_value(row.default)
        lines.append(f"| `{row.key}` | {took} | {default} | {row.doc} |")
    return "\n".join(lines)


def toml_value(value):
    """A default as a table has room for it: of a long list only how it starts."""
    text = json.dumps(value) if isinstance(value, (str, dict)) else tidy(value, scalar, 0)
    return text if len(text) <= 40 else f"{text[:36]} ..."


def rows(declared, path):
    for p in declared:
        yield Row(path + p.name, takes(p), limits(p), short(p), p.doc)
        for q in parameters(p.item) if p.item else ():  # whose kinds are told of where they are first chosen from
            yield Row(f"{path}{p.name}[].{q.name}", takes(q), limits(q), short(q), q.doc)
        for kind in p.kinds:
            if not shorthand(kind):
                yield from rows(inside(p, kind), f"{path}{p.name}({spelled(kind)}).")


def short(p):
    """The default of a parameter, of a choice its kind alone."""
    default = plain(p.default)
    return default["kind"] if p.kinds and isinstance(default, dict) else default


def shorthand(kind):
    """The parameter whose value stands for its kind, or None."""
    return next((p for p in parameters(kind) if p.shorthand), None)


def takes(p):
    """What a parameter takes, in words: names to choose from, or a kind of value."""
    if p.kinds:
        held = {kind: f" ({takes(shorthand(kind))})" if shorthand(kind) else "" for kind in p.kinds}
        return " | ".join(spelled(kind) + value for kind, value in held.items())
    if isinstance(p.type, EnumMeta):
        return " | ".join(spelled(member) for member in p.type)
    if p.item:
        return f"list of tables of {', '.join(q.name for q in parameters(p.item))}"
    row = f"lists of {p.columns} numbers" if p.columns else "numbers"
    if p.type is Array:
        return f"list of {row}"
    if get_origin(p.type) is tuple:
        inner = get_args(p.type)
        return f"list of lists of {row}" if inner[1:] == (...,) else f"list of {len(inner)} numbers"
    if hasattr(p.type, "coerced"):
        return WORDS.get(p.type, "shape, solid or tree")
    return {int: "whole number", float: "number", bool: "true | false", str: "text"}[p.type]


def limits(p):
    """Unit and limits in words: ``m, more than 0, at most 10``."""
    numeric = p.type in (int, float) or p.is_list or p.kinds or get_origin(p.type) is tuple
    return within(UNITS[p.unit] if numeric else "", p.above, p.minimum, p.maximum, longest(p.most, p.columns, p.item))


def schema(shapes):
    """A JSON Schema of the jobs that describe one of some shapes.

    Parameters
    ----------
    shapes : tuple of shape classes

    Returns
    -------
    dict
        JSON Schema 2020-12; editors complete and check a job by it.

    Examples
    --------
    >>> from sweep_addon.core.shapes.kinds import SHAPES
    >>> schema(SHAPES)["anyOf"][0]["properties"]["height"]["type"]
    'number'
    """
    version = {"const": VERSION, "description": "Version of the format"}
    forms = [table_schema(shape, parameters(shape), {"version": version}) for shape in shapes]
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": "Sweep job", "anyOf": forms}


def table_schema(kind, declared, before=None):
    """The schema of the table of one kind."""
    known = {**(before or {}), "kind": {"const": spelled(kind)}, **{p.name: value_schema(p) for p in declared}}
    return table_of(known, summary(kind)) | {"required": ["kind"]}


def table_of(known, description):
    """The schema of a table that may hold what is known."""
    return {"type": "object", "description": description, "properties": known, "additionalProperties": False}


def value_schema(p):
    """The schema of the value of one parameter."""
    said = {"description": ", ".join(filter(None, (p.doc, limits(p))))}
    said |= {} if p.default is None else {"default": plain(p.default)}
    if not p.kinds:
        return said | type_schema(p)
    tables = [table_schema(kind, inside(p, kind)) for kind in p.kinds]
    values = [type_schema(shorthand(kind)) for kind in p.kinds if shorthand(kind)]
    return said | {"anyOf": [*values, {"enum": [spelled(kind) for kind in p.kinds]}, *tables]}


def type_schema(p):
    if isinstance(p.type, EnumMeta):
        return {"enum": [spelled(member) for member in p.type]}
    if p.item:
        table = table_of({q.name: value_schema(q) for q in parameters(p.item)}, summary(p.item))
        return {"type": "array", "items": table} | ({"maxItems": p.most} if isfinite(p.most) else {})
    if hasattr(p.type, "coerced"):
        return SCHEMAS.get(p.type, {"type": "object", "required": ["kind"]})
    if p.type is Array:
        row = {"type": "array", "items": {"type": "number"}, "minItems": p.columns, "maxItems": p.columns}
        most = {"maxItems": p.most} if isfinite(p.most) else {}
        return {"type": "array", "items": row if p.columns else {"type": "number"}} | most
    if get_origin(p.type) is tuple:
        inner = get_args(p.type)
        if inner[1:] == (...,):
            return {"type": "array", "items": type_schema(replace(p, type=inner[0], most=inf))}
        return {"type": "array", "items": {"type": "number"}, "minItems": len(inner), "maxItems": len(inner)}
    bounds = {"exclusiveMinimum": (p.above, -inf), "minimum": (p.minimum, -inf), "maximum": (p.maximum, inf)}
    named = {int: "integer", float: "number", bool: "boolean", str: "string"}[p.type]
    return {"type": named} | {word: bound for word, (bound, none) in bounds.items() if bound != none}

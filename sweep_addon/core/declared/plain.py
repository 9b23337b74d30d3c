# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The plain form of a value between Python, job files and Blender: the tables, lists, numbers and text of TOML."""

from collections.abc import Mapping
from dataclasses import is_dataclass
from enum import Enum

from .parameters import Array, parameters, spelled

MIGRATIONS = ()  # MIGRATIONS[i] turns the table of a job of version i + 1 into one of version i + 2
VERSION = len(MIGRATIONS) + 1


def plain(value):
    """A value as a job holds it: shorthand where there is one, a bare name for a kind without parameters.

    >>> from sweep_addon.core.variation.laws import Formula
    >>> plain(Formula("1 - t"))
    '1 - t'
    """
    if isinstance(value, Enum):
        return spelled(value)
    if isinstance(value, Array):
        return value.values.tolist()
    if isinstance(value, tuple):
        return [held(item) if is_dataclass(item) else plain(item) for item in value]
    if isinstance(value, Mapping):
        return dict(value)
    if not is_dataclass(value):
        return value
    table = held(value)
    bare = [table[p.name] for p in parameters(type(value)) if p.shorthand]
    return bare[0] if bare else {"kind": spelled(type(value)), **table} if table else spelled(type(value))


def held(value):
    """The parameters of a declared value, plain."""
    return {p.name: plain(getattr(value, p.name)) for p in parameters(type(value))}

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts of grammars and of programs, and values for the constants in them, as parameters of a shape."""

from collections.abc import Mapping
from numbers import Real
from os import PathLike
from sys import float_info

from .parameters import ShapeError, require
from .refusals import together
from .wording import named, shown


class Text(str):
    """A text whose lines end as on any machine, which whoever needs what it says reads."""

    __slots__ = ()
    of = ""  # what it is the text of, for refusals

    @classmethod
    def coerced(cls, value):
        """The text from a text."""
        way = ", as .read_text() of a path gives" if isinstance(value, PathLike) else ""
        require(isinstance(value, str), f"must be the text of a {cls.of}{way}", value)
        return cls(value.replace("\r\n", "\n").replace("\r", "\n"))


class Program(Text):
    """The text of a program of a machine.

    >>> Program.coerced("G0 X1\\r\\n")
    'G0 X1\\n'
    """

    __slots__ = ()
    of = "program"


class Grammar(Text):
    """The text of a grammar; from an `LSystem` it is the system's own.

    >>> Grammar.coerced("axiom: F\\r\\n")
    'axiom: F\\n'
    """

    __slots__ = ()
    of = "grammar"

    @classmethod
    def coerced(cls, value):
        """The text from a text or a system."""
        return super().coerced(str(value) if hasattr(value, "axiom") else value)


class Values(Mapping):
    """Numbers by name, which compare and hash by what they are.

    >>> Values.coerced({"r": 1}) == Values.coerced({"r": 1.0})
    True
    """

    def __init__(self, values=()):
        self.held = dict(values)

    @classmethod
    def coerced(cls, value):
        """Values from a table of numbers."""
        require(isinstance(value, Mapping), "must be a table of numbers", value)
        wrong = [
            ShapeError(f"must be a number, got {shown(number)}", named(name))
            for name, number in value.items()
            if not isinstance(number, Real) or isinstance(number, bool) or not abs(number) <= float_info.max
        ]
        if wrong:
            raise together(wrong)
        return cls({str(name): float(number) + 0.0 for name, number in value.items()})

    def __getitem__(self, name):
        return self.held[name]

    def __iter__(self):
        return iter(self.held)

    def __len__(self):
        return len(self.held)

    def __hash__(self):
        return hash(frozenset(self.held.items()))

    def __repr__(self):
        return repr(dict(sorted(self.held.items())))


TEXTS = (Grammar, Program)
ASIDE = (*TEXTS, Values)  # which a group of Blender holds otherwise than an operator

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Constants of a grammar: formulas of numbers and of each other, with what a slider of them needs."""

import re
from contextlib import suppress
from graphlib import CycleError, TopologicalSorter

from ...declared.frozen import frozen
from ...formulas.expressions import Expression
from .modules import NAME
from .passages import Passage, PassageError, shown
from .vocabulary import formula, without_degree, words

NUMBER = r"([-+]?(?:\d++(?:\.(?!\.)\d*+)?|\.(?!\.)\d++)(?:[eE][-+]?\d++)?)"  # the dots between two are no part of one
RANGE = re.compile(rf"\s*+{NUMBER}\s*+\.\.\s*+{NUMBER}(?:\s++(.*))?")
UNITS = {"deg": "angle", "degree": "angle", "degrees": "angle", "m": "length", "metre": "length", "metres": "length"}


@frozen
class Constant:
    """A ``#define``.

    Attributes
    ----------
    name : str
    formula : Expression
        Of numbers, and of other constants.
    value : float
    low, high : float or None
        The range that its comment begins with, as ``# 0.5 .. 1.2 deg what it is``.
    unit : str
        "angle" or "length" where the comment goes on with deg or m, else nothing.
    doc : str
        The rest of the comment.
    """

    name: str
    formula: Expression
    value: float
    low: float | None = None
    high: float | None = None
    unit: str = ""
    doc: str = ""

    def __str__(self):
        told = [f"{self.low:.9g} .. {self.high:.9g}"] if self.low is not None else []
        told += [{"angle": "deg", "length": "m"}[self.unit]] if self.unit else []
        told += [self.doc] if self.doc else []
        return f"#define {self.name} {self.formula.text}" + (f"  # {' '.join(told)}" if told else "")


def constants(definitions, given):
    """All constants of a text, which may need each other in any order.

    Parameters
    ----------
    definitions : list of (Passage, str)
        What follows each ``#define``, and its comment.
    given : dict of str to float
        Values that stand for those of the text.

    Returns
    -------
    tuple of Constant
    list of Problem

    Examples
    --------
    >>> lines = [Passage("h (p*q)^0.5", 1), Passage("q 1 - p", 2), Passage("p 0.5", 3)]
    >>> [constant.value for constant in constants([(line, "") for line in lines], {})[0]]
    [0.5, 0.5, 0.5]
    """
    problems, named = [], {}
    for passage, comment in definitions:
        try:
            name, text = parted(passage)
            if name in named:
                passage.refuse("each constant once", 0, shown(name))
            named[name] = text, comment
        except PassageError as wrong:
            problems.append(wrong.problem)
    values, made, vocabulary = {}, {}, words({}, random=False)
    for name, known in in_order({name: needed(text) & named.keys() for name, (text, _) in named.items()}):
        text, comment = named[name]
        try:
            if not known:
                text.refuse("constants that do not need each other", 0, shown(name))
            read = formula(text, values, vocabulary)
            number = float(read.run(values))
            if not abs(number) < float("inf"):
                text.refuse("a finite number", 0, f"{number:g}")
            if name in given:
                number = given[name]
                read = Expression(repr(number), (), (number,))
            values[name] = number
            made[name] = Constant(name, read, values[name], *slider(comment))
        except PassageError as wrong:
            problems.append(wrong.problem)
            values[name] = 1.0  # so that no further line is refused for it
    return tuple(made[name] for name in named if name in made), problems


def in_order(needs):
    """Names, each behind those that it needs, and whether it is; those that need each other come last."""
    sorter, left = TopologicalSorter(needs), dict.fromkeys(needs)
    with suppress(CycleError):  # which does not keep it from telling those that are in none
        sorter.prepare()
    while ready := sorter.get_ready():
        for name in ready:
            del left[name]
            yield name, True
        sorter.done(*ready)
    yield from ((name, False) for name in left)


def parted(passage: Passage):
    """The name and the formula of a definition."""
    match = NAME.match(passage.text)
    if not match:
        passage.refuse("a name and its value")
    text = passage.part(match.end())
    if passage.text[match.end() : match.end() + 1] == "(":
        text.refuse("a value, for macros are of the dialect cpfg")
    return match.group(), without_degree(text)


def needed(passage):
    """The names that a formula may need."""
    return set(NAME.findall(passage.text))


def slider(comment):
    """The range, unit and doc in the comment of a definition."""
    match = RANGE.fullmatch(comment)
    try:
        low, high, rest = float(match[1]), float(match[2]), match[3] or ""
    except (TypeError, ValueError):
        return None, None, "", comment.strip()
    first, _, others = rest.partition(" ")
    return (low, high, UNITS[first], others.strip()) if first in UNITS else (low, high, "", rest.strip())

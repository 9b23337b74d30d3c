# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Statements: variables of a whole derivation, which get values before it, around each of its steps, and behind it.

Source
------
Prusinkiewicz, Hanan, Mech, Karwowski: L-studio/cpfg User's Manual, 1999: Start, StartEach, EndEach and End.
"""

import numpy as np

from ...declared.frozen import frozen
from ...declared.parameters import ShapeError
from ...formulas.expressions import DRAW, Expression
from ..text.modules import NAME
from ..text.passages import shown
from ..text.vocabulary import draws, formula, words
from .draws import even, root

BLOCKS = ("start", "start_each", "end_each", "end")
MOMENTS = 400  # where moments of the blocks begin, in each step
MOST_VARIABLES, MOST_STATEMENTS = 1000, 1000  # of a text, and of a line


@frozen
class Statement:
    """An assignment: ``n = n + 1``.

    Attributes
    ----------
    name : str
    formula : Expression
        Of variables and constants.
    line : int
        Where it stands in its text, from 1.
    """

    name: str
    formula: Expression
    line: int = 0

    def __str__(self):
        return f"{self.name} = {self.formula.text}"


def parts(passage):
    """The passages between semicolons; a pair of braces around them is passed over."""
    text = passage.text
    if text.startswith("{") and text.endswith("}"):
        passage = passage.part(1, len(text) - 1)
    found, begin = [], 0
    for at, letter in enumerate(f"{passage.text};"):
        if letter == ";":
            found.append(passage.part(begin, at))
            begin = at + 1
    found = [part for part in found if part.text]
    if len(found) > MOST_STATEMENTS:
        passage.refuse(f"at most {MOST_STATEMENTS} statements in a line", 0, f"{len(found)}")
    return found


def assigned(passage):
    """The names that get values in a passage, and the passages of their formulas."""
    found = []
    for part in parts(passage):
        match = NAME.match(part.text)
        rest = part.text[match.end() :].lstrip() if match else ""
        if not rest.startswith("=") or rest.startswith("=="):
            part.refuse("a variable and its value, as n = n+1", 0, shown(part.text))
        found.append((match.group(), part.part(len(part.text) - len(rest) + 1)))
    return found


def statements(passage, variables, constants):
    """The statements in a passage.

    Parameters
    ----------
    passage : Passage
    variables : tuple of str
        Those of the whole text.
    constants : dict of str to float

    Returns
    -------
    tuple of Statement
    """
    made, drawn = [], 0
    for name, text in assigned(passage):
        if name in constants:
            text.refuse("a variable, for a constant stays what it is", 0, shown(name))
        read = formula(text, variables, words(constants), drawn)
        drawn += draws(read.names)
        made.append(Statement(name, read, passage.number))
    return tuple(made)


def names(system):
    """The variables of a system, in the order in which they get values."""
    return tuple(dict.fromkeys(each.name for block in BLOCKS for each in getattr(system, block)))


def executed(system, block, values, generation, moment, seed):
    """The values of variables after the statements of a block.

    Parameters
    ----------
    system : LSystem
    block : str
    values : dict of str to float
    generation, moment, seed : int
        Which random numbers there are.

    Returns
    -------
    dict of str to float
    """
    values = dict(values)
    for statement in getattr(system, block):
        drawn = {
            name: even(root(seed), moment + MOMENTS + BLOCKS.index(block), 1 + int(name.removeprefix(DRAW)))[0]
            for name in statement.formula.names
            if name.startswith(DRAW)
        }
        number = float(statement.formula.run(values | drawn))
        if not np.isfinite(number):
            where = f"line {statement.line}: " if statement.line else ""
            told = f"{where}{statement.name} must be a finite number, got {number:g} in generation {generation}"
            raise ShapeError(told, "statements")
        values[statement.name] = number
    return values

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The words of formulas in grammars: angles in degrees as in the book, constants of the text, and random numbers.

The formulas themselves are those of laws: `core.formulas.expressions` reads both.
"""

import re
from collections import ChainMap

import numpy as np

from ...formulas.expressions import DRAW, MisreadError, read
from ...formulas.functions import CONSTANTS, FUNCTIONS, Vocabulary
from .passages import Passage


def normal(mean, deviation, first, second):
    """Numbers with a normal distribution, of two even ones (Box and Muller 1958)."""
    return mean + deviation * np.sqrt(-2 * np.log(1 - first)) * np.cos(2 * np.pi * second)


DEGREES = {
    "sin": (lambda angle: np.sin(np.radians(angle)), 1, 1),
    "cos": (lambda angle: np.cos(np.radians(angle)), 1, 1),
    "tan": (lambda angle: np.tan(np.radians(angle)), 1, 1),
    "asin": (lambda x: np.degrees(np.arcsin(x)), 1, 1),
    "acos": (lambda x: np.degrees(np.arccos(x)), 1, 1),
    "atan": (lambda x: np.degrees(np.arctan(x)), 1, 1),
    "atan2": (lambda y, x: np.degrees(np.arctan2(y, x)), 2, 2),
}
RANDOM = {
    "ran": (lambda most, drawn: most * drawn, 1, 1, 1),
    "nran": (normal, 2, 2, 2),
}
DEGREE = re.compile(r"[\d.]\s*°$", re.ASCII)
IN_DEGREES = FUNCTIONS | DEGREES
WITH_CHANCE = IN_DEGREES | RANDOM


def words(constants, random=True):
    """What a formula of a grammar may say beside its parameters.

    Parameters
    ----------
    constants : dict of str to float
        Those of the text; they hide others of the same name.
    random : bool
        Whether it may draw random numbers: where a module becomes others it may, constants of the text may not.
    """
    return Vocabulary(ChainMap(constants, CONSTANTS), WITH_CHANCE if random else IN_DEGREES)


def formula(passage: Passage, names, vocabulary, drawn=0):
    """The expression in a passage.

    Raises
    ------
    PassageError
        With the place of what is wrong in its line.
    """
    if not passage.text:
        passage.refuse("a value")
    try:
        return read(passage.text, names, vocabulary, drawn)
    except MisreadError as misread:
        passage.refuse(misread.expected, misread.place, misread.found or "the end of the formula")


def without_degree(passage):
    """A passage without the degree sign behind its last number: angles are in degrees anyway.

    >>> without_degree(Passage("22.5 °", 1)).text
    '22.5'
    """
    return passage.part(0, len(passage.text) - 1) if DEGREE.search(passage.text) else passage


def value(passage, vocabulary):
    """The number in a passage, which may be a formula of constants."""
    number = float(formula(passage, (), vocabulary).run({}))
    if not np.isfinite(number):
        passage.refuse("a finite number", 0, f"{number:g}")
    return number


def draws(names):
    """How many of the names of an expression are random numbers."""
    return sum(name.startswith(DRAW) for name in names)

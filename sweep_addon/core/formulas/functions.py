# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions: the constants, functions and operators that an expression may use; there are no others."""

from functools import reduce
from math import e, pi, tau

import numpy as np

MOST = 2000  # values of a function that takes any number; a text is shorter

CONSTANTS = {"pi": pi, "tau": tau, "e": e}


class Question:
    """An operator whose answer counts: 1 where it holds, 0 elsewhere.

    Parameters
    ----------
    asked : callable
        Gives bools.
    of_answers : callable, optional
        What gives the same, sooner, where all that it takes are bools.
    """

    def __init__(self, asked, of_answers=None):
        self.asked, self.of_answers = asked, of_answers or asked

    def __call__(self, *values):
        return self.asked(*values).astype(np.float64)


def either(one, other):
    """Whether one of two is not 0; that is looked at before they are combined, which floats are slowly."""
    return np.not_equal(one, 0) | np.not_equal(other, 0)


def both(one, other):
    """Whether neither of two is 0."""
    return np.not_equal(one, 0) & np.not_equal(other, 0)


def neither(value):
    """Whether a value is 0."""
    return np.equal(value, 0)


def power(base, exponent):
    """A power; a square is a product, which is rounded alike in arrays and in numbers, and by every NumPy."""
    return base * base if isinstance(exponent, float) and exponent == 2 else np.power(base, exponent)


def clamp(x, low, high):
    """x where it lies between the limits, else the nearer limit."""
    return np.minimum(np.maximum(x, low), high)


def smoothstep(low, high, x):
    """0 up to low, 1 from high on, and the cubic without kinks between."""
    x = clamp((x - low) / (high - low), 0.0, 1.0)
    return x * x * (3 - 2 * x)


FUNCTIONS = {  # name: function, fewest and most values; where it draws random numbers, how many
    **{name: (getattr(np, name), 1, 1) for name in "sin cos tan sinh cosh tanh sqrt exp log log10".split()},
    **{name: (getattr(np, name), 1, 1) for name in "abs floor ceil trunc round sign".split()},
    "asin": (np.arcsin, 1, 1),
    "acos": (np.arccos, 1, 1),
    "atan": (np.arctan, 1, 1),
    "atan2": (np.arctan2, 2, 2),
    "min": (lambda *values: reduce(np.minimum, values), 2, MOST),
    "max": (lambda *values: reduce(np.maximum, values), 2, MOST),
    "mod": (np.mod, 2, 2),
    "pow": (power, 2, 2),
    "clamp": (clamp, 3, 3),
    "lerp": (lambda start, end, x: start + (end - start) * x, 3, 3),
    "smoothstep": (smoothstep, 3, 3),
    "if": (lambda condition, yes, no: np.where(condition, yes, no), 3, 3),
}

NEGATION, COMPARISON, SIGN, POWER = 3, 4, 7, 8  # how closely an operator binds: the higher, the closer

PREFIX = {
    "not": (NEGATION, Question(neither, np.logical_not)),
    "!": (SIGN, Question(neither, np.logical_not)),
    "-": (SIGN, np.negative),
    "+": (SIGN, np.positive),
}
INFIX = {  # & | = are what "The Algorithmic Beauty of Plants" prints
    "||": (1, Question(either, np.logical_or)),
    "|": (1, Question(either, np.logical_or)),
    "or": (1, Question(either, np.logical_or)),
    "&&": (2, Question(both, np.logical_and)),
    "&": (2, Question(both, np.logical_and)),
    "and": (2, Question(both, np.logical_and)),
    "<": (COMPARISON, Question(np.less)),
    "<=": (COMPARISON, Question(np.less_equal)),
    ">": (COMPARISON, Question(np.greater)),
    ">=": (COMPARISON, Question(np.greater_equal)),
    "==": (COMPARISON, Question(np.equal)),
    "=": (COMPARISON, Question(np.equal)),
    "!=": (COMPARISON, Question(np.not_equal)),
    "+": (5, np.add),
    "-": (5, np.subtract),
    "*": (6, np.multiply),
    "/": (6, np.divide),
    "%": (6, np.mod),
    "^": (POWER, power),
    "**": (POWER, power),
}


class Vocabulary:
    """The constants and functions that texts of one kind may use; operators are the same everywhere."""

    def __init__(self, constants=CONSTANTS, functions=FUNCTIONS):
        self.constants, self.functions = constants, functions


LAWS = Vocabulary()

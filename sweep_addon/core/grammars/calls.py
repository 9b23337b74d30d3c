# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Productions that are Python functions: they take arrays of parameters and return what modules become.

No file can hold one; a program adds it to a system that was read.
"""

from dataclasses import replace
from inspect import signature

import numpy as np

from ..declared.frozen import frozen
from ..declared.parameters import ShapeError, require
from .text.modules import MOST_PARAMETERS, Alphabet, Letter, Module, paired
from .text.passages import Passage, PassageError
from .text.problems import GrammarError
from .text.productions import EMPTY, patterned


@frozen
class Called:
    """A parameter of a successor that a function computes; it stands where an `Expression` does.

    Attributes
    ----------
    function : callable
    place, column : int
        Which parameter of which module of its result.
    names : tuple of str
        The names of what it takes, in order.
    """

    function: object
    place: int
    column: int
    names: tuple

    text = "?"

    @property
    def program(self):
        return self.function, self.place, self.column

    def run(self, values):
        """The value for all modules at once."""
        return listed(self.function(*(values[name] for name in self.names)))[self.place][1 + self.column]


def takes(function, count):
    """Whether a function takes so many parameters; what says nothing of itself, as some of NumPy's, may."""
    try:
        signature(function).bind(*(None,) * count)
    except TypeError:
        return False
    except ValueError:
        return True
    return True


def told(names):
    """What a function must take.

    >>> told(("x", "y")), told(())
    ('the parameters x, y of the head', 'no parameters, as the head has none')
    """
    return f"the parameters {', '.join(names)} of the head" if names else "no parameters, as the head has none"


def listed(result):
    """What a function returned, each module as a tuple of its name and its parameters."""
    require(isinstance(result, (list, tuple)), "must return a list of modules", result, "function")
    return [(module,) if isinstance(module, str) else tuple(module) for module in result]


def with_production(system, head, function):
    """A system with one more production; `LSystem.with_production` says of what."""
    require(callable(function), "must be a function", function, "function")
    require(isinstance(head, str), "must be text", head, "head")
    constants = {constant.name: constant.value for constant in system.constants}
    alphabet = Alphabet(system.names)
    try:
        rule, names = patterned(Passage(f"{head} -> {EMPTY}", 1), alphabet, constants)
        if not takes(function, len(names)):
            raise ShapeError(f"must take {told(names)}, got one that takes {signature(function)}", "function")
        made = listed(function(*(np.ones(1) for _ in names)))
        successor = tuple(module(function, place, each, names, alphabet) for place, each in enumerate(made))
        letters = [Letter(each.name, 0, ()) for each in successor]
        paired(Passage("".join(each.name for each in successor), 1), letters)
    except PassageError as wrong:
        raise GrammarError([wrong.problem]) from None
    return replace(system, productions=(*system.productions, replace(rule, successor=successor)))


def module(function, place, told, names, alphabet):
    """A module of a function's result, whose parameters are computed when it is asked for."""
    name, *parameters = told
    letters = alphabet.letters(Passage(name, 1)) if isinstance(name, str) else ()
    require(len(letters) == 1 and not letters[0].arguments, "must return names of single modules", name, "function")
    if len(parameters) > MOST_PARAMETERS:
        raise ShapeError(f"must return at most {MOST_PARAMETERS} parameters, got {len(parameters)}", "function")
    return Module(letters[0].name, tuple(Called(function, place, column, names) for column in range(len(parameters))))

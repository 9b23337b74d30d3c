# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Expressions: the one small language for formulas, of numbers, documented names and functions, and nothing else.

A text comes from strangers. It is read into a tree by the tables of `functions` and kept in postfix order, so that
no attribute, call or name can be reached that is not in them, and evaluating it needs no recursion. All
numbers are floats: no power can grow beyond infinity, which is refused.
"""

import re
from functools import cached_property, lru_cache
from itertools import islice
from math import isfinite

import numpy as np

from ..declared.frozen import frozen
from ..declared.parameters import ShapeError, require
from .functions import COMPARISON, INFIX, LAWS, NEGATION, POWER, PREFIX
from .plans import Plan

LONGEST = 2000  # characters of a text
DEEPEST = 100  # brackets, signs and powers inside one another
MOST_NAMES = 20  # that a refusal lists
DRAW = "draw "  # how the name of a random number begins; no text can say it

GREEK = "Α-Ωα-ω"  # letters that names may have too, as angles have in books
DIGITS = r"(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
NUMBER = re.compile(DIGITS, re.ASCII)
TOKEN = re.compile(
    rf"(?P<space>\s+)|(?P<number>{DIGITS})|(?P<name>[A-Za-z_{GREEK}][\w{GREEK}]*)"
    r"|(?P<symbol>\*\*|&&|\|\||[<>=!]=|[-+*/%^<>!(),&|=])|(?P<nothing>.)",
    re.ASCII | re.DOTALL,
)


class MisreadError(ShapeError):
    """A refusal of a text, with the place in it.

    Attributes
    ----------
    place : int
        The character that is wrong, from 0.
    found, expected : str
        What is there, and what would do.
    """

    def __init__(self, sentence, place, found, expected):
        super().__init__(sentence)
        self.place, self.found, self.expected = place, found, expected


@frozen
class Expression:
    """A text that was understood, ready to be evaluated.

    Attributes
    ----------
    text : str
        What it was read from.
    names : tuple of str
        The names it uses, each once; an expression without names is constant. Random numbers are names too: ``draw 0``.
    program : tuple
        The tree in postfix order: numbers, names, and functions with the number of values they take.
    """

    text: str
    names: tuple
    program: tuple

    def evaluate(self, **arrays):
        """The value for all samples at once.

        Parameters
        ----------
        **arrays : float arrays or numbers
            The value of each name; they broadcast. Names that are not used only say where a refusal is.

        Returns
        -------
        float array
            As large as the arrays broadcast together, also where the expression is constant.

        Raises
        ------
        ShapeError
            Where a value is not finite: it names the first such sample.
        """
        arrays = {name: np.asarray(values, dtype=np.float64) for name, values in arrays.items()}
        values = np.array(np.broadcast_arrays(self.run(arrays), *arrays.values())[0])
        return finite(values, **arrays)

    def run(self, values):
        """The value of the tree, by the names, for whatever NumPy can calculate with: numbers, arrays, or jets."""
        if not self.names:
            return self.constant
        with np.errstate(all="ignore"):
            return self.calculated([values[name] for name in self.names])

    @cached_property
    def constant(self):
        """The value of an expression without names."""
        with np.errstate(all="ignore"):
            return self.calculated(())

    def calculated(self, values):
        """The same of values in the order of the names, for who has told NumPy that no number is an error."""
        return self.plan.result(values)

    def answered(self, values):
        """The same, but of an expression that asks something bools."""
        return self.question.result(values)

    @cached_property
    def plan(self):
        return Plan(self.names, self.program)

    @cached_property
    def question(self):
        return Plan(self.names, self.program, number=False)


def compile(text, names):
    """Read an expression.

    Numbers, the given names, ``pi``, ``tau``, ``e``; ``+ - * /``, ``%`` with the sign of the divisor, ``^`` or ``**``
    from right to left and before a sign, so that ``-2^2`` is -4; comparisons, which are 1 or 0; ``&& || !`` or
    ``and or not``; ``= & |`` as other spellings of them; and the functions abs acos asin atan atan2 ceil clamp cos cosh
    exp floor if lerp log log10 max min mod pow round sign sin sinh smoothstep sqrt tan tanh trunc. ``if(condition, yes,
    no)`` chooses for each sample.

    Parameters
    ----------
    text : str
        At most 2,000 characters.
    names : iterable of str
        The names that the text may use; they hide constants of the same name.

    Returns
    -------
    Expression

    Raises
    ------
    ShapeError
        If the text is no such expression, with the place; or if it is constant and not finite.

    Examples
    --------
    >>> compile("1 - t^2/2", ["t"]).evaluate(t=[0, 1, 2]).tolist()
    [1.0, 0.5, -1.0]
    >>> try:
    ...     compile("1 - q", ["t"])
    ... except ShapeError as error:
    ...     print(error)
    must be an expression of t: 'q' at character 5 is no name (t, pi, tau, e are), got '1 - q'
    """
    require(isinstance(text, str), "must be text", text)
    return compiled(text, tuple(names))


@lru_cache(maxsize=256)
def compiled(text, names):
    expression = read(text, names)
    if not expression.names:
        expression.evaluate()
    return expression


def read(text, names, vocabulary=LAWS, drawn=0):
    """Read an expression in the words of a kind of texts; random numbers are counted on from those drawn before."""
    return plain(text) or Reader(text, names, vocabulary, drawn).read()


def plain(text):
    """The expression of a text that is one number, as most of grammars are; None of all others."""
    if not NUMBER.fullmatch(text) or len(text) > LONGEST or not isfinite(float(text)):
        return None
    return Expression(text, (), (float(text),))


class Reader:
    """Reads one text from left to right by operator precedence (Pratt 1973) and writes its postfix order."""

    def __init__(self, text, names, vocabulary, drawn):
        self.text, self.names, self.depth, self.program, self.used = text, names, 0, [], {}
        self.constants, self.functions, self.drawn = vocabulary.constants, vocabulary.functions, drawn
        if len(text) > LONGEST:
            long = f"{len(text)} characters"
            self.refuse(f"it is {long} long, at most {LONGEST} are allowed", 0, long, f"at most {LONGEST}")
        found = [match for match in TOKEN.finditer(text) if match.lastgroup != "space"]
        self.tokens = [(match.lastgroup, match.group(), match.start()) for match in found]
        self.tokens.append(("end", "", len(text)))
        self.tokens.reverse()

    def read(self):
        self.operation(0)
        if self.tokens[-1][0] != "end":
            self.missing("an operator")
        return Expression(self.text, tuple(self.used), tuple(self.program))

    def operation(self, least):
        """A value and the operators after it that bind at least so closely."""
        self.depth += 1
        if self.depth > DEEPEST:
            levels = f"more than {DEEPEST} levels"
            self.refuse(f"{levels}{self.here()}", self.tokens[-1][2], levels, "fewer brackets, signs and powers")
        self.value(least)
        compared = False
        while self.tokens[-1][1] in INFIX and INFIX[self.tokens[-1][1]][0] >= least:
            binds, function = INFIX[self.tokens[-1][1]]
            if compared and binds == COMPARISON:
                second = "a second comparison"
                self.refuse(f"{second}{self.here()} needs && or brackets", self.tokens[-1][2], second, "&& or brackets")
            compared = binds == COMPARISON
            self.tokens.pop()
            self.operation(binds if binds == POWER else binds + 1)
            self.program.append((function, 2))
        self.depth -= 1

    def value(self, least):
        kind, text, place = self.tokens[-1]
        if text in PREFIX and not (text == "not" and least > NEGATION):
            binds, function = PREFIX[text]
            self.tokens.pop()
            self.operation(binds)
            self.program.append((function, 1))
        elif text == "(":
            self.tokens.pop()
            self.operation(0)
            self.close()
        elif kind == "number":
            if not isfinite(float(text)):
                self.refuse(f"{shown(text, 20)}{self.here()} is too large", place, shown(text, 20), "a smaller number")
            self.program.append(float(text))
            self.tokens.pop()
        elif kind == "name" and text not in INFIX and text not in PREFIX:
            self.call() if self.tokens[-2][1] == "(" else self.name()
        else:
            self.missing("a value")

    def name(self):
        _, text, place = self.tokens[-1]
        if text not in self.names and text not in self.constants:
            known = few(dict.fromkeys((*self.names, *self.constants)))
            said, of = f"{shown(text, 20)}{self.here()} is no name ({known} are)", f"one of the names {known}"
            self.refuse(said, place, shown(text, 20), of)
        if text in self.names:
            self.used[text] = None
        self.program.append(text if text in self.names else self.constants[text])
        self.tokens.pop()

    def call(self):
        _, text, place = self.tokens[-1]
        if text not in self.functions:
            known = ", ".join(self.functions)
            said, of = f"{shown(text, 20)}{self.here()} is no function ({known} are)", f"one of the functions {known}"
            self.refuse(said, place, shown(text, 20), of)
        function, fewest, most, *draws = self.functions[text]
        del self.tokens[-2:]
        count = 1
        self.operation(0)
        while self.tokens[-1][1] == ",":
            self.tokens.pop()
            self.operation(0)
            count += 1
        self.close()
        if not fewest <= count <= most:
            takes = f"{fewest}" if fewest == most else f"at least {fewest}"
            said = f"{text} at character {place + 1} takes {takes} values, not {count}"
            self.refuse(said, place, f"{count} values", f"{takes} values of {text}")
        drawn = [f"{DRAW}{self.drawn + k}" for k in range(*draws)] if draws else []
        self.drawn += len(drawn)
        self.used |= dict.fromkeys(drawn)
        self.program += [*drawn, (function, count + len(drawn))]

    def close(self):
        if self.tokens[-1][1] != ")":
            self.missing("a closing bracket or an operator")
        self.tokens.pop()

    def missing(self, what):
        kind, text, place = self.tokens[-1]
        if kind == "nothing":
            self.refuse(f"{shown(text, 20)}{self.here()} has no meaning", place, shown(text, 20), what)
        before = f" before {shown(text, 20)}" if text else ""
        self.refuse(f"{what} is missing{self.here()}{before}", place, shown(text, 20) if text else "", what)

    def here(self):
        return f" at character {self.tokens[-1][2] + 1}"

    def refuse(self, what, place, found, expected):
        """Refuse the text and show no more than 40 characters of it, those around the place."""
        names = few(self.names) or "numbers"
        start = max(0, min(place - 20, len(self.text) - 34))
        near = ("..." if start else "") + self.text[start:]
        raise MisreadError(f"must be an expression of {names}: {what}, got {shown(near, 40)}", place, found, expected)


def few(names):
    """Names between commas, of many the first ones."""
    return ", ".join(islice(names, MOST_NAMES)) + (", ..." if len(names) > MOST_NAMES else "")


def shown(text, most):
    """A text in quotes, cut to so many characters."""
    quoted = repr(text)
    return quoted if len(quoted) <= most else quoted[: most - 4] + "..." + quoted[-1]


def finite(values, **places):
    """The values, or a refusal that says at which of the samples the first one is not finite."""
    wrong = np.flatnonzero(~np.isfinite(values))
    if wrong.size:
        first = {name: np.broadcast_to(given, values.shape).flat[wrong[0]] for name, given in places.items()}
        where = " at " + ", ".join(f"{name} = {place:.6g}" for name, place in first.items()) if first else ""
        raise ShapeError(f"must be finite everywhere, got {values.flat[wrong[0]]:g}{where}")
    return values

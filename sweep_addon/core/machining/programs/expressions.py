# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Expressions of programs: numbers, parameters, functions and operators, read once and calculated with what holds then.

What is read is a function of the machine's parameters; nothing of the text is ever run as code.
"""

import math
import re

from ...declared.refusals import ShapeError
from ...declared.wording import shown

NUMBER = re.compile(r"\d+\.?\d*|\.\d+", re.ASCII)
DEEPEST = 60  # values within values
LARGEST = 1e12
CLOSE = 1e-4  # what numbers may differ by and be equal, as LinuxCNC has it


def truth(value):
    return 1.0 if value else 0.0


def power(left, right):
    if left < 0 and right != math.floor(right):
        raise ValueError("a root of a negative number")
    return left**right


def modulo(left, right):
    rest = math.fmod(left, right)
    return rest + abs(right) if rest < 0 else rest


OPERATORS = {
    "**": (4, power),
    "*": (3, lambda a, b: a * b),
    "/": (3, lambda a, b: a / b),
    "mod": (3, modulo),
    "+": (2, lambda a, b: a + b),
    "-": (2, lambda a, b: a - b),
    "eq": (1, lambda a, b: truth(abs(a - b) < CLOSE)),
    "ne": (1, lambda a, b: truth(abs(a - b) >= CLOSE)),
    "gt": (1, lambda a, b: truth(a > b)),
    "ge": (1, lambda a, b: truth(a >= b or abs(a - b) < CLOSE)),
    "lt": (1, lambda a, b: truth(a < b)),
    "le": (1, lambda a, b: truth(a <= b or abs(a - b) < CLOSE)),
    "and": (0, lambda a, b: truth(a and b)),
    "or": (0, lambda a, b: truth(a or b)),
    "xor": (0, lambda a, b: truth(bool(a) != bool(b))),
}
FUNCTIONS = {
    "abs": abs,
    "acos": lambda x: math.degrees(math.acos(x)),
    "asin": lambda x: math.degrees(math.asin(x)),
    "cos": lambda x: math.cos(math.radians(x)),
    "exp": math.exp,
    "fix": math.floor,
    "fup": math.ceil,
    "ln": math.log,
    "round": lambda x: math.trunc(x + math.copysign(0.5, x)),
    "sin": lambda x: math.sin(math.radians(x)),
    "sqrt": math.sqrt,
    "tan": lambda x: math.tan(math.radians(x)),
}
OPERATOR = re.compile(r"\*\*|[-+*/]|mod|eq|ne|gt|ge|lt|le|and|xor|or")
NAME = re.compile("|".join(FUNCTIONS))


class Text:
    """A line without blanks and comments, in small letters, and how far it has been read."""

    def __init__(self, text):
        self.text, self.at, self.depth = text, 0, 0

    def __bool__(self):
        return self.at < len(self.text)

    def next(self):
        return self.text[self.at : self.at + 1]

    def take(self, what):
        """Whether the text goes on with this, which is then read."""
        found = self.text.startswith(what, self.at)
        self.at += len(what) * found
        return found

    def match(self, pattern):
        found = pattern.match(self.text, self.at)
        if found:
            self.at = found.end()
        return found

    def expect(self, what):
        if not self.take(what):
            raise ShapeError(f"needs {what!r} {self.place()}")

    def place(self):
        return f"before {shown(self.text[self.at :])}" if self else "at its end"


def value(text):
    """Read a number, parameter, function or bracket: a function that calculates it from what the machine holds."""
    number = text.match(NUMBER)
    if number:
        constant = float(number[0])
        return lambda held: constant
    text.depth += 1
    if text.depth > DEEPEST:
        raise ShapeError(f"has values within values {DEEPEST} deep, which is the most")
    inner = composed(text)
    text.depth -= 1
    return inner


def composed(text):
    """Read a value that others are within."""
    if text.take("-"):
        inner = value(text)
        return lambda held: -inner(held)
    if text.take("+"):
        return value(text)
    if text.take("["):
        return bracket(text)
    if text.take("#"):
        return parameter(text)
    return function(text)


def bracket(text):
    """Read the rest of an expression after its opening bracket."""
    inner = operation(text, 0)
    text.expect("]")
    return inner


def operation(text, least):
    """Read values joined by operators that bind at least so much, from left to right."""
    left = value(text)
    while (found := OPERATOR.match(text.text, text.at)) and OPERATORS[found[0]][0] >= least:
        text.at = found.end()
        binding, calculate = OPERATORS[found[0]]
        left = joined(found[0], calculate, left, operation(text, binding + 1))
    return left


def joined(name, calculate, left, right):
    def both(held):
        a, b = left(held), right(held)
        try:
            return bounded(calculate(a, b))
        except (ZeroDivisionError, OverflowError, ValueError):
            raise ShapeError(f"calculates {a:g} {name} {b:g}, which has no value") from None

    return both


def bounded(number):
    number = float(number)
    if not abs(number) <= LARGEST:
        raise OverflowError
    return number


def function(text):
    """Read a function of one number, or one of the two that are written otherwise."""
    if text.take("atan["):
        rise = bracket(text)
        text.expect("/")
        text.expect("[")
        run = bracket(text)
        return lambda held: math.degrees(math.atan2(rise(held), run(held)))
    if text.take("exists["):
        text.expect("#<")
        name = named(text)
        text.expect("]")
        return lambda held: truth(held.exists(name))
    found = text.match(NAME)
    if not found:
        raise ShapeError(f"needs a number {text.place()}")
    text.expect("[")
    return applied(found[0], bracket(text))


def applied(name, inner):
    def result(held):
        x = inner(held)
        try:
            return bounded(FUNCTIONS[name](x))
        except (ValueError, OverflowError):
            raise ShapeError(f"calculates {name}[{x:g}], which has no value") from None

    return result


def parameter(text):
    """Read which parameter is meant, after its sign: a function that looks up its value."""
    key = parameter_key(text)
    return lambda held: held.get(key(held))


def parameter_key(text):
    """Read the name or number of a parameter: a function that says which it is."""
    if text.take("<"):
        name = named(text)
        return lambda held: name
    number = value(text)
    return lambda held: whole(number(held), "the number of a parameter")


def named(text):
    """Read a name, after its opening bracket."""
    end = text.text.find(">", text.at)
    if end <= text.at:
        raise ShapeError("has the name of a parameter that does not end with '>'")
    name = text.text[text.at : end]
    text.at = end + 1
    return name


def whole(number, what):
    """A number that must be whole, as it is but for rounding."""
    nearest = round(number)
    if abs(number - nearest) > CLOSE:
        raise ShapeError(f"needs a whole number for {what}, got {number:g}")
    return nearest

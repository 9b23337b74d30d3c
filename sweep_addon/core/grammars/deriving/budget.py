# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Budgets: how large a word may become, and how long it may take."""

from time import monotonic

import numpy as np

from ...declared.frozen import frozen
from ...declared.parameters import ShapeError

MOST_DIGITS = 30  # of a size in a refusal
OFTEN = 0.1  # seconds between two looks at whether somebody wants to stop


@frozen
class Budget:
    """How large a derivation may become.

    Attributes
    ----------
    modules : int
        Of the word.
    bytes : int
        Of its arrays.
    seconds : float

    Examples
    --------
    >>> from sweep_addon.core.grammars import LSystem
    >>> try:
    ...     LSystem.parse("axiom: F\\nF -> FF").derive(20, budget=Budget(modules=1000))
    ... except ShapeError as refusal:
    ...     print(refusal)
    generations: must make at most 1,000 modules, but 20 make 1,048,576
    """

    modules: int = 20_000_000
    bytes: int = 1_000_000_000
    seconds: float = 60.0

    def of_arrays(self, size, key):
        """Refuse what would take so many bytes, if that is too much; the key says of what it is."""
        if size > self.bytes:
            raise ShapeError(f"must take at most {self.bytes:,} bytes, but needs about {sized(int(size))}", key)


class LateError(ShapeError):
    """A refusal of what took too long: a quicker machine may not refuse it."""


class Meter:
    """Watches a derivation: refuses what is over the budget, and tells how far it is."""

    def __init__(self, budget, generations, columns, progress):
        self.budget, self.generations, self.columns, self.width = budget, generations, columns, 1 + 8 * columns
        self.progress = undisturbed(progress) if progress else (lambda part: None)
        self.done, self.told = 0, monotonic()
        self.end = self.told + budget.seconds

    def room(self, total, generation=None, least=False):
        """Refuse a word of so many modules, or of at least so many, that is too large."""
        what = f"{self.generations} make" if generation is None else f"generation {generation} has"
        what += " at least" if least else ""
        if total > self.budget.modules:
            raise ShapeError(
                f"must make at most {self.budget.modules:,} modules, but {what} {sized(total)}", "generations"
            )
        if total * self.width > self.budget.bytes:
            raise ShapeError(
                f"must take at most {self.budget.bytes:,} bytes, but {what} {sized(total * self.width)}", "generations"
            )

    def nodes(self, count, width, generation):
        """Refuse a derivation that keeps so many modules of so many bytes, also of those that are there no more."""
        if count * width > self.budget.bytes:
            most, used = f"{self.budget.bytes:,} bytes", f"{sized(count * width)} to be derived"
            raise ShapeError(f"must take at most {most}, but generation {generation} needs {used}", "generations")

    def tick(self, generation):
        """Tell that a generation is done, and refuse to go on where time is up."""
        self.done = generation
        self.told = self.timely(generation)
        self.progress(generation / max(self.generations, 1))

    def check(self):
        """Refuse to go on within a generation where time is up; now and then let who watches stop it."""
        now = self.timely(self.done + 1)
        if now > self.told + OFTEN:
            self.told = now
            self.progress(self.done / max(self.generations, 1))

    def timely(self, generation):
        """What time it is, in seconds, unless it is up."""
        now = monotonic()
        if now > self.end:
            at = f"generation {min(generation, self.generations)} of {self.generations} took longer"
            raise LateError(f"must take at most {self.budget.seconds:g} seconds, but {at}", "generations")
        return now


def undisturbed(progress):
    """A function of a caller's, for which floating-point errors are again what they are now.

    Formulas silence them, also while it is asked.
    """
    errors = np.geterr()

    def told(part):
        with np.errstate(**errors):
            progress(part)

    return told


def ranged(low, high):
    """Two whole numbers between which another is, or that one.

    >>> ranged(3, 3), ranged(3, 1000)
    ('3', '3 to 1,000')
    """
    return sized(low) if low == high else f"{sized(low)} to {sized(high)}"


def sized(number):
    """A whole number with commas, or of many digits how many there are."""
    if number < 10**MOST_DIGITS:
        return f"{number:,}"
    digits = int(number.bit_length() * 0.30102999566398120) + 1
    return f"a number of {digits - (number < 10 ** (digits - 1)):,} digits"

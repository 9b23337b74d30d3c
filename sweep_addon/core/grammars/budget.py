# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Budgets: how large a word may become, and how long it may take."""

from time import monotonic

from ..frozen import frozen
from ..parameters import ShapeError

MOST_DIGITS = 30  # of a size in a refusal


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


class Meter:
    """Watches a derivation: refuses what is over the budget, and tells how far it is."""

    def __init__(self, budget, generations, columns, progress):
        self.budget, self.generations, self.width = budget, generations, 1 + 8 * columns
        self.progress = progress or (lambda part: None)
        self.started()

    def started(self):
        """The same meter, whose time begins now."""
        self.end = monotonic() + self.budget.seconds
        return self

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

    def tick(self, generation):
        """Tell that a generation is done, and refuse to go on where time is up."""
        if monotonic() > self.end:
            raise ShapeError(
                f"must take at most {self.budget.seconds:g} seconds, but generation {generation} of {self.generations} "
                "took longer",
                "generations",
            )
        self.progress(generation / max(self.generations, 1))


def sized(number):
    """A whole number with commas, or of many digits how many there are."""
    if number < 10**MOST_DIGITS:
        return f"{number:,}"
    digits = int(number.bit_length() * 0.30102999566398120) + 1
    return f"a number of {digits - (number < 10 ** (digits - 1)):,} digits"

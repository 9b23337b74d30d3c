# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Problems: what is wrong in the text of a grammar, each with its line and column, and all of them in one refusal."""

from ...declared.frozen import frozen
from ...declared.parameters import ShapeError

MOST = 20  # problems that one refusal tells of
WIDTH = 60  # characters of a line that are shown, around the place


@frozen
class Problem:
    """One thing that is wrong in a text.

    Attributes
    ----------
    line, column : int
        Where it is, both from 1.
    found, expected : str
        What is there, and what would do.
    source : str
        The whole line.
    """

    line: int
    column: int
    found: str
    expected: str
    source: str

    @property
    def sentence(self):
        """Place, what would do and what is there."""
        return f"line {self.line}, column {self.column}: {self.wrong}"

    @property
    def wrong(self):
        """What would do and what is there."""
        return f"expected {self.expected}, found {self.found}"

    @property
    def shown(self):
        """The part of the line around the place, and a caret below it."""
        start = max(0, self.column - 1 - WIDTH // 2) if len(self.source) > WIDTH else 0
        part = "".join(letter if letter.isprintable() else " " for letter in self.source[start : start + WIDTH])
        return f"    {part.rstrip()}\n    {' ' * (self.column - 1 - start)}^"

    def placed(self, path):
        """The problem as editors find its place in a file.

        >>> print(Problem(1, 7, "the end of the line", "a module", "axiom:").placed("koch.l"))
        koch.l:1:7: expected a module, found the end of the line
            axiom:
                  ^
        """
        return f"{path}:{self.line}:{self.column}: {self.wrong}\n{self.shown}"

    def around(self, width):
        """The part of the line around the place, of so many letters at most, and dots where more of it is.

        >>> Problem(1, 12, "'['", "']'", "  A -> F(1) [ F(2) F(3) F(4)").around(12)
        '...F(1) [ F(2) ...'
        """
        blank = len(self.source) - len(self.source.lstrip())
        text = self.source.strip()
        start = max(0, min(self.column - 1 - blank - width // 3, len(text) - width))
        rest = "..." if start + width < len(text) else ""
        return f"{'...' if start else ''}{text[start : start + width]}{rest}"

    def __str__(self):
        return f"{self.sentence}\n{self.shown}"


class GrammarError(ShapeError):
    """A refusal of the text of a grammar, which tells of everything that is wrong in it.

    Attributes
    ----------
    problems : tuple of Problem
        In the order of the text.

    Examples
    --------
    >>> from sweep_addon.core.grammars import LSystem
    >>> try:
    ...     LSystem.parse("axiom: F(1\\nF(x) -> F(x*r)")
    ... except GrammarError as refusal:
    ...     print(refusal)
    line 1, column 9: expected ')' after it, found '('
        axiom: F(1
                ^
    line 2, column 13: expected one of the names x, pi, tau, e, found 'r'
        F(x) -> F(x*r)
                    ^
    """

    def __init__(self, problems, key=""):
        self.problems = tuple(sorted(problems, key=lambda problem: (problem.line, problem.column)))
        told = [str(problem) for problem in self.problems[:MOST]]
        if len(self.problems) > MOST:
            told.append(f"and {len(self.problems) - MOST} more")
        super().__init__("\n".join(told), key)

    def inside(self, key):
        """The same refusal, of a text that is at a key of a larger value."""
        made = GrammarError(self.problems, ".".join(filter(None, (key, self.key))))
        made.others = tuple(other.inside(key) for other in self.others)
        return made

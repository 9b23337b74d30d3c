# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Passages: stretches of one line of a text that know where they stand, so that a refusal can point there."""

from .problems import Problem

LONGEST = 20  # characters of what was found that a refusal shows


class PassageError(Exception):
    """What is wrong with a passage; whoever reads the file goes on with its next line."""

    def __init__(self, problem):
        super().__init__(problem.sentence)
        self.problem = problem


class Passage:
    """A stretch of one line.

    Parameters
    ----------
    line : str
        The whole line.
    number : int
        Its number in the text, from 1.
    start, stop : int
        The stretch, without blanks at its ends.

    Examples
    --------
    >>> whole = Passage("A -> B # grows", 3)
    >>> whole.part(5, 6).text, whole.part(1).place(3)
    ('B', 5)
    """

    __slots__ = ("line", "number", "start", "text")

    def __init__(self, line, number, start=0, stop=None):
        text = line[start:stop]
        self.line, self.number = line, number
        self.start, self.text = start + len(text) - len(text.lstrip()), text.strip()

    def part(self, start, stop=None):
        """A stretch of this one."""
        stop = len(self.text) if stop is None else stop
        return Passage(self.line, self.number, self.start + start, self.start + stop)

    def place(self, at=0):
        """Where a character of it stands in its line, from 0."""
        return self.start + at

    def refuse(self, expected, at=0, found=None):
        """Refuse what is found at a place of it."""
        if found is None:
            letter = self.line[self.place(at) : self.place(at) + 1]
            found = shown(letter) if letter.strip() else ENDED
        raise PassageError(Problem(self.number, self.place(at) + 1, found, expected, self.line))


ENDED = "the end of the line"


def shown(text):
    """What was found, in quotes, cut where it is long."""
    return repr(text if len(text) <= LONGEST else f"{text[:LONGEST]}...")

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Passages: stretches of one line of a text that know where they stand, so that a refusal can point there."""

from bisect import bisect_right

from .problems import Problem

LONGEST = 20  # characters of what was found that a refusal shows


class PassageError(Exception):
    """What is wrong with a passage; whoever reads the file goes on with its next line."""

    def __init__(self, problem):
        super().__init__(problem.sentence)
        self.problem = problem


class Passage:
    """A stretch of one line, or of several that are one.

    Parameters
    ----------
    line : str or Lines
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
        self.line, self.number, self.start, self.text = line, number, start, text.strip()
        if len(self.text) < len(text):
            self.start += len(text) - len(text.lstrip())

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
        raise PassageError(problem(self.line, self.number, self.place(at), found, expected))


class Lines(str):
    """Passages of several lines as one line, between blanks; where each character stands in the text is known.

    >>> lines = Lines([Passage("A -> B", 1), Passage("    C", 2)])
    >>> lines, lines.source(6)[:2], lines.source(7)[:2]
    ('A -> B C', (1, 6), (2, 4))
    """

    def __new__(cls, passages):
        first = passages[0]
        said = [first.line[: first.start + len(first.text)], *(passage.text for passage in passages[1:])]
        made = super().__new__(cls, " ".join(said))
        made.passages, made.begins = passages, [0]
        for part in said[:-1]:
            made.begins.append(made.begins[-1] + len(part) + 1)
        return made

    def source(self, place):
        """The number of the line of the text that a character is of, its place there, and that line."""
        at = bisect_right(self.begins, place) - 1
        passage = self.passages[at]
        return passage.number, place - self.begins[at] + (passage.start if at else 0), passage.line


def problem(line, number, place, found, expected):
    """A problem at a place of a line, which counts from 0."""
    number, place, line = line.source(place) if isinstance(line, Lines) else (number, place, line)
    return Problem(number, place + 1, found, expected, line)


ENDED = "the end of the line"


def shown(text):
    """What was found, in quotes, cut where it is long."""
    return repr(text if len(text) <= LONGEST else f"{text[:LONGEST]}...")

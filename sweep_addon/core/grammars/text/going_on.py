# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines that go on: an axiom or a production over several lines, as books print them, is read as one.

Only a line that could not stand for itself is taken for the rest of another.
"""

import re

from .passages import Lines, Passage
from .printed import legend
from .productions import ARROW, LABEL

BLOCK = re.compile(r"\s*((?:start|end)(?: each)?)\s*:", re.IGNORECASE)
SECTION = re.compile(
    r"\s*(axiom|ω|productions|(?:group|lsystem)\s+\d{1,6}|decomposition|homomorphism|interpretation|maximum\s+depth)\s*:",
    re.IGNORECASE,
)
AXIOM = ("axiom", "ω")
SIGNS = ("<", ">", ":", ARROW)  # that no production begins with


def blocked(passage):
    """Where a line of statements says which block they are of; None for other lines, and for what names begin with."""
    match = BLOCK.match(passage.text)
    return match if match and ARROW not in passage.text else None


def joined(lines):
    """The lines of a text, each axiom and each production with the lines that it goes on in.

    Parameters
    ----------
    lines : list of (str, Passage, str)
        The word of the directive that each is, or nothing, what it says, and its comment.

    Returns
    -------
    list of (str, Passage, str)

    Examples
    --------
    >>> told = ["axiom: A", "A -> B [+ A]", "  C(1,", "2)"]
    >>> [passage.text for _, passage, _ in joined([("", Passage(line, at), "") for at, line in enumerate(told, 1)])]
    ['axiom: A', 'A -> B [+ A] C(1, 2)']
    """
    found = []
    for line in lines:
        if found and found[-1].takes(*line[:2]):
            found[-1].take(line[1])
        else:
            found.append(Whole(*line))
    return [whole.line() for whole in found]


class Whole:
    """A line with those that it goes on in."""

    def __init__(self, word, passage, comment):
        self.word, self.comment, self.parts = word, comment, []
        self.goes_on = not word and begins_a_word(passage)
        self.opened = {"(": 0, "[": 0}
        self.numbered = bool(LABEL.match(passage.text))
        self.arrow = not word and bool(SECTION.match(passage.text))  # an axiom needs none
        self.take(passage)

    def take(self, passage):
        """Go on in one more line."""
        self.parts.append(passage)
        self.arrow |= ARROW in passage.text
        for opening, closing in ("()", "[]"):
            self.opened[opening] += passage.text.count(opening) - passage.text.count(closing)

    def takes(self, word, passage):
        """Whether the next line is the rest of this one: where that is unfinished, or the next stands further right.

        Where productions are numbered, what has neither a number nor an arrow is the rest of one too.
        """
        if word or not self.goes_on or SECTION.match(passage.text) or BLOCK.match(passage.text) or legend(passage.text):
            return False
        further = indented(passage) > indented(self.parts[0])
        if ARROW in passage.text:
            return further and not self.arrow and passage.text.startswith(SIGNS)
        unfinished = max(self.opened.values()) > 0 or self.parts[-1].text.endswith(ARROW)
        return further or unfinished or self.numbered and self.arrow and not LABEL.match(passage.text)

    def line(self):
        """The whole as one line."""
        first = self.parts[0]
        if len(self.parts) == 1:
            return self.word, first, self.comment
        return self.word, Passage(Lines(self.parts), first.number, first.start), self.comment


def begins_a_word(passage):
    """Whether a line is an axiom or a production, or begins one."""
    match = SECTION.match(passage.text)
    if match and match[1].lower() not in AXIOM:
        return ARROW in passage.text
    return bool(passage.text) and not blocked(passage) and not legend(passage.text)


def indented(passage):
    """How many columns stand before a line."""
    return len(passage.line[: passage.start].expandtabs())

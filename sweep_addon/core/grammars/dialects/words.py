# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Words of other programs: their modules as they stand, told in the symbols of the book."""

import re
from typing import NamedTuple

from ..text.modules import after_blanks, bracketed
from ..text.passages import Passage, shown

FRACTION = re.compile(r"0*\.\d*[1-9]\d*", re.ASCII)


class Said(NamedTuple):
    """A module of another program: its name, its place in the passage, and its parameters as text."""

    name: str
    at: int
    parameters: tuple

    def told(self, name=None):
        """The module in the notation of the book, under another name perhaps."""
        name = self.name if name is None else name
        return f"{name}({','.join(self.parameters)})" if self.parameters else name


def single(text, at):
    """The letter at a place of a text."""
    return text[at]


def modules(passage: Passage, named=single):
    """The modules in a passage.

    Parameters
    ----------
    passage : Passage
    named : callable
        Takes a text and a place, and returns the name of the module there.

    Returns
    -------
    list of Said

    Examples
    --------
    >>> [said.told() for said in modules(Passage("F (1, x*(2)) + G", 1))]
    ['F(1,x*(2))', '+', 'G']
    """
    text, at, found = passage.text, 0, []  # which begins with no blank
    while at < len(text):
        name = named(text, at)
        if name in "()" or not "!" <= name[0] <= "~":
            passage.refuse("a module", at)
        here, parameters, at = at, (), after_blanks(text, at + len(name))
        if text[at : at + 1] == "(":
            parts, at = bracketed(passage, at)
            parameters = tuple(part.text for part in parts)
            at = after_blanks(text, at)
        found.append(Said(name, here, parameters))
    return found


def unknown(passage, said, what="a symbol that has a meaning here"):
    """Refuse a module that the book has not."""
    passage.refuse(what, said.at, shown(said.told()))


def comparing(condition, source):
    """Refuse a condition that is a fraction, which always holds: who writes one means a probability."""
    if FRACTION.fullmatch(condition.strip()):
        source.refuse("a condition that compares, for a probability stands behind the successor", 0, shown(condition))

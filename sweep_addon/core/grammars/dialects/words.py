# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Words of other programs: their modules as they stand, told in the symbols of the book."""

import re
from typing import NamedTuple

from ..text.modules import bracketed
from ..text.passages import Passage, shown

PRINTED = re.compile("[!-~]")
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
    text, at, found = passage.text, 0, []
    while (at := after_blanks(text, at)) < len(text):
        name = named(text, at)
        if name in "()" or not PRINTED.match(name):
            passage.refuse("a module", at)
        end, parameters = at + len(name), ()
        opening = after_blanks(text, end)
        if text[opening : opening + 1] == "(":
            parts, end = bracketed(passage, opening)
            parameters = tuple(part.text for part in parts)
        found.append(Said(name, at, parameters))
        at = end
    return found


def after_blanks(text, at):
    """The next place that is no blank, or the end."""
    while at < len(text) and text[at].isspace():
        at += 1
    return at


def outside(text, sign):
    """The place of the first such sign outside of brackets, or -1.

    >>> outside("A(x=1)=B", "="), outside("A(x)", "=")
    (6, -1)
    """
    depth = 0
    for at, letter in enumerate(text):
        depth += (letter == "(") - (letter == ")")
        if not depth and text.startswith(sign, at):
            return at
    return -1


def last_outside(text, sign):
    """The place of the last such sign outside of brackets, or -1."""
    depth, found = 0, -1
    for at, letter in enumerate(text):
        depth += (letter == "(") - (letter == ")")
        found = at if not depth and text.startswith(sign, at) else found
    return found


def unknown(passage, said, what="a symbol that has a meaning here"):
    """Refuse a module that the book has not."""
    passage.refuse(what, said.at, shown(said.told()))


def comparing(condition, source):
    """Refuse a condition that is a fraction, which always holds: who writes one means a probability."""
    if FRACTION.fullmatch(condition.strip()):
        source.refuse("a condition that compares, for a probability stands behind the successor", 0, shown(condition))

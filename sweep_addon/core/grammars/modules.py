# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Modules as they are written: a letter, or a declared name of several, and its parameters in brackets.

Blanks never matter. What is no name of several letters is a module of one.
"""

import re
from math import isfinite
from typing import NamedTuple

from ..expressions import Expression
from ..frozen import frozen
from .passages import Passage, shown
from .vocabulary import draws, formula

BUILT_IN = ("@v", "@Gs", "@Gc", "@Ge", "@Sl", "@Sa", "@Sw", "?P", "?H", "?L", "?U", "?E")
QUERIES, ENVIRONMENT = ("?P", "?H", "?L", "?U"), "?E"
OPEN, CLOSE = "[", "]"
NEVER = frozenset("()<>*#:")  # characters that are part of the notation
MOST_PARAMETERS = 32
BLANKS = re.compile(r"(?<!\w)\s+|\s+(?!\w)", re.ASCII)  # all that part no words
NAME = re.compile(r"[A-Za-z_]\w*", re.ASCII)
UNSET = Expression("0", (), (0.0,))  # of a query, until a turtle fills it in


@frozen
class Module:
    """A module of a successor or of the axiom.

    Attributes
    ----------
    name : str
    parameters : tuple of Expression
    """

    name: str
    parameters: tuple = ()

    @property
    def symbol(self):
        """What rules match: the name and the number of parameters."""
        return self.name, len(self.parameters)

    def __str__(self):
        told = ",".join(BLANKS.sub("", parameter.text) for parameter in self.parameters)
        return f"{self.name}({told})" if told else self.name


@frozen
class Pattern:
    """A module of a predecessor or of its context.

    Attributes
    ----------
    name : str
    parameters : tuple of str
        The names that stand for its parameters.
    """

    name: str
    parameters: tuple = ()

    symbol = Module.symbol

    def __str__(self):
        return f"{self.name}({','.join(self.parameters)})" if self.parameters else self.name


class Letter(NamedTuple):
    """A module as it stands in the text: its name, its place, and the passages of its parameters."""

    name: str
    at: int
    arguments: tuple


class Alphabet:
    """The names of modules that have more than one letter, longest first where one begins another."""

    def __init__(self, names=()):
        self.names = tuple(dict.fromkeys(names))
        spelled = sorted((*self.names, *BUILT_IN), key=len, reverse=True)
        self.found = re.compile("|".join(map(re.escape, spelled)) + "|[!-~]")

    def letters(self, passage: Passage):
        """The modules in a passage.

        Parameters
        ----------
        passage : Passage

        Returns
        -------
        list of Letter

        Examples
        --------
        >>> [letter.name for letter in Alphabet(["Fl"]).letters(Passage("Fl + F(1, 2) l", 1))]
        ['Fl', '+', 'F', 'l']
        """
        text, at, found = passage.text, 0, []
        while at < len(text):
            if text[at].isspace():
                at += 1
                continue
            match = self.found.match(text, at)
            if not match or match.group() in NEVER:
                passage.refuse("a module", at)
            end = after_blanks(text, match.end())
            arguments = ()
            if text[end : end + 1] == "(":
                arguments, end = bracketed(passage, end)
            found.append(Letter(match.group(), at, arguments))
            at = end
        return found

    def word(self, passage, names, vocabulary, drawn=0):
        """The modules in a passage whose parameters are formulas; brackets of branches in pairs.

        Returns
        -------
        tuple of Module
        int
            How many random numbers their formulas draw.
        """
        letters = self.letters(passage)
        paired(passage, letters)
        made, plain = [], {}  # most modules of a long word have no parameters: those of a name are one
        for letter in letters:
            if not letter.arguments:
                made.append(plain.get(letter.name) or plain.setdefault(letter.name, Module(letter.name)))
                continue
            parameters = []
            for argument in letter.arguments:
                unset = letter.name in (*QUERIES, ENVIRONMENT) and is_free(argument.text, names, vocabulary)
                read = UNSET if unset else formula(argument, names, vocabulary, drawn)
                drawn += draws(read.names)
                if not read.names and not isfinite(read.run({})):
                    argument.refuse("a finite number", 0, f"{read.run({}):g}")
                parameters.append(read)
            made.append(Module(letter.name, tuple(parameters)))
        return tuple(made), drawn

    def patterns(self, passage):
        """The modules in a passage whose parameters are names."""
        made = []
        for letter in self.letters(passage):
            for argument in letter.arguments:
                if not NAME.fullmatch(argument.text):
                    argument.refuse("a name for the parameter", 0, shown(argument.text))
            made.append(Pattern(letter.name, tuple(argument.text for argument in letter.arguments)))
        return made


def is_free(text, names, vocabulary):
    """Whether a parameter of a query says nothing, as the book's authors print it: ``?P(x,y)``, ``?P(*,*)``."""
    return text == "*" or NAME.fullmatch(text) and text not in names and text not in vocabulary.constants


def after_blanks(text, at):
    while at < len(text) and text[at].isspace():
        at += 1
    return at


def bracketed(passage, start):
    """The passages between commas in the brackets that open at a place, and where these end."""
    text, depth, begin, found = passage.text, 0, start + 1, []
    for at in range(start, len(text)):
        letter = text[at]
        if letter == "(":
            depth += 1
        elif letter == ")":
            depth -= 1
            if not depth:
                found.append(passage.part(begin, at))
                if len(found) > MOST_PARAMETERS:
                    passage.refuse(f"at most {MOST_PARAMETERS} parameters", start, f"{len(found)}")
                return tuple(found), at + 1
        elif letter == "," and depth == 1:
            found.append(passage.part(begin, at))
            begin = at + 1
    passage.refuse("')' or ',' after a parameter", len(text))


def paired(passage, letters):
    """Refuse brackets of branches that are not in pairs."""
    opened = []
    for letter in letters:
        if letter.name == OPEN:
            opened.append(letter.at)
        elif letter.name == CLOSE:
            if not opened:
                passage.refuse("'[' before it", letter.at, "']'")
            opened.pop()
    if opened:
        passage.refuse("']' after it", opened[-1], "'['")

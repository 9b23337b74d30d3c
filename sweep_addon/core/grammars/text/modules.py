# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Modules as they are written: a letter, or a declared name of several, and its parameters in brackets.

Blanks never matter. What is no name of several letters is a module of one.
"""

import re
from bisect import bisect_right
from math import isfinite
from typing import NamedTuple

from ...declared.frozen import frozen
from ...formulas.expressions import GREEK, Expression
from .passages import Passage, shown
from .vocabulary import draws, formula

BUILT_IN = ("@v", "@Gs", "@Gc", "@Ge", "@Gt", "@Sl", "@Sa", "@Sw", "?P", "?H", "?L", "?U", "?E")
QUERIES, ENVIRONMENT = ("?P", "?H", "?L", "?U"), "?E"
OPEN, CLOSE = "[", "]"
NEVER = frozenset("()<>*#:")  # characters that are part of the notation
MOST_PARAMETERS = 32
BLANKS = re.compile(r"(?<!\w)\s+|\s+(?!\w)", re.ASCII)  # all that part no words
NAME = re.compile(rf"[A-Za-z_{GREEK}][\w{GREEK}]*", re.ASCII)
BLANK = re.compile(r"\s*")
BRACKET, ONLY = re.compile("[(),]"), re.compile(r"\([^(),]*\)")  # one parameter without brackets, as most have
ORGAN = re.compile(r"~([a-z]{2,}\w*)", re.ASCII)  # names of organs; capitals follow each other without blanks
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
    """The names of modules that have more than one letter; where one begins another, the longest counts.

    Names that a text begins with stand in order before it, and each begins what stands between it and the text. So the
    one just before the text either begins it, or is begun by all that do: thousands of names take no longer than a few.
    """

    def __init__(self, names=()):
        self.names = tuple(dict.fromkeys(names))
        self.spelled = sorted({*self.names, *BUILT_IN})
        self.longest = max(map(len, self.spelled))
        self.initials = frozenset(name[0] for name in self.spelled)
        self.within = []  # the place of the longest other name that each begins with, or -1
        for place, name in enumerate(self.spelled):
            shorter = place - 1
            while shorter >= 0 and not name.startswith(self.spelled[shorter]):
                shorter = self.within[shorter]
            self.within.append(shorter)

    def named(self, text, at):
        """The longest name that a text has at a place, or the letter there."""
        rest = text[at : at + self.longest]
        found = bisect_right(self.spelled, rest) - 1
        while found >= 0 and not rest.startswith(self.spelled[found]):
            found = self.within[found]
        return rest[0] if found < 0 else self.spelled[found]

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
        text, at, found = passage.text, 0, []  # which begins with no blank
        while at < len(text):
            name = text[at]
            if name in self.initials:
                name = self.named(text, at)
            if name in NEVER or not "!" <= name[0] <= "~":
                passage.refuse("a module", at)
            here, arguments, at = at, (), after_blanks(text, at + len(name))
            if text[at : at + 1] == "(":
                arguments, at = bracketed(passage, at)
                at = after_blanks(text, at)
            found.append(Letter(name, here, arguments))
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
        place, spelled = undeclared(passage.text, letters)
        if spelled:
            passage.refuse(f"an organ of one letter, or a line '#names {spelled}'", place, shown(f"~{spelled}"))
        made, known, alike = [], {}, {}  # in a long word most modules and formulas are there many times
        for letter in letters:
            spelled = letter.name, *[argument.text for argument in letter.arguments]
            module = alike.get(spelled)
            if module is None:
                parameters, before = [], drawn
                asks = letter.name in (*QUERIES, ENVIRONMENT)
                for argument in letter.arguments:
                    read = UNSET if asks and is_free(argument.text, names, vocabulary) else known.get(argument.text)
                    read = read or parameter(argument, names, vocabulary, drawn)
                    drawn += draws(read.names)
                    if read is not UNSET and not draws(read.names):
                        known[argument.text] = read
                    parameters.append(read)
                module = Module(letter.name, tuple(parameters))
                if drawn == before:
                    alike[spelled] = module
            made.append(module)
        return tuple(made), drawn


def patterns(letters):
    """Modules whose parameters are names."""
    made, plain = [], {}
    for letter in letters:
        if not letter.arguments:
            made.append(plain.get(letter.name) or plain.setdefault(letter.name, Pattern(letter.name)))
            continue
        for argument in letter.arguments:
            if not NAME.fullmatch(argument.text):
                argument.refuse("a name for the parameter", 0, shown(argument.text))
        made.append(Pattern(letter.name, tuple(argument.text for argument in letter.arguments)))
    return made


def after_blanks(text, at):
    """The next place that is no blank, or the end."""
    return BLANK.match(text, at).end() if text[at : at + 1].isspace() else at


def undeclared(text, letters):
    """The place and the name of the first organ that is written as a word and read as letters, or the end and nothing.

    >>> undeclared("F~leaf(2)", Alphabet().letters(Passage("F~leaf(2)", 1)))
    (1, 'leaf')
    """
    for letter, following in zip(letters, letters[1:], strict=False) if "~" in text else ():
        if letter.name == "~" and len(following.name) == 1:
            word = ORGAN.match(text, letter.at)
            if word:
                return letter.at, word.group(1)
    return len(text), ""


def is_free(text, names, vocabulary):
    """Whether a parameter of a query says nothing, as the book's authors print it: ``?P(x,y)``, ``?P(*,*)``."""
    return text == "*" or NAME.fullmatch(text) and text not in names and text not in vocabulary.constants


def parameter(passage, names, vocabulary, drawn):
    """The formula of a parameter."""
    read = formula(passage, names, vocabulary, drawn)
    if not read.names and not isfinite(read.run({})):
        passage.refuse("a finite number", 0, f"{read.run({}):g}")
    return read


def bracketed(passage, start):
    """The passages between commas in the brackets that open at a place, and where these end."""
    text, depth, begin, found = passage.text, 0, start + 1, []
    only = ONLY.match(text, start)
    if only:
        return (passage.part(begin, only.end() - 1),), only.end()
    for match in BRACKET.finditer(text, start):
        letter, at = match.group(), match.start()
        if letter == "(":
            depth += 1
        elif letter == ")":
            depth -= 1
            if not depth:
                found.append(passage.part(begin, at))
                if len(found) > MOST_PARAMETERS:
                    passage.refuse(f"at most {MOST_PARAMETERS} parameters", start, f"{len(found)}")
                return tuple(found), at + 1
        elif depth == 1:
            found.append(passage.part(begin, at))
            begin = at + 1
    passage.refuse("')' after it", start, "'('")


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

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Directives: the lines of a grammar that begin with # and a word that is known."""

import re
from difflib import get_close_matches

from .modules import NAME, Alphabet
from .passages import Passage, shown
from .vocabulary import value

DIALECTS = ("abop",)
WORDS = "dialect names define ignore consider heading angle step width generations seed tropism groups".split()
DIRECTIVE = re.compile(r"\s*#([A-Za-z]+)(?=[\s:]|$)")
AXES = ("x", "y", "z")
MOST_GENERATIONS = 1_000_000
MOST_NAMES = 10_000
MOST_STEPS = 100_000  # of which the groups are listed
LARGEST_SEED = 2**63 - 1


def directive(line, number):
    """The word of a directive and what follows it; None where the line is none.

    Raises
    ------
    PassageError
        Where the word is nearly that of a directive: it would be a comment otherwise.
    """
    match = DIRECTIVE.match(line)
    if not match:
        return None
    word = match.group(1).lower()
    if word not in WORDS:
        near = get_close_matches(word, WORDS, 1, 0.8)
        if near:
            Passage(line, number, match.start(1)).refuse(
                f"#{near[0]}, or a blank before a comment", 0, shown(match.group(1))
            )
        return None
    return word, Passage(line, number, match.end()).part(line[match.end() :].lstrip().startswith(":"))


def names(passage):
    """Declared names, between commas or blanks."""
    found = []
    for match in re.finditer(r"[^\s,]+", passage.text):
        if not NAME.fullmatch(match.group()) or len(match.group()) > 64:
            passage.refuse("names of letters and digits, between commas", match.start(), shown(match.group()))
        found.append(match.group())
    if not found:
        passage.refuse("a name")
    return found


def ignored(passage, alphabet: Alphabet):
    """The names of modules in a list that may have no blanks."""
    found = alphabet.letters(passage)
    for letter in found:
        if letter.arguments:
            passage.refuse("a name without parameters", letter.at, shown(letter.name))
        if letter.name in "[]":
            passage.refuse("names of modules, for branches are skipped anyway", letter.at)
    return tuple(letter.name for letter in found)


def whole(passage, vocabulary, most):
    """A whole number from 0 to the most."""
    number = value(passage, vocabulary)
    if not 0 <= number <= most or number != int(number):
        passage.refuse(f"a whole number from 0 to {most}", 0, shown(passage.text))
    return int(number)


def numbers(passage, vocabulary, count, what):
    """So many numbers, between blanks."""
    parts = [passage.part(*match.span()) for match in re.finditer(r"\S+", passage.text)]
    if len(parts) != count:
        passage.refuse(f"{count} numbers: {what}", 0, f"{len(parts)}")
    return tuple(value(part, vocabulary) for part in parts)


def heading(passage):
    """The name of an axis."""
    if passage.text not in AXES:
        passage.refuse(f"an axis, {', '.join(AXES)}", 0, shown(passage.text))
    return passage.text


def schedule(passage):
    """Which group each step uses, and whether the list begins again at its end: ``1*6 2``, ``1 2 ...``."""
    found, again = [], False
    for match in re.finditer(r"\S+", passage.text):
        if again:
            passage.refuse("nothing after ...", match.start(), shown(match.group()))
        again = match.group() == "..."
        told = re.fullmatch(r"(\d{1,6})(?:\*(\d{1,4}))?", match.group())
        if not told and not again:
            passage.refuse("numbers of groups, as 1*6 2, at their end perhaps ...", match.start(), shown(match.group()))
        found += [int(told[1])] * int(told[2] or 1) if told else []
        if len(found) > MOST_STEPS:
            passage.refuse(f"at most {MOST_STEPS} steps", match.start(), "more")
    if not found:
        passage.refuse("the number of a group")
    return tuple(found), again

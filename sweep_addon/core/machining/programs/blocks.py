# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A line of a program, read: its words, the parameters it sets, and what it says of the flow of the program."""

import re
from dataclasses import dataclass, field

from ...declared.refusals import ShapeError
from ...declared.wording import shown
from .expressions import NUMBER, Text, bracket, named, parameter_key, value, whole

ASIDE = re.compile(r"\([^()]*\)|;.*")
BLANK = re.compile(r"\s+")
LABEL = re.compile(r"\d+", re.ASCII)
KEYWORD = re.compile("endsub|sub|call|return|elseif|else|endif|if|endwhile|while|do|endrepeat|repeat|break|continue|$")
LONGEST = 256  # as LinuxCNC has it
KEYWORD_ARGUMENTS = {"if": 1, "elseif": 1, "while": 1, "repeat": 1, "call": 30, "return": 1, "endsub": 1}
LETTERS = "abcdefhijklpqrstuvwxyzd$@^"


@dataclass
class Block:
    """What a line says: codes of G and M, other words by letter, parameters it sets, and its place in the flow."""

    codes: list = field(default_factory=list)
    stops: list = field(default_factory=list)
    words: dict = field(default_factory=dict)
    assignments: list = field(default_factory=list)
    label: object = None
    keyword: str | None = None
    arguments: list = field(default_factory=list)


def bare(line):
    """A line without its comments and blanks, in small letters."""
    return BLANK.sub("", ASIDE.sub("", line)).lower()


def stripped(line):
    """A bare line, or a refusal of what cannot be read."""
    text = bare(line)
    if "(" in text or ")" in text:
        raise ShapeError("has a bracket of a comment without the other")
    if len(text) > LONGEST:  # so that no expression is too deep to be calculated
        raise ShapeError(f"has {len(text)} characters beside blanks and comments, where {LONGEST} are the most")
    return text


def block(line):
    """Read a line, of which the numbers may be expressions that are calculated each time it is run."""
    text = Text(stripped(line))
    made = Block()
    if text.take("/"):  # a switch of the machine, which is on: the line is left out
        return made
    if text.take("n") and not text.match(NUMBER):
        raise ShapeError(f"needs a number for its N {text.place()}")
    if text.take("o"):
        read_flow(text, made)
    while text:
        read_word(text, made)
    return made


def read_word(text, made):
    letter = text.next()
    text.at += 1
    if letter == "#":
        key = parameter_key(text)
        text.expect("=")
        made.assignments.append((key, value(text)))
    elif letter == "g":
        made.codes.append(value(text))
    elif letter == "m":
        made.stops.append(value(text))
    elif letter in LETTERS:
        if letter in made.words:
            raise ShapeError(f"has two words {letter.upper()}")
        made.words[letter] = value(text)
    else:
        text.at -= 1
        raise ShapeError(f"has a word that no program has {text.place()}, of letters and numbers")


def read_flow(text, made):
    """Read an O-word: a label, a word of the flow, and what that needs."""
    made.label = read_label(text)
    found = text.match(KEYWORD)
    if not found:
        raise ShapeError(f"needs sub, call, if, while, do, repeat or another word of the flow {text.place()}")
    made.keyword = found[0] or "label"
    most = KEYWORD_ARGUMENTS.get(made.keyword, 0)
    while text.take("["):
        made.arguments.append(bracket(text))
    given = len(made.arguments)
    closing = made.keyword in ("if", "elseif", "while", "repeat")
    if text or given > most or closing and given != 1:
        needed = "one [expression]" if closing else f"at most {most} [expressions]" if most else "nothing"
        raise ShapeError(f"needs {needed} after {made.keyword}, got {shown(text.text)}")


def read_label(text):
    if text.take("<"):
        name = named(text)
        return lambda held: name
    number = text.match(LABEL)
    if number:
        label = int(number[0])
        return lambda held: label
    number = value(text)
    return lambda held: whole(number(held), "a label")

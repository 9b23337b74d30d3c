# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Dialects: texts in the notations of other programs, line by line as texts in that of the book.

What a dialect has and this program does not know is told with its line, and nothing is guessed.
"""

import re
from dataclasses import replace
from importlib import import_module

from ..text.passages import PassageError
from ..text.problems import GrammarError

QUOTED = re.compile(r"'([^']+)'")
NAMED = re.compile(r"^[ \t]*#dialect[ \t]+(\w+)[ \t]*(?:#.*)?$", re.MULTILINE | re.IGNORECASE)
OTHERS = ("cpfg", "fractint", "houdini", "lpy")


def translated(text):
    """A text in the notation of the book, whose lines have the numbers that they had.

    Raises
    ------
    GrammarError
        With every line that has no meaning here.
    """
    named = NAMED.search(text)
    if not named or named[1] not in OTHERS:
        return text
    lines = (text[: named.start(1)] + "abop" + text[named.end(1) :]).split("\n")
    made, problems = import_module(f".{named[1]}", __package__).translated(lines)
    if problems:
        raise GrammarError(problems)
    return "\n".join(made)


def line_by_line(reader, *columns):
    """What a reader makes of each line, given as columns: lines in the notation of the book, and problems of others."""
    made, problems = [], []
    for told in zip(*columns, strict=True):
        try:
            made.append(reader.line(*told))
        except PassageError as wrong:
            problems.append(wrong.problem)
            made.append("")
    return made, problems


def placed(refusal, text):
    """A refusal of a translated text, with the lines that somebody wrote."""
    lines = text.split("\n")
    return GrammarError([written(problem, lines[min(problem.line, len(lines)) - 1]) for problem in refusal.problems])


def written(problem, line):
    """A problem of a translated line as one of the line that it comes from: where what was found stands, if it does."""
    if problem.source == line:
        return problem
    quoted = QUOTED.search(problem.found)
    at = line.find(quoted[1]) if quoted else -1
    return replace(problem, column=max(at, 0) + 1, source=line)

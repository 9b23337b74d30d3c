# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Constants and macros whose text is pasted, and comments, as the preprocessor of C treats them."""

import re

from ..text.modules import after_blanks
from ..text.passages import Passage, shown

COMMENT = re.compile(r"/[*/]")
DEFINED = re.compile(r"\s*#\s*define\s+([A-Za-z_]\w*)(\(([^()]*)\))?\s*(.*)", re.DOTALL)
NAME = re.compile(r"[A-Za-z_]\w*", re.ASCII)
STATED = re.compile(r"\s*(?:start|end)\s*+(?:each)?\s*+:|(?!\s*axiom)[^{]*:\s*\{(?!.*-->)", re.IGNORECASE)
MOST_PASTED, MOST_TOLD, LONGEST = 20, 2000, 100_000  # rounds, characters of a constant, and of a line with constants
MOST_WORK = 1_000_000  # characters that are looked at or made for constants in a whole text


def uncommented(text):
    """A text with blanks in the place of its comments."""
    parts, at = [], 0
    while match := COMMENT.search(text, at):
        end = text.find("*/" if match.group() == "/*" else "\n", match.end())
        end = len(text) if end < 0 else end + 2 * (match.group() == "/*")
        parts += [text[at : match.start()], "\n" * text.count("\n", match.start(), end) or " "]
        at = end
    return "".join((*parts, text[at:]))


def joined(lines):
    """Lines that go on behind a backslash, with a tab or in braces stand where the first one is; others become empty.

    >>> joined(["A", "\\t--> B \\\\", "C", "D"])
    ['A --> B C', '', '', 'D']
    """
    parts, first, goes_on, braces, begun = [], 0, False, 0, False
    for number, line in enumerate(lines):
        more = goes_on or braces > 0 or line.startswith("\t") and begun
        if not more:
            first, begun = number, not (line.isspace() or not line or line.lstrip().startswith("#"))
        stated = braces > 0 or STATED.match(line)
        braces = braces * more + line.count("{") - line.count("}") if stated else 0
        parts.append([])
        parts[first].append(line.removesuffix("\\"))
        goes_on = line.endswith("\\")
    return [" ".join(map(str.strip, told)) if len(told) > 1 else "".join(told) for told in parts]


class Pasting:
    """The constants of a text."""

    def __init__(self):
        self.known, self.work = {}, 0

    def spend(self, count, source):
        """Count characters that are made, of which there may not be too many."""
        self.work += count
        if self.work > MOST_WORK:
            source.refuse(f"at most {MOST_WORK} characters where constants are pasted", 0, "more")

    def define(self, match, source: Passage):
        """Note a constant or a macro.

        Parameters
        ----------
        match : re.Match
            Of `DEFINED`.
        """
        name, brackets, parameters, body = match.groups()
        if len(body) > MOST_TOLD:
            source.refuse(f"at most {MOST_TOLD} characters to be pasted", 0, f"{len(body)}")
        names = [each.strip() for each in parameters.split(",")] if brackets else None
        for each in names or ():
            if not NAME.fullmatch(each):
                source.refuse("names for the parameters of a macro", 0, shown(each))
        self.known[name] = names, body.strip()

    def pasted(self, line, source):
        """A line with the text of constants in the place of their names.

        Raises
        ------
        PassageError
            Where constants need each other, become too long, or a macro has other parameters.
        """
        if self.known:
            short(len(line), source)
        for _ in range(MOST_PASTED if self.known else 0):
            self.spend(len(line), source)
            longer = self.once(line, source)
            if longer == line:
                return line
            line = longer
        if self.known:
            source.refuse("constants that do not need each other", 0, shown(source.text))
        return line

    def once(self, line, source):
        parts, at, size = [], 0, 0
        for match in NAME.finditer(line):
            if match.start() < at or match.group() not in self.known:
                continue
            names, body = self.known[match.group()]
            end = match.end()
            if names is not None:
                given, end = self.given(line, end, source)
                if given is None:
                    continue
                if len(given) != len(names):
                    source.refuse(f"{len(names)} parameters of {match.group()}", 0, f"{len(given)}")
                told = dict(zip(names, given, strict=True))
                body = NAME.sub(lambda found, told=told: told.get(found.group(), found.group()), body)
            parts += [line[at : match.start()], body]
            size += match.start() - at + len(body)
            at = end
            if size > LONGEST:
                break
        short(size + len(line) - at, source)
        return "".join((*parts, line[at:]))

    @staticmethod
    def given(line, at, source):
        """The parameters in the brackets behind a macro, and where these end; None where there are none."""
        start = after_blanks(line, at)
        if line[start : start + 1] != "(":
            return None, at
        depth, begin, found = 0, start + 1, []
        for place in range(start, len(line)):
            depth += (line[place] == "(") - (line[place] == ")")
            if not depth or line[place] == "," and depth == 1:
                found.append(line[begin:place].strip())
                begin = place + 1
            if not depth:
                return found, place + 1
        source.refuse("')' behind the parameters of a macro", 0, shown(line[at:].strip()))


def short(size, source):
    """Refuse a line that is, or becomes, too long."""
    if size > LONGEST:
        source.refuse(f"at most {LONGEST} characters where constants are pasted", 0, f"{size}")

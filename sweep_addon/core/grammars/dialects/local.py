# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Statements in productions of cpfg: what they name is told in full where it is used."""

import re

from ..text.passages import shown
from .pasting import LONGEST

NAME = re.compile(r"(?<![\w.])[A-Za-z_]\w*", re.ASCII)
ASSIGNED = re.compile(r"([A-Za-z_]\w*)\s*=(?!=)\s*(.+)", re.ASCII | re.DOTALL)
CHANCE = re.compile(r"\bn?ran\s*\(")
KEYWORDS = ("if", "while", "do", "else", "array")


class Locals:
    """The names of a production that statements give values to, each with the formula that it stands for.

    Parameters
    ----------
    shared : tuple of str
        Variables of the whole derivation, which no production may change here: modules are replaced all at once.
    source : Passage
        The line.
    spend : callable
        Counts characters that are made.
    """

    def __init__(self, shared, source, spend):
        self.known, self.shared, self.source, self.spend = {}, shared, source, spend

    def assign(self, text):
        """Take the statements between two braces."""
        for part in filter(str.strip, text.split(";")):
            match = ASSIGNED.fullmatch(part.strip())
            if not match or match[1] in KEYWORDS or CHANCE.search(match[2]):
                self.source.refuse("statements as x = 2*y, without chance", 0, shown(part.strip()))
            if match[1] in self.shared:
                self.source.refuse("statements of a production's own names", 0, shown(match[1]))
            self.known[match[1]] = f"({self.told(match[2])})"

    def told(self, text):
        """A formula with the formulas of names in their place."""
        if not self.known:
            return text
        found = NAME.sub(lambda match: self.known.get(match.group(), match.group()), text)
        if len(found) > LONGEST:
            self.source.refuse(f"at most {LONGEST} characters where statements are told in full", 0, f"{len(found)}")
        self.spend(len(found), self.source)
        return found

    def spelled(self, said):
        """A module whose parameters are told in full."""
        return said._replace(parameters=tuple(map(self.told, said.parameters))) if said.parameters else said


def parted(condition, source):
    """The statements before a condition, the condition, and the statements behind it."""
    text, before, behind = condition.strip(), "", ""
    if text.startswith("{"):
        before, closed, text = text[1:].partition("}")
        if not closed:
            source.refuse("'}' behind statements", 0, shown(source.text))
    text = text.strip()
    if text.endswith("}"):
        text, opened, behind = text[:-1].rpartition("{")
        if not opened:
            source.refuse("'{' before statements", 0, shown(source.text))
    if "{" in text or "}" in text or "{" in before or "}" in behind:
        source.refuse("statements without braces in them", 0, shown(source.text))
    return before, text.strip(), behind

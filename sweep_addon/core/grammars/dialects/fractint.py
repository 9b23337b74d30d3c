# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""FRACTINT's L-systems: a name, and in braces an angle, an axiom and rules as ``F=F+F``.

Source
------
The help of FRACTINT 20, "L-Systems": F and G go by turns of + and -, D and M by those of \\ and / in degrees. That are
two headings, of which a text may use one.
"""

import re

from ..text.passages import Passage, shown
from . import line_by_line

LINE = re.compile(r"(ANGLE)\s+(?P<parts>\d{1,4})|(AXIOM)\s+(?P<word>\S.*)|(?P<left>\S)\s*=(?P<right>.*)")
DEGREES = re.compile(r"[\\/](\d+(?:\.\d*)?|\.\d+)")
SAME = {"F": "F", "G": "f", "D": "F", "M": "f", "+": "+", "-": "-", "|": "|"}
COUNTED, MEASURED = frozenset("FG+-|"), frozenset("DM\\/")  # symbols of either heading


def translated(lines):
    """Lines in the notation of the book, and problems."""
    code = [line if line.lstrip().startswith("#") else line.partition(";")[0].upper() for line in lines]
    return line_by_line(Reader(), [Passage(line, number) for number, line in enumerate(code, 1)])


class Reader:
    """Reads one entry, line by line."""

    def __init__(self):
        self.begun, self.parts, self.heading = False, 0, None

    def line(self, passage):
        text = passage.text
        if text.startswith("#"):
            return passage.line
        if text.endswith("{"):
            if self.begun:
                passage.refuse("one curve in the text", 0, "a second one")
            self.begun = True
            return ""
        match = LINE.fullmatch(text)
        if text in ("", "}"):
            return ""
        if not match:
            passage.refuse("an angle, an axiom or a rule as F=F+F", 0, shown(text))
        if match["parts"]:
            self.parts = int(match["parts"])
            if not self.parts:
                passage.refuse("in how many parts a turn is divided", match.start("parts"), "0")
            return f"#angle {360 / self.parts!r}"
        if match["word"]:
            return f"axiom: {self.word(passage.part(match.start('word')))}"
        left = self.word(passage.part(match.start("left"), match.end("left")))
        return f"{left} -> {self.word(passage.part(match.start('right'))) or '*'}"

    def word(self, passage):
        """A word in the symbols of the book."""
        text, at, found = passage.text, 0, []
        while at < len(text):
            letter = text[at]
            degrees = DEGREES.match(text, at)
            for symbols in (COUNTED, MEASURED):
                if letter in symbols and self.heading not in (None, symbols):
                    passage.refuse("turns of one kind, F G + - or D M \\ /", at)
                self.heading = symbols if letter in symbols else self.heading
            if letter == "|" and self.parts % 2:
                passage.refuse("an even angle for |", at)
            if degrees:
                found.append(f"{'+' if letter != '/' else '-'}({degrees[1]})")
                at = degrees.end()
                continue
            if not (letter in SAME or letter in "[] " or letter.isalnum() and letter != "C"):
                passage.refuse("a symbol that has a meaning here", at)
            found.append(SAME.get(letter, letter))
            at += 1
        return "".join(found)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Houdini's L-systems: a premise, rules as ``A(i):i<5=F[+A(i+1)]:0.5``, and the values of the node, a line each.

Source
------
The help of Houdini's L-System node: its symbols, of which ``+ & \\`` turn right, up and clockwise where those of the
book turn left, down and to the left.
"""

import re

from ..deriving.draws import DRAWS
from ..text.brackets import first_outside, last_outside
from ..text.passages import Passage, shown
from ..text.productions import around, headed
from . import line_by_line
from .words import comparing, modules, unknown

WORDS = re.compile(r"[A-Za-z]+(?: +[A-Za-z]+)* *\d*")  # before the colon of a setting
LONGEST_WORDS = 40
SETTINGS = {  # what a line of the book says in its place
    "generations": "#generations {}",
    "random seed": "#seed {}",
    "seed": "#seed {}",
    "angle": "#angle {}",
    "step size": "#step {}",
    "thickness": "#width {}",
    "variable b": "#define b {}",
    "variable c": "#define c {}",
    "variable d": "#define d {}",
    "context ignore": "#ignore {}",
}
KEPT = ("step size scale", "angle scale", "thickness scale")  # what symbols need that say no number
SAME = {"F": "F", "f": "f", "G": "G", "+": "-", "-": "+", "&": "^", "^": "&", "\\": "/", "/": "\\", "|": "|"}
SAME |= {letter: letter for letter in "[]{}.%"}
SCALES = {  # symbols that scale what others say nothing of: the scale, its setting, and whether it divides
    '"': ("@Sl", "step size scale", False),
    "_": ("@Sl", "step size scale", True),
    ";": ("@Sa", "angle scale", False),
    "@": ("@Sa", "angle scale", True),
    "!": ("@Sw", "thickness scale", False),
    "?": ("@Sw", "thickness scale", True),
}
HALVES = {"H": "F", "h": "f"}
LEAVES = "JKM"
UNKNOWN = {"T": "by how much it bends", "'": "texture coordinates", "#": "texture coordinates", "g": "groups"}
MOST_WILD = DRAWS // 3  # modules ~ of a word, each of which is told by three random numbers
TURNED = 180  # degrees that ~ turns by at most, where it says nothing
VALUE = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?", re.IGNORECASE)


def translated(lines):
    """Lines in the notation of the book, and problems."""
    reader = Reader()
    passages = [Passage(line, number) for number, line in enumerate(lines, 1)]
    for passage in passages:
        reader.note(passage)
    return line_by_line(reader, passages)


class Reader:
    """Reads one text, line by line; what the node says for all of it is noted first."""

    def __init__(self):
        self.values = {}

    def note(self, passage):
        word, value = said(passage)
        if word and VALUE.fullmatch(value.text):
            self.values[word] = value.text

    def line(self, passage):
        text = passage.text
        if not text or text.startswith("#dialect") or text == "#" or text.startswith("#") and text[1].isspace():
            return text
        word, rest = said(passage)
        if word == "premise":
            return f"axiom: {self.word(rest)}"
        return self.rule(rest) if word in ("", "rule") else self.setting(word, rest, passage)

    def setting(self, word, value, passage):
        if word == "context ignore":
            return SETTINGS[word].format(self.symbols(value))
        if word not in SETTINGS and word not in KEPT:
            known = ", ".join((*SETTINGS, *KEPT))
            passage.refuse(f"a premise, a rule as A=FA, or one of {known}", 0, shown(word))
        if not VALUE.fullmatch(value.text):
            value.refuse("a number", 0, shown(value.text))
        return SETTINGS.get(word, "").format(value.text)

    def rule(self, passage):
        """A rule in the notation of the book: the sign that makes it one stands alone, and outside of brackets."""
        text = passage.text
        at = assigned(text)
        if at < 0:
            passage.refuse("a premise, a rule as A=FA, or a setting", 0, shown(text))
        head, body = passage.part(0, at), passage.part(at + 1)
        colon = first_outside(head.text, ":")
        contexts, condition = (head.part(0, colon), head.part(colon + 1).text) if colon >= 0 else (head, "")
        comparing(condition, passage)
        colon = last_outside(body.text, ":")
        chance = body.part(colon + 1).text if colon >= 0 else ""
        body = body.part(0, colon) if colon >= 0 else body
        arrow = f"-({chance})->" if chance else "->"
        condition = f" : {condition}" if condition else ""
        return f"{self.contexts(contexts)}{condition} {arrow} {self.word(body) or '*'}"

    def contexts(self, head):
        """What is replaced, between its neighbours."""
        return headed(*(part and self.symbols(part) for part in around(head)))

    def symbols(self, passage):
        """The modules of contexts and predecessors, which are renamed and nothing else."""
        found = []
        for said in modules(passage):
            if said.name not in SAME and not plain(said.name):
                unknown(passage, said, "a symbol that rules may replace here")
            found.append(said.told(SAME.get(said.name, said.name)))
        return "".join(found)

    def word(self, passage):
        """A word in the symbols of the book."""
        found = modules(passage)
        wild = sum(each.name == "~" for each in found)
        if wild > MOST_WILD:
            passage.refuse(f"at most {MOST_WILD} modules ~", 0, f"{wild}")
        return " ".join(self.module(passage, each) for each in found)

    def module(self, passage, said):
        name, parameters = said.name, said.parameters
        if len(parameters) > 1 and (name in SAME or not plain(name)):
            unknown(passage, said, f"at most one parameter of {name}")
        if name in SCALES:
            return self.scale(passage, said)
        if name in UNKNOWN:
            unknown(passage, said, f"no {name}, for {UNKNOWN[name]} is not known here")
        if name in HALVES:
            drawn = HALVES[name]
            return f"{drawn}(({parameters[0]})/2)" if parameters else f"@Sl(0.5){drawn}@Sl(2)"
        if name in LEAVES:
            return f"~{name}({parameters[0] if parameters else self.needed(passage, said, 'step size')})"
        if name == "~":
            most = f"({parameters[0] if parameters else TURNED})"
            return "".join(f"{turn}({most}*(ran(2)-1))" for turn in "&/+")
        if name == "*":
            return "/(180)"
        if name == "$" and not parameters:
            return "$"
        if name in SAME:
            return said.told(SAME[name])
        if not plain(name):
            unknown(passage, said)
        return said.told()

    def scale(self, passage, said):
        """What scales lengths, angles or widths from here on."""
        scale, setting, divides = SCALES[said.name]
        factor = said.parameters[0] if said.parameters else self.needed(passage, said, setting)
        return f"{scale}(1/({factor}))" if divides else f"{scale}({factor})"

    def needed(self, passage, said, setting):
        """The number of a setting that a symbol without parameter stands for."""
        if setting not in self.values:
            unknown(passage, said, f"a number in brackets, or a line '{setting}: ...'")
        return self.values[setting]


def said(passage):
    """The words before the colon of a line, and what is behind it; no words and the line where it is a rule.

    >>> said(Passage("Step  size: 2", 1))[0], said(Passage("rule 1: A=B", 1))[0], said(Passage("A:i<2=B", 1))[0]
    ('step size', 'rule', '')
    """
    before, colon, behind = passage.text[: LONGEST_WORDS + 1].partition(":")
    if not colon:
        before, colon, behind = passage.text[: LONGEST_WORDS + 1].partition("=")
        colon = colon if before.strip().lower() == "premise" else ""
    words = " ".join(before.lower().split()).rstrip("0123456789 ")
    named = words in ("premise", "rule")
    if not colon or not WORDS.fullmatch(before.strip()) or not named and "=" in passage.text:
        return "", passage
    return words, passage.part(len(before) + 1)


def plain(name):
    """Whether a symbol has no meaning to the turtle of Houdini."""
    return name.isalnum() and name not in {*HALVES, *LEAVES, *UNKNOWN}


def assigned(text):
    """The place of the sign between a rule and its successor, which is no comparison of a condition; or -1.

    >>> assigned("A(x):x==2=B"), assigned("!=A")
    (9, 1)
    """
    depth, condition = 0, False
    for at, letter in enumerate(text):
        depth += (letter == "(") - (letter == ")")
        condition |= letter == ":" and not depth
        compares = condition and (text[at + 1 : at + 2] == "=" or text[at - 1] in "<>=!")
        if letter == "=" and not depth and not compares:
            return at
    return -1

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""L-Py's L-systems, as far as they are plain text: declarations, values, and rules with ``-->``.

All else in such a file is Python, of which nothing is ever run: it is told with its line.

Source
------
Boudon, Pradal, Cokelaer, Prusinkiewicz, Godin: L-Py, an L-System Simulation Framework for Modeling Plant
Architecture Development Based on a Dynamic Language, Frontiers in Plant Science 3, 2012, and the help of L-Py 3.
It takes widths as radii, turns by 60 degrees where nothing is said, and derives one step.
"""

import re

from ..drawing.turtle import EDGE
from ..text.brackets import first_outside
from ..text.modules import Alphabet
from ..text.passages import Passage, shown
from ..text.productions import around, headed
from . import line_by_line
from .words import modules, unknown

DECLARED = re.compile(r"module\s+(.+)")
VALUE = re.compile(r"([A-Za-z_]\w*)\s*=(?!=)\s*(.+)", re.ASCII)
SECTION = re.compile(
    r"(axiom|derivation\s+length|production|decomposition|homomorphism|interpretation|maximum\s+depth|ignore|consider"
    r"|group)\b\s*+(\d*+)\s*+:\s*(.*)|(endlsystem|endgroup)\s*",
    re.IGNORECASE,
)
VIEW = re.compile(r"#+ INITIALISATION #+\s*")  # where L-Py's editor begins to write how a model is shown
RADIANS = re.compile(r"\b(?:sin|cos|tan|asin|acos|atan|atan2)\s*\(")
MATHEMATICS = re.compile(r"from math import\b")  # whose functions are the same here, but those of angles
DEPTHS = ("decomposition", "homomorphism")
TOLD = {"production": "", "decomposition": "decomposition:", "homomorphism": "homomorphism:"}
GRANTED = ("#angle 60", "#width 0.2", "#generations 1")
SAME = "[]{}.+-^&/\\|%Ff~"
NAMES = {"SB": "[", "EB": "]", "BP": "{", "EP": "}", "PP": ".", "Left": "+", "Right": "-", "Up": "^", "Down": "&"}
NAMES |= {"RollL": "/", "RollR": "\\", "TurnAround": "|", "RollToVert": "@v", "Cut": "%", "@v": "@v", ";": "'"}
NAMES |= {"IncColor": "'", "SetColor": "'", "?P": "?P", "?H": "?H", "?L": "?L", "?U": "?U"}
NAMES |= {"GetPos": "?P", "GetHead": "?H", "GetLeft": "?L", "GetUp": "?U"}
WIDTHS = ("_", "!", "SetWidth", "IncWidth", "DecWidth")
OTHERS = """None Pinpoint PinpointRel SetHead EulerAngles iRollL iRollR RollToHorizontal LeftReflection UpReflection
HeadingReflection MoveTo MoveRel StartScreenProjection EndScreenProjection DivScale MultScale SetScale nF StartGC EndGC
LineTo OLineTo LineRel OLineRel Sphere Box Quad Circle Label surface PglShape Frame Arrow SetContour SectionResolution
SetGuide EndGuide Sweep PositionOnGuide DecColor InterpolateColors Elasticity Tropism GetRight GetFrame TextureBaseColor
InterpolateTextureBaseColors TextureScale TextureUScale TextureVScale TextureVCoeff TextureTranslation TextureRotation
TextureTransformation MouseIns newmodule repexp GetIterator GetModule""".split()
SIGNS = re.compile(r"@[A-Z][a-z]?|@[a-z]|@\dD|\?[A-Z]|=\]|[!-~]")
LONGEST_NAME = 64  # letters of a name, as in the book


def translated(lines):
    """Lines in the notation of the book, and problems; behind them what the program takes for granted."""
    reader, end = Reader(lines), next((k for k, line in enumerate(lines) if VIEW.fullmatch(line)), len(lines))
    code = [line if "#dialect" in line else line.partition("#")[0] for line in lines[:end]]
    made, problems = line_by_line(reader, [Passage(line, number) for number, line in enumerate(code, 1)])
    made += [""] * (len(lines) - end)
    return made + list(reader.granted(made)), problems


class Reader:
    """Reads one text, line by line; its names of several letters are looked up first."""

    def __init__(self, lines):
        found = [DECLARED.match(line.partition("#")[0].strip()) for line in lines]
        declared = [name for match in filter(None, found) for name in re.findall(r"([A-Za-z_]\w*)", bare(match[1]))]
        self.declared = dict.fromkeys(declared)
        known = (*declared, *(name for name in (*NAMES, *OTHERS) if name.isalnum()))
        self.known = Alphabet(name for name in known if len(name) <= LONGEST_NAME)
        self.section, self.python, self.depths = "", False, dict.fromkeys(DEPTHS, "")

    def line(self, passage):
        """A line in the notation of the book; what is indented below Python is part of it."""
        text, source = passage.text, passage.line
        if not text:
            return ""
        if text.startswith("#dialect"):
            return text
        if source[:1].isspace() and self.python:
            return ""
        self.python = False
        if DECLARED.fullmatch(text):
            names = [self.renamed(name) for name in re.findall(r"[A-Za-z_]\w*", bare(DECLARED.fullmatch(text)[1]))]
            return f"#names {', '.join(names)}" if any(len(name) > 1 for name in names) else ""
        section = SECTION.fullmatch(text)
        if section:
            return self.sectioned(passage, section)
        if first_outside(text, "-->") >= 0:
            return self.rule(passage)
        if MATHEMATICS.match(text):
            return ""
        value = VALUE.fullmatch(text)
        if value and not source[:1].isspace():
            return f"#define {value[1]} {self.formula(passage.part(value.start(2)))}"
        self.python = True
        passage.refuse("a declaration, a value, or a rule with '-->', for Python is never run", 0, shown(text))

    def sectioned(self, passage, match):
        if match[4]:
            return ""
        kind = " ".join(match[1].lower().split())
        kind = "homomorphism" if kind == "interpretation" else kind
        rest = passage.part(match.start(3))
        if kind == "group" and match[2].strip("0"):
            passage.refuse("group 0, for the others are chosen by Python", 0, shown(passage.text))
        if kind == "axiom":
            return f"axiom: {self.word(rest)}"
        if kind == "derivation length":
            return f"#generations {rest.text}"
        if kind in ("ignore", "consider"):
            return f"#{kind} {' '.join(self.renamed(said.name) for said in self.modules(commas(rest)))}"
        if kind == "maximum depth":
            if self.section not in DEPTHS:
                passage.refuse("decomposition: or homomorphism: above a depth", 0, shown(passage.text))
            self.depths[self.section] = ""
            return f"maximum depth: {rest.text}"
        if kind in DEPTHS:
            self.depths[kind] = "maximum depth: 1"
        self.section = kind if kind in TOLD else self.section
        return TOLD.get(kind, "")

    def rule(self, passage):
        at = first_outside(passage.text, "-->")
        head, body = passage.part(0, at), passage.part(at + 3)
        if ">>" in head.text or "<<" in head.text:
            passage.refuse("contexts with < and >, of the word before the step", 0, shown(head.text))
        colon = first_outside(head.text, ":")
        if colon >= 0:
            expected = "no condition, which L-Py has in Python; without '#dialect lpy' it is A(x) : x > 3 -> B"
            head.refuse(expected, colon, shown(head.part(colon).text))
        contexts = headed(*(part and self.heads(part) for part in around(head)))
        return f"{contexts} -> {self.word(body) if body.text not in ('', '*') else '*'}"

    def heads(self, passage):
        """The modules of a predecessor or a context."""
        found = []
        for said in self.modules(passage):
            if said.name in (*OTHERS, *WIDTHS, "x", "*", "=]", "or"):
                unknown(passage, said, "modules by their names")
            found.append(said.told(NAMES.get(said.name, self.renamed(said.name))))
        return " ".join(found)

    def word(self, passage):
        return " ".join(self.module(passage, said) for said in self.modules(passage))

    def module(self, passage, said):
        """A module in the symbols of the book."""
        name = said.name
        for parameter in said.parameters:
            self.formula(Passage(parameter, passage.number), passage, said)
        if name in self.declared or name.isalnum() and len(name) == 1 and name not in "Ff":
            return said.told(self.renamed(name))
        if name in WIDTHS:
            if len(said.parameters) != 1:
                unknown(passage, said, f"a radius in brackets behind {name}")
            return f"!(2*({said.parameters[0]}))"
        if name in NAMES:
            return said.told(NAMES[name])
        if name not in SAME:
            unknown(passage, said)
        if len(said.parameters) > 1:
            unknown(passage, said, f"at most one parameter of {name}")
        return said.told()

    def modules(self, passage):
        return modules(passage, self.named)

    def named(self, text, at):
        """The longest declared name at a place, or the sign or letter there."""
        if text[at].isalpha() or text[at] == "_":
            return self.known.named(text, at) if text[at] in self.known.initials else text[at]
        return SIGNS.match(text, at)[0] if SIGNS.match(text, at) else text[at]

    def formula(self, passage, whole=None, said=None):
        """A formula, which is text here as there, where it has no angles."""
        wrong = RADIANS.search(passage.text)
        if wrong and whole:
            unknown(whole, said, "no angles in formulas, which are in radians there")
        if wrong:
            passage.refuse("no angles in formulas, which are in radians there", wrong.start(), shown(wrong.group()))
        return passage.text

    def granted(self, made):
        """Lines that say what this program says of itself."""
        said = "\n".join(made)
        yield from (line for line in GRANTED if line.split()[0] not in said)
        other = self.renamed("G")
        yield from [f"#names {other}"] if other in said and "G" not in self.declared else []
        for section, depth in self.depths.items():
            yield from [f"{section}:", depth] if depth else []

    def renamed(self, name):
        """A name that draws nothing there and must not here, and that no other module has."""
        if name == "G" or EDGE.fullmatch(name):
            name += "_"
            while name in self.declared:
                name += "_"
        return name


def bare(text):
    """A list of modules without their parameters."""
    return re.sub(r"\([^()]*\)", "", text)


def commas(passage):
    """A list of names without its commas."""
    return Passage(passage.line.replace(",", " "), passage.number, passage.start)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""cpfg's L-systems: keywords with colons, ``-->``, probabilities behind the successor, and constants that are pasted.

Source
------
Prusinkiewicz, Hanan, Mech, Karwowski: L-studio/cpfg User's Manual, 1999; and the grammar of cpfg itself, part of
vlab, which is free. The lines of a view file may stand in the same text.
"""

import re

from ..deriving.statements import assigned
from ..deriving.subsystems import BEGINS
from ..text.brackets import first_outside, last_outside
from ..text.modules import ENVIRONMENT, QUERIES
from ..text.passages import Passage, shown
from ..text.productions import around, headed
from . import line_by_line
from .local import Locals, parted
from .pasting import DEFINED, Pasting, joined, uncommented
from .words import comparing, modules, unknown

KEYWORDS = {  # what a line of the book says in its place; None where it says nothing
    "lsystem": None,
    "endlsystem": None,
    "derivation length": "#generations {}",
    "seed": "#seed {}",
    "ignore": "#ignore {}",
    "consider": "#consider {}",
    "axiom": "axiom: {}",
    "decomposition": "decomposition:",
    "homomorphism": "homomorphism:",
    "maximum depth": "maximum depth: {}",
    "angle increment": "#angle {}",
    "angle factor": "#angle 360/({})",
    "initial line width": "#width {}",
}
SPELLED = {word.replace(" ", ""): word for word in KEYWORDS}  # blanks in them do not matter
VIEW = """viewpoint|view reference point|view|projection|front distance|back distance|scale factor|z buffer|cue range
|shade mode|render mode|light direction|light|diffuse reflection|line style|contour sides|polygonization level|winfont
|font|window|window border|viewing angle|background scene|shadow map|box|initial color|line width increment
|elasticity increment|tropism direction|tapered lines|surface diffuse|surface ambient|surface|texture|type|message
|origin|min/max|corrected rotation|colors|scale""".replace("\n", "")
ZERO = ("initial elasticity", "twist", "torque")  # lines of a view that say nothing where they say 0
PATTERN = re.compile(
    r"\s*(" + "|".join(word.replace(" ", r"\s*") for word in KEYWORDS) + r")\b\s*:?(.*)", re.IGNORECASE | re.DOTALL
)
SHOWN = re.compile(rf"\s*(?:{VIEW.replace(' ', chr(92) + 's*')})\s*:.*", re.IGNORECASE)
NOTHING = re.compile(rf"\s*(?:{'|'.join(ZERO)})\s*+:\s*+0*+(?:\.0*+)?+\s*|\s*color increment\s*:\s*1\s*", re.IGNORECASE)
SAME = frozenset("Ff+-&^\\/|[]{}.%~G$")
RENAMED = {";": "'", ",": "'", "!": "!", "#": "!"}
KNOWN = ("@v", "@Gs", "@Gc", "@Ge", "@Gt", "?P", "?H", "?L", "?U", "?E")
ORGANS = {"@O": "sphere", "@o": "circle", "@c": "circle"}  # of the diameter that they say
MOVES = "g"  # without a line or a vertex
BLOCK = re.compile(r"\s*(start|end)\s*+(each)?\s*+:(.*)", re.IGNORECASE | re.DOTALL)
ABSOLUTE = re.compile(r"\bfabs(?=\s*\()")
DIFFERENT = re.compile(r"\b(trunc|atan2)\s*\(")  # the one rounds there, and of the other the order is not known
GRANTED = "maximum depth: 1"  # of a homomorphism and a decomposition, where the text says nothing


def named(text, at):
    """The name of the module at a place: of what begins with @ two letters, or three after @G, and of queries two."""
    if text[at].isalnum():
        return text[at]
    long = text[at : at + 3]
    if long[:2] == "@G" and long[2:] in ("s", "c", "e", "t"):
        return long
    return long[:2] if long[0] == "@" or long[0] == "?" and long[1:2].isupper() else long[0]


def translated(lines):
    """Lines in the notation of the book, and problems."""
    code = joined(uncommented("\n".join(lines)).split("\n"))
    reader = Reader()
    made, problems = line_by_line(reader, code, [Passage(line, number) for number, line in enumerate(lines, 1)])
    return made + reader.granted(), problems


class Reader:
    """Reads one text, line by line."""

    def __init__(self):
        self.pasting, self.depths, self.organs, self.section = Pasting(), {}, {}, ""
        self.queries, self.variables, self.systems = False, {}, 0

    def line(self, line, source):
        """A line in the notation of the book."""
        defined = DEFINED.match(line)
        if defined:
            self.pasting.define(defined, source)
            return ""
        if line.lstrip().startswith("#") and "-->" not in line:
            if not line.lstrip().startswith("#dialect"):
                file = source.text.removeprefix("#").lstrip().startswith("include")
                expected = "the lines of that file in its place, for no file reads another" if file else "#define"
                source.refuse(expected, 0, shown(source.text))
            return line
        line = self.pasting.pasted(line, source)
        line = ABSOLUTE.sub("abs", line)
        other = DIFFERENT.search(line)
        if other:
            source.refuse("no functions that mean something else here", 0, shown(other.group(1)))
        if SHOWN.fullmatch(line) or NOTHING.fullmatch(line):
            return ""
        block = BLOCK.fullmatch(line)
        if block and "-->" not in line:
            return self.block(block, source)
        keyword = PATTERN.fullmatch(line)
        if keyword and "-->" not in line:
            word = SPELLED["".join(keyword[1].lower().split())]
            return self.keyword(word, Passage(keyword[2], source.number), source)
        return self.production(line, source) if line.strip() else ""

    def block(self, match, source):
        """A line of statements, which give variables of the whole derivation their values."""
        if self.systems > 1:
            source.refuse("productions of the sub-system alone", 0, shown(source.text))
        told = Passage(match[3], source.number)
        self.variables |= dict.fromkeys(name for name, _ in assigned(told))
        return f"{match[1].lower()}{' each' if match[2] else ''}: {told.text.strip('{}')}"

    def keyword(self, word, rest, source):
        if word == "lsystem":
            self.systems += 1
            return f"lsystem {rest.text}:" if self.systems > 1 else ""
        if self.systems > 1 and word not in ("endlsystem", "axiom", "derivation length"):
            source.refuse("productions of the sub-system alone", 0, shown(source.text))
        if self.systems > 1 and word != "endlsystem":
            return ""  # of the first system alone
        if word in ("decomposition", "homomorphism"):
            self.section, self.depths[word] = word, GRANTED
            return f"{word}:"
        if word == "seed" and self.section:
            source.refuse("one seed, of all random numbers", 0, shown(source.text))
        if word == "maximum depth":
            self.depths[self.section] = ""
        if word in ("ignore", "consider"):
            told = " ".join(RENAMED.get(said.name, said.name) for said in modules(rest, named) if said.name not in "[]")
            return KEYWORDS[word].format(told)
        told = self.word(rest) if word == "axiom" else rest.text
        return KEYWORDS[word].format(told) if KEYWORDS[word] else ""

    def granted(self):
        """Lines that say what the program says of itself."""
        names = [f"#names {', '.join(self.organs)}"] if self.organs else []
        names += ["#heading y"] if self.queries else []  # coordinates are told, so they have to be those of cpfg
        return names + [line for section, depth in self.depths.items() if depth for line in (f"{section}:", depth)]

    def production(self, line, source):
        """A production in the notation of the book."""
        head, arrow, successor = line.partition("-->")
        if not arrow:
            source.refuse("a keyword, or a production with '-->'", 0, shown(source.text))
        colon = first_outside(head, ":")
        contexts, condition = (head[:colon], head[colon + 1 :].strip()) if colon >= 0 else (head, "")
        before, condition, behind = parted(condition, source)
        own = Locals(tuple(self.variables), source, self.pasting.spend)
        own.assign(before)
        condition = own.told(condition)
        own.assign(behind)
        comparing(condition, source)
        condition = f" : {condition}" if condition not in ("", "*") else ""
        contexts = re.sub(r"^\s*\*\s*<|>\s*\*\s*$", "", contexts).replace("=]", "]")
        left, strict, right = (part and self.heads(part) for part in around(Passage(contexts, source.number)))
        if left and "[" in left:
            source.refuse("a left context without brackets, which it never finds", 0, shown(left))
        colon = last_outside(successor, ":")
        body, chance = (successor[:colon], successor[colon + 1 :].strip()) if colon >= 0 else (successor, "")
        arrow = f"-({own.told(chance)})->" if chance else "->"
        body = body.strip() if body.strip() == "*" else self.word(Passage(body, source.number), own)
        return f"{headed(left, strict, right)}{condition} {arrow} {body}"

    def heads(self, passage):
        """The modules of a predecessor or a context, which are renamed and nothing else."""
        found = []
        for said in modules(passage, named):
            if said.name in ("#", ",", *ORGANS):
                unknown(passage, said, f"modules other than {said.name}")
            found.append(said.told(RENAMED.get(said.name, said.name)))
        return " ".join(found)

    def word(self, passage, own=None):
        """A word in the symbols of the book."""
        found = modules(passage, named)
        if own:
            found = [own.spelled(said) for said in found]
        return " ".join(self.module(passage, said) for said in found)

    def module(self, passage, said):
        name = said.name
        if name.isalnum() and name != MOVES:
            return said.told()
        self.queries |= name in (*QUERIES, ENVIRONMENT)
        if name == "@v" and self.queries:
            unknown(passage, said, "no @v beside queries, for up is y there and z here")
        if name in ("!", "#", ",", *ORGANS) and len(said.parameters) != 1:
            unknown(passage, said, f"one number in brackets behind {name}")
        if name in ORGANS:
            self.organs[ORGANS[name]] = None
            return f"~{said.told(ORGANS[name])}"
        if name in RENAMED:
            return said.told(RENAMED[name])
        if name == BEGINS and said.parameters:
            return said.told()
        if name not in SAME and name not in KNOWN and not name.isalnum() or name == MOVES:
            unknown(passage, said)
        return said.told()

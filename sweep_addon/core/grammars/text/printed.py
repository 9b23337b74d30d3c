# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grammars as books print them: signs that no keyboard has, and the legend under a figure, n=5, δ=25.7°."""

import re

from .directives import DIRECTIVE, WORDS

SIGNS = str.maketrans("−–∗×·⋅∧ˆ∼˜’‘′⟨⟩〈〉ε◦º∘˚", "--****^^~~'''<><>*°°°°")
SIGNS |= str.maketrans("₀₁₂₃₄₅₆₇₈₉ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ", "0123456789aehijklmnoprstuvx")
COMPARED = {"≤": "<=", "≥": ">=", "≠": "!="}
WIDER = re.compile("[ \u00a0]?([→≤≥≠])")  # a blank gives way, so that what follows keeps its column
CHANCE = re.compile(r"->\s*+\(([^()]*+)\)")  # over its arrow in print; a word begins with no bracket
UNNUMBERED = re.compile(  # the label of an only production; a module p with a condition compares something
    r"^(\s*+)(p\s*+: ?)(?=\s*+[^\s<>=!&|:\d]++\s*+(?:->|→|-\()|[^→=\d:]*+→|[^:<>=→]*+:)"
)
REMARK = re.compile(r"#|/\*")
LEGEND = re.compile(r"\s*+(?:n\s*+=\s*+(\d++))?\s*+,?\s*+(?:(?:δ|delta)\s*+=\s*+(-?[\d.]++)\s*+°?)?\s*+")


def typed(line):
    """A line with the signs that keyboards have, up to its comment, which may also stand as in C.

    >>> typed("p1 : F(s) : s ≥ 3 → F[+F]F[−F]F  # → a plant")
    'p1 : F(s) : s>= 3-> F[+F]F[-F]F  # → a plant'
    >>> typed("#define q c − p /* the rest */"), typed("F →(.33) F[−F]")
    ('#define q c - p #  the rest ', 'F-(.33)-> F[-F]')
    >>> typed("p : F → F−F"), typed("p : x>1 -> q")
    ('p1: F-> F-F', 'p : x>1 -> q')
    """
    match = DIRECTIVE.match(line)
    start = match.end() if match and match[1] in WORDS else 0
    code, mark, comment = remarked(line[start:]).partition("#")
    code = UNNUMBERED.sub(lambda match: f"{match[1]}{'p1:' if len(match[2]) > 2 else '':{len(match[2])}}", code)
    if not code.isascii():
        wider = WIDER.sub(lambda match: COMPARED.get(match[1], "->"), code.translate(SIGNS))
        code = wider.replace("\u00a0", " ")
    return line[:start] + CHANCE.sub(r"-(\1)->", code) + mark + comment


def remarked(code):
    """The rest of a line whose comments as in C are blanks, or where nothing is behind one a comment as here.

    >>> remarked("F /* a */ -> F /* b */")
    'F         -> F #  b '
    """
    parts, at, end = [], 0, len(code.rstrip())
    while (match := REMARK.search(code, at)) and match[0] != "#":
        close = code.find("*/", match.end())
        if close < 0 or close + 2 >= end:
            return "".join((*parts, code[at : match.start()], "# ", code[match.end() : close if close >= 0 else None]))
        parts += [code[at : match.start()], " " * (close + 2 - match.start())]
        at = close + 2
    return "".join((*parts, code[at:]))


def legend(text):
    """The generations and the angle, as text or None each, that a legend tells; None where it is none.

    >>> legend("n=5, δ=25.7°"), legend("δ = 90"), legend("F"), legend("")
    (('5', '25.7'), (None, '90'), None, None)
    """
    match = LEGEND.fullmatch(text)
    return match.groups() if match and any(match.groups()) else None

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grammars as books print them: signs that no keyboard has, and the legend under a figure, n=5, δ=25.7°."""

import re

SIGNS = str.maketrans("−–∗∧∼˜’′⟨⟩〈〉", "--*^~~''<><>")
COMPARED = {"≤": "<=", "≥": ">=", "≠": "!="}
WIDER = re.compile("[ \u00a0]?([→≤≥≠])")  # a blank gives way, so that what follows keeps its column
LEGEND = re.compile(r"\s*+(?:n\s*+=\s*+(\d++))?\s*+,?\s*+(?:(?:δ|delta)\s*+=\s*+(-?[\d.]++)\s*+°?)?\s*+")


def typed(line):
    """A line with the signs that keyboards have, up to its comment.

    >>> typed("p1 : F(s) : s ≥ 3 → F[+F]F[−F]F  # → a plant")
    'p1 : F(s) : s>= 3-> F[+F]F[-F]F  # → a plant'
    """
    code, mark, comment = line.partition("#")
    if code.isascii():
        return line
    wider = WIDER.sub(lambda match: COMPARED.get(match[1], "->"), code.translate(SIGNS))
    return wider.replace("\u00a0", " ") + mark + comment


def legend(text):
    """The generations and the angle, as text or None each, that a legend tells; None where it is none.

    >>> legend("n=5, δ=25.7°"), legend("δ = 90"), legend("F"), legend("")
    (('5', '25.7'), (None, '90'), None, None)
    """
    match = LEGEND.fullmatch(text)
    return match.groups() if match and any(match.groups()) else None

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines that are no production: in which notation, or from which file, they most likely are."""

import re

KNOWN = (  # how lines begin in the texts of other programs, and what to do there
    (re.compile(r"premise\b", re.IGNORECASE), "Houdini's texts begin with a line '#dialect houdini'"),
    (
        re.compile(r"(?:derivation\s+length|production|endlsystem)\b\s*:?", re.IGNORECASE),
        "texts of cpfg begin with a line '#dialect cpfg', those of L-Py with '#dialect lpy'",
    ),
    (re.compile(r"lsystem\b", re.IGNORECASE), "texts of cpfg begin with a line '#dialect cpfg'"),
    (re.compile(r"(?:module|produce|from|import|def)\s"), "texts of L-Py begin with a line '#dialect lpy'"),
    (re.compile(r"\w+\s*\{$"), "texts of Fractint begin with a line '#dialect fractint'"),
    (
        re.compile(r"T\s*=\s*\("),
        "a tropism is written '#tropism 0 0 -1 0.22', its direction with z upwards, where the book has y, and e",
    ),
    (
        re.compile(r"\S\s*(?:\([^()]*\))?\s*=(?!=)"),
        "rules with '=' are Houdini's, '#dialect houdini', or Fractint's, '#dialect fractint'",
    ),
)
SETTING = re.compile(r"(angle|step|width|generations|seed|tropism|heading)\s*[:=]?\s*\S", re.IGNORECASE)
FILE = re.compile(r"\S[^\n]*\.(?:l|lpy|ls|lsys|txt)", re.IGNORECASE)


def hint(text):
    """What to add to the refusal of a line without an arrow; often nothing.

    >>> hint("angle: 25")
    "; a directive is written '#angle 25'"
    >>> hint("F[+F]")
    ''
    """
    if SETTING.match(text):
        word, value = re.match(r"(\w+)\s*[:=]?\s*(.*)", text).groups()
        return f"; a directive is written '#{word.lower()} {value}'" if len(value) < 20 else ""
    if FILE.fullmatch(text):
        return "; a file is read by system = { file = '...' } in a job, and in Python by Path('...').read_text()"
    return next((f"; {told}" for pattern, told in KNOWN if pattern.match(text)), "")

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""cpfg's L-systems: keywords with colons, ``-->``, probabilities behind the successor, and constants that are pasted.

Source
------
Prusinkiewicz, Hanan, Mech, Karwowski: L-studio/cpfg User's Manual, 1999. Lines of a view file that say angle and width
may stand in the same text.
"""

import re

from ..passages import Passage, PassageError, shown

COMMENT = re.compile(r"/[*/]")
DEFINED = re.compile(r"\s*#\s*define\s+([A-Za-z_]\w*)(\()?\s*(.*)")
NAME = re.compile(r"[A-Za-z_]\w*")
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
KEYWORD = re.compile(
    r"\s*(" + "|".join(word.replace(" ", r"\s+") for word in KEYWORDS) + r")\b\s*:?(.*)", re.IGNORECASE
)
UNKNOWN = re.compile(r"\b(?:sin|cos|tan|asin|acos|atan|atan2)\s*\(")  # their unit is that of the program's version
MOST_PASTED, MOST_TOLD, LONGEST = 20, 200, 100_000  # rounds, characters of a constant, and of a line with constants


def translated(lines):
    """Lines in the notation of the book, and problems."""
    code = uncommented("\n".join(lines)).split("\n")
    made, problems, pasted = [], [], {}
    for number, (line, source) in enumerate(zip(code, lines, strict=True), 1):
        try:
            made.append(one(line, Passage(source, number), pasted))
        except PassageError as wrong:
            problems.append(wrong.problem)
            made.append("")
    return made, problems


def uncommented(text):
    """A text with blanks in the place of its comments."""
    parts, at = [], 0
    while match := COMMENT.search(text, at):
        end = text.find("*/" if match.group() == "/*" else "\n", match.end())
        end = len(text) if end < 0 else end + 2 * (match.group() == "/*")
        parts += [text[at : match.start()], "\n" * text.count("\n", match.start(), end) or " "]
        at = end
    return "".join((*parts, text[at:]))


def one(line, source, pasted):
    """A line in the notation of the book."""
    defined = DEFINED.match(line)
    if defined:
        if defined[2]:
            source.refuse("a constant without parameters", 0, "a macro")
        if len(defined[3]) > MOST_TOLD:
            source.refuse(f"at most {MOST_TOLD} characters to be pasted", 0, f"{len(defined[3])}")
        pasted[defined[1]] = defined[3].strip()
        return ""
    if line.lstrip().startswith("#"):
        if not line.lstrip().startswith("#dialect"):
            source.refuse("#define", 0, shown(source.text))
        return line
    line = paste(line, source, pasted)
    if UNKNOWN.search(line):
        source.refuse("no angles in formulas, whose unit is not known", 0, shown(UNKNOWN.search(line).group()))
    keyword = KEYWORD.fullmatch(line)
    if keyword and "-->" not in line:
        told = KEYWORDS[" ".join(keyword[1].lower().split())]
        return told.format(keyword[2].strip()) if told else ""
    return production(line, source) if line.strip() else ""


def paste(line, source, pasted):
    """A line with the text of constants in the place of their names."""
    for _ in range(MOST_PASTED if pasted else 0):
        if len(line) > LONGEST:
            source.refuse(f"at most {LONGEST} characters where constants are pasted", 0, f"{len(line)}")
        longer = NAME.sub(lambda match: pasted.get(match.group(), match.group()), line)
        if longer == line:
            return line
        line = longer
    if pasted:
        source.refuse("constants that do not need each other", 0, shown(source.text))
    return line


def production(line, source):
    """A production in the notation of the book."""
    head, arrow, successor = line.partition("-->")
    if not arrow:
        source.refuse("a keyword, or a production with '-->'", 0, shown(source.text))
    if "{" in head:
        source.refuse("a condition without statements", 0, "'{'")
    contexts, colon, condition = head.partition(":")
    condition = condition.strip() if condition.strip() != "*" else ""
    contexts = re.sub(r"^\s*\*\s*<|>\s*\*\s*$", "", contexts).replace("=]", "]")
    body, chance = parted(successor)
    arrow = f"-({chance})->" if chance else "->"
    return f"{contexts}{f' : {condition}' if condition else ''} {arrow} {body}"


def parted(successor):
    """A successor and its probability, which stands behind the last colon outside of brackets."""
    text, depth, at = successor.strip(), 0, -1
    for place, letter in enumerate(text):
        depth += (letter == "(") - (letter == ")")
        at = place if letter == ":" and not depth else at
    return (text[:at].strip(), text[at + 1 :].strip()) if at >= 0 else (text, "")

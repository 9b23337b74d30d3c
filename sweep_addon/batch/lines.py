# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines: where in a TOML text a key is set, so that a refusal can point at it."""

import re

KEY = r"""(?:[\w-]+|"[^"\n]*"|'[^'\n]*')"""
KEYS = rf"{KEY}(?:[ \t]*\.[ \t]*{KEY})*"
HEADER = re.compile(rf"\s*\[\[?\s*({KEYS})\s*\]\]?\s*$")
SETTING = re.compile(rf"\s*({KEYS})\s*=")
TEXTS = re.compile(
    r'"""(?:\\.|[^\\])*?"""|' + r"'''.*?'''|" + r'"(?:\\.|[^"\\\n])*"|' + r"'[^'\n]*'|#[^\n]*", re.DOTALL | re.ASCII
)


def line_of(text, key):
    """The number of the line that sets a key, or else the table it belongs to, or 1.

    The text must be valid TOML.

    >>> line_of('kind = "tube"\\n[contour]\\nradius = 2', "contour.radius")
    3
    """
    wanted = key.split(".")
    header, depth, best, length = [], 0, 1, 0
    for number, line in enumerate(TEXTS.sub(blank, text).split("\n"), 1):
        found, path = None, header
        if depth == 0:
            found = HEADER.match(line) or SETTING.match(line)
            if found:
                path = names(found[1]) if found.re is HEADER else header + names(found[1])
                header = path if found.re is HEADER else header
        if found and len(path) > length and path == wanted[: len(path)]:
            best, length = number, len(path)
        depth += sum(map(line.count, "[{")) - sum(map(line.count, "]}"))
    return best


def blank(text):
    """A text or comment without what could be taken for structure, on as many lines and in as many columns."""
    if text[0].startswith("#"):
        return " " * len(text[0])
    quote = text[0][0]
    return quote + re.sub(r"[^\w\n-]", "_", text[0][1:-1]) + quote


def names(keys):
    """The parts of a dotted key."""
    return [part.strip("\"'") for part in re.findall(KEY, keys)]

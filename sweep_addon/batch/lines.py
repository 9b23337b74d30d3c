# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines: where in a TOML text a key is set, so that a refusal can point at it."""

import re

KEY = r"""(?:[\w-]+|"[^"\n]*"|'[^'\n]*')"""
KEYS = rf"{KEY}(?:[ \t]*\.[ \t]*{KEY})*"
HEADER = re.compile(rf"\s*\[\[?\s*({KEYS})\s*\]\]?\s*$")
SETTING = re.compile(rf"\s*({KEYS})\s*=")
ITSELF = ""  # behind the path of what a line sets; without it, of what a line sets something in
TEXTS = re.compile(
    r'"""(?:\\.|[^\\])*?"""|' + r"'''.*?'''|" + r'"(?:\\.|[^"\\\n])*"|' + r"'[^'\n]*'|#[^\n]*", re.DOTALL | re.ASCII
)


def line_of(text, key):
    """The number of the line that sets a key, or else the table it belongs to, or something in it, or 1.

    The text must be valid TOML.

    >>> line_of('kind = "tube"\\n[contour]\\nradius = 2', "contour.radius")
    3
    >>> line_of("[[steps]]\\n[[steps]]\\n[steps.operand]\\nradius = 2", "steps.2.operand.radius")
    4
    """
    return lines_of(text, [key])[0]


def lines_of(text, keys):
    """The lines of several keys, as `line_of` has them, for which the text is gone through once."""
    lines = {}
    for number, path in paths(text):
        lines.setdefault((*path, ITSELF), number)
        for length in range(1, len(path)):
            lines.setdefault(tuple(path[:length]), number)
    return [nearest(lines, key) for key in keys]


def nearest(lines, key):
    """The line of a key, or of the most of it that has one."""
    wanted = [re.sub(r"[^\w-]", "_", part.strip("\"'")) for part in key.split(".")]  # as in a text that is blanked
    for length in range(len(wanted), 0, -1):
        found = lines.get((*wanted[:length], ITSELF)) or lines.get(tuple(wanted[:length]))
        if found:
            return found
    return 1


def paths(text):
    """Yield each line that opens a table or sets a key, by its number, and the path of that."""
    header, depth, counts = [], 0, {}
    for number, line in enumerate(TEXTS.sub(blank, text).split("\n"), 1):
        found = (HEADER.match(line) or SETTING.match(line)) if depth == 0 else None
        if found:
            path = opened(found, counts) if found.re is HEADER else header + names(found[1])
            header = path if found.re is HEADER else header
            yield number, path
        depth += sum(map(line.count, "[{")) - sum(map(line.count, "]}"))


def opened(header, counts):
    """The path of the table that a header opens, in which an item of a list has its number, from 1.

    How many items each list has is counted: a header names the last of those that it goes through.
    """
    path, parts = [], names(header[1])
    for part in parts[:-1]:
        path.append(part)
        path += [str(counts[*path])] if tuple(path) in counts else []
    path.append(parts[-1])
    if header[0].lstrip().startswith("[["):
        counts[*path] = counts.get(tuple(path), 0) + 1
        for inner in [key for key in counts if len(key) > len(path) and key[: len(path)] == tuple(path)]:
            del counts[inner]
        path.append(str(counts[*path]))
    return path


def blank(text):
    """A text or comment without what could be taken for structure, on as many lines and in as many columns."""
    if text[0].startswith("#"):
        return " " * len(text[0])
    quote = text[0][0]
    return quote + re.sub(r"[^\w\n-]", "_", text[0][1:-1]) + quote


def names(keys):
    """The parts of a dotted key."""
    return [part.strip("\"'") for part in re.findall(KEY, keys)]

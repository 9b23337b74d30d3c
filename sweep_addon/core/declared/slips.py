# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Slips in TOML: what would do in the place of a line that is none."""

import re
import tomllib

from .refusals import MOST
from .wording import shown

LONGEST = 200  # characters of a line that are looked at
LONG = 1_000_000  # characters of a text that is not read again

BARE = re.compile(r"""^[ \t]*([\w-]+)[ \t]*=[ \t]*([^\s"'\[{#][^"'#]*)""")
BARE_INSIDE = re.compile(r"""[{,][ \t]*([\w-]+)[ \t]*=[ \t]*([^\s"'\[{},#][^"'\[\]{},#=]*)(?![^,}]*=)""")
VALUE = re.compile(r"[+-]?(?:[\d_]+(?:\.[\d_]+)?(?:[eE][+-]?\d+)?|inf|nan|0[xob]\w+)|true|false|\d{4}-\d\d.*|\d\d:.*")
LIKE_TEXT = re.compile(r"[^\W\d]|[*/^(]")
NUMBER = re.compile(r"[+-]?(?:0+\d+\.?\d*|\d+\.|\.\d+)(?:[eE][+-]?\d+)?")  # as other languages have them

ENDED = "a text ends with the quote that it begins with, on the same line"
BACKSLASH = "a backslash stands for itself between single quotes only"
ONCE = "each parameter and each table is told once"
ONE_LINE = "an inline table, in { }, stands on one line; of more lines it is a section, as [contour]"
WOULD_DO = {  # by how the parser of Python's library begins to say what is wrong
    "Expected '='": "a line is key = value, [table] or a comment after #",
    "Invalid statement": "a line is key = value, [table] or a comment after #",
    "Invalid initial character for a key": "a key has letters, digits, _ and -",
    "Invalid value": 'after = stands a number, "text", true, false, a [list] or a { table }',
    "Expected newline": "a line ends after its value",
    "Expected ']]'": "the name of a list of tables stands between two brackets, as [[steps]]",
    "Expected ']'": "the name of a table stands between brackets, as [contour]",
    "Unclosed array": "a list ends with ], with commas between its values",
    "Unclosed inline": "a table in one line ends with }, with commas between its values",
    "Unterminated": ENDED,
    "Expected \"'": ENDED,
    "Illegal character '\\n'": ENDED,
    "Found invalid character '\\n'": ENDED,
    "Unescaped": BACKSLASH,
    "Invalid hex": BACKSLASH,
    "Escaped character": BACKSLASH,
    "Cannot": ONCE,
    "Duplicate": ONCE,
}


def slips(text, error):
    """What is wrong in a text that is no TOML: the number of a line and what to say of it, for each.

    After a line of which it is clear what was meant, the text is read without it for the next.
    """
    lines = text.split("\n")
    for _ in range(MOST):
        said, _, place = str(error).rpartition(" (at ")
        found = re.match(r"line (\d+), column (\d+)", place)
        number = int(found[1]) if found else len(text.splitlines()) or 1  # at its end
        whole = "".join(lines[number - 1 : number])
        wrong = whole.strip()[:LONGEST]
        broken = found and said.startswith("Invalid initial") and goes_on(whole, int(found[2]) - 1)
        yield number, f"{ONE_LINE}, got {shown(wrong)}" if broken else corrected(wrong, said)
        if not meant(wrong) or len(text) > LONG:
            return
        lines[number - 1] = ""
        try:
            tomllib.loads("\n".join(lines))
            return
        except tomllib.TOMLDecodeError as next_error:
            error = next_error
        except (ValueError, RecursionError):
            return


def goes_on(line, column):
    """Whether a line ends within an inline table, at a column from which no more than a comment stands."""
    return line[:column].rstrip().endswith(("{", ",")) and line[column:].lstrip()[:1] in ("", "#")


def corrected(line, said):
    """What would do in the place of a line that is no TOML.

    Parameters
    ----------
    line : str
    said : str
        What Python's parser says of it.

    Returns
    -------
    str

    Examples
    --------
    >>> corrected('kind "circle"', "Expected '=' after a key in a key/value pair")
    'a line is key = value, [table] or a comment after #, got \\'kind "circle"\\''
    """
    known = next((advice for beginning, advice in WOULD_DO.items() if said.startswith(beginning)), None)
    return meant(line) or f"{known or said[:1].lower() + said[1:]}, got {shown(line)}"


def meant(line):
    """What was meant by a line with a bare text or a number of other languages in it; often nothing.

    >>> meant("twist = 2*pi*t  # a turn")
    'text and formulas stand in quotes: twist = "2*pi*t"'
    >>> meant("radius = .5"), meant("closed = True")
    ('a number is written so: radius = 0.5', 'true and false have small letters: closed = true')
    """
    for key, text in BARE.findall(line) + BARE_INSIDE.findall(line):
        text = text.strip()
        if NUMBER.fullmatch(text):
            return f"a number is written so: {key} = {float(text):.15g}"
        if text in ("True", "False", "TRUE", "FALSE"):
            return f"true and false have small letters: {key} = {text.lower()}"
        if text.lower() in ("none", "null", "nil"):
            return f"a parameter that has no value is left out, got {key} = {text}"
        if not VALUE.fullmatch(text) and "=" not in text and LIKE_TEXT.search(text):
            return f'text and formulas stand in quotes: {key} = "{text}"'
    return ""

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A line that is no TOML is refused with its number and what would do in its place."""

import tomllib

import pytest

from sweep_addon.core.declared.forms import tables
from sweep_addon.core.declared.parameters import ShapeError

LINE = "a line is key = value, [table] or a comment after #"
VALUE = 'after = stands a number, "text", true, false, a [list] or a { table }'
ENDED = "a text ends with the quote that it begins with, on the same line"
BACKSLASH = "a backslash stands for itself between single quotes only"
ONCE = "each parameter and each table is told once"
SLIPS = {
    'kind "circle"': LINE,
    "kind: circle": LINE,
    "= 2": LINE,
    "a =": VALUE,
    'a = "b': ENDED,
    "a = 'b": ENDED,
    'a = "b"c': "a line ends after its value",
    'a = "\\d"': BACKSLASH,
    'a = "\\xq"': BACKSLASH,
    'a = "\\ud800"': BACKSLASH,
    "[contour": "the name of a table stands between brackets, as [contour]",
    "[[steps]": "the name of a list of tables stands between two brackets, as [[steps]]",
    "first = 3": ONCE,
    "first.b = 3": ONCE,
    "a = {b = 1, b = 2}": ONCE,
    "a = 0.4[": "a line ends after its value",
    "a = [1, 2": "a list ends with ], with commas between its values",
    "a = [1 2]": "a list ends with ], with commas between its values",
    "a = {b = 1 c = 2}": "a table in one line ends with }, with commas between its values",
}
ONE_LINE = "an inline table, in { }, stands on one line; of more lines it is a section, as [contour]"
BROKEN = [  # the line where it breaks, and the text
    ("a = { b = 1,", "a = { b = 1,\n  c = 2 }"),
    ("a = {  # sizes", "a = {  # sizes\n  b = 1\n}"),
    ("3], c = 4,", "a = { b = [2,\n3], c = 4,\n d = 5 }"),
]
MEANT = {
    "radius = .5": "a number is written so: radius = 0.5",
    "radius = 5.": "a number is written so: radius = 5",
    "radius = 007": "a number is written so: radius = 7",
    "closed = True": "true and false have small letters: closed = true",
    "radius = None": "a parameter that has no value is left out, got radius = None",
    "a = {b = FALSE}": "true and false have small letters: b = false",
}


def refusal(line):
    with pytest.raises(ShapeError) as caught:
        tables(f"first = 1\n\n{line}\n")
    assert "\n" not in str(caught.value)
    return str(caught.value)


@pytest.mark.parametrize("line", SLIPS)
def test_a_line_that_is_no_toml_is_told_what_would_do(line):
    sentence = refusal(line)
    number, sentence = sentence.split(": must be TOML: ")
    assert number in ("line 3", "line 4")  # a list that does not end is missed after its line
    assert sentence.startswith(f"{SLIPS[line]}, got ")
    if number == "line 3":
        assert sentence.endswith(f", got {line!r}")


@pytest.mark.parametrize(("line", "text"), BROKEN)
def test_an_inline_table_over_lines_is_told_that_it_stands_on_one(line, text):
    number = 3 + text.split("\n").index(line)
    assert refusal(text) == f"line {number}: must be TOML: {ONE_LINE}, got {line!r}"


@pytest.mark.parametrize("line", ["a = { 3$ = 1 }", "a = { b = 1, , c = 2 }", "a.", "[", "a = { ? = 1 }"])
def test_other_slips_are_not_told_so(line):
    assert ONE_LINE not in refusal(line)


@pytest.mark.parametrize("line", MEANT)
def test_what_other_languages_write_is_told_as_toml_has_it(line):
    assert refusal(line) == f"line 3: must be TOML: {MEANT[line]}"
    if ", got" not in MEANT[line]:
        tomllib.loads(MEANT[line].partition(": ")[2])


def test_lines_after_one_that_was_clearly_meant_are_told_of_too():
    text = "twist = 2*pi*t\nkind = 'plant'\nstart = open\nrows = [\n  1,\n]\nupright = True\n= 3\nend = open\n"
    with pytest.raises(ShapeError) as caught:
        tables(text)
    assert [refusal.key for refusal in caught.value.each()] == ["line 1", "line 3", "line 7", "line 8"]
    with pytest.raises(ShapeError) as caught:
        tables("twist = 2*pi*t\n" * 1000)
    assert len(caught.value.each()) == 20

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A key of a TOML text is found on the line that sets it."""

import tomllib

import pytest

from sweep_addon.batch import lines
from sweep_addon.batch.lines import line_of, lines_of

TEXT = '''version = 1  # kind = "no"
kind = "tube"
note = """
[contour]
radius = 9
"""
rows = [
    [1.5],
    ["[trap]", 2],  # ]
]
samples = {kind = "count", contours = 3}
frame.kind = "frenet"

[contour]  # the first
kind = 'circle'
radius = 2

[ contour . "inner" ]
radius = 3

["a b"]

[[parts]]
x = 1
'''


@pytest.mark.parametrize(
    "key, line",
    {
        "version": 1,
        "kind": 2,
        "note": 3,
        "rows": 7,
        "samples": 11,
        "samples.contours": 11,
        "frame.kind": 12,
        "frame.up": 12,  # no line sets the frame itself, this one something in it
        "'a b'": 21,
        "parts": 23,  # a list where a table was meant
        "contour": 14,
        "contour.kind": 15,
        "contour.radius": 16,
        "contour.missing": 14,
        "contour.inner.radius": 19,
        "missing": 1,
        "": 1,
    }.items(),
)
def test_the_line_that_sets_a_key(key, line):
    tomllib.loads(TEXT)
    assert line_of(TEXT, key) == line


def test_lines_of_several_keys_take_no_longer_than_that_of_one(monkeypatch):
    """A job of a million lines with twenty mistakes would take minutes."""
    gone_through, paths = [], lines.paths
    monkeypatch.setattr(lines, "paths", lambda text: gone_through.append(text) or paths(text))
    assert lines_of(TEXT, ["contour.radius", "kind", "missing", "samples"]) == [16, 2, 1, 11]
    assert gone_through == [TEXT]

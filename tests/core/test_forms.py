# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A shape survives being written as a job or as Python, and text that is no job is refused in one sentence."""

import pickle
import runpy
import tomllib
from dataclasses import FrozenInstanceError, replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import sweep_addon as sw
from sweep_addon.core import contours, trajectories
from sweep_addon.core.declared.forms import dump, load, plain, python_source, tables, toml
from sweep_addon.core.declared.parameters import ShapeError, inside, parameters
from sweep_addon.core.rings import corners, ends
from sweep_addon.core.shapes.kinds import SHAPES, GeneralizedCylinder
from sweep_addon.core.stations import frames
from sweep_addon.core.variation.laws import Constant

RING = np.stack([np.cos(np.arange(40) / 7), np.sin(np.arange(40) / 7)], axis=1)
RICH = GeneralizedCylinder(
    contour=contours.Outline(loops=[RING]),
    trajectory=trajectories.Polyline([(0, 0, 0), (0, 0, 1), (1, 2, 1 / 3)], corner=corners.Round(radius=0.2)),
    samples={"kind": "count", "contours": 12},
    frame=frames.FixedUp(up=(0, 0.6, 0.8)),
    scale_x="1 - t/2",
    scale_y=0.7,
    twist=[(0, 1), (1, 2)],
    start=ends.Round(height=0.7),
    end=ends.Taper(length=0.1),
)
EXAMPLES = [GeneralizedCylinder(), RICH, *(shape() for shape in SHAPES)]


@pytest.mark.parametrize("shape", EXAMPLES)
def test_a_job_makes_the_shape_again(shape):
    text = dump(shape)
    assert load(SHAPES, text) == load(SHAPES, text.encode()) == shape
    assert text.startswith("version = 1\nkind = ")
    assert max(map(len, text.splitlines())) <= 120


@pytest.mark.parametrize("shape", EXAMPLES)
def test_python_makes_the_shape_again(shape, tmp_path):
    line = python_source(shape)
    script = tmp_path / "script.py"
    script.write_text(f"shape = {line}\n", encoding="utf-8")
    assert runpy.run_path(str(script), {"sw": sw})["shape"] == shape
    assert max(map(len, line.splitlines())) <= 120


def test_python_leaves_defaults_out():
    shape = GeneralizedCylinder(contour=contours.Circle(radius=0.2), twist="2*pi*t", frame="frenet")
    expected = (
        'sw.GeneralizedCylinder(contour=sw.contours.Circle(radius=0.2), frame=sw.frames.Frenet(), twist="2*pi*t")'
    )
    assert python_source(shape).replace("\n    ", " ").replace("( ", "(").replace(",\n)", ")") == expected


def test_a_job_writes_every_parameter():
    table = tomllib.loads(dump(GeneralizedCylinder()))
    assert table["contour"] == {"kind": "circle"} | {k: v for k, v in plain(contours.Circle(0.1)).items()}
    assert {"version", "kind", "trajectory", "scale_x", "twist", "start", "end"} <= table.keys()


def test_shorthand_is_read():
    text = 'kind = "generalized-cylinder"\nframe = "frenet"\nscale_x = 2\nscale_y = "t"\ntwist = [[0, 1], [1, 0]]'
    assert load(SHAPES, text) == GeneralizedCylinder(frame="frenet", scale_x=2, scale_y="t", twist=[(0, 1), (1, 0)])


START = 'kind = "generalized-cylinder"\n'


@pytest.mark.parametrize(
    "text, sentence",
    {
        b"a = 1\nb = '\xe9'": "line 2: must be UTF-8, got the byte 0xe9",
        "a = 1\nb =": "line 2: must be TOML: after = stands a number, ",
        "a = 1\na = 2": "line 2: must be TOML: each parameter and each table is told once, got 'a = 2'",
        "a = 1\ntwist = 2*pi*t": 'line 2: must be TOML: text and formulas stand in quotes: twist = "2*pi*t"',
        "twist = smoothstep(0, 1, t) # late": (
            'line 1: must be TOML: text and formulas stand in quotes: twist = "smoothstep(0, 1, t)"'
        ),
        "frame = { kind = fixed-up, up = [0, 0, 1] }": (
            'line 1: must be TOML: text and formulas stand in quotes: kind = "fixed-up"'
        ),
        "\nx": "line 2: must be TOML: a line is key = value, [table] or a comment after #, got 'x'",
        "": "kind: must be given, as one of ",
        "version = 1.5": "version: must be a whole number, at least 1, got 1.5",
        "version = 2": "version: must be at most 1, the newest that this program reads, got 2",
        "version = true": "version: must be a whole number, at least 1, got True",
        "version = -1": "version: must be a whole number, at least 1, got -1",
        "version = 0": "version: must be a whole number, at least 1, got 0",
        "version = 'a'": "version: must be a whole number, at least 1, got 'a'",
        START + "radios = 1": "radios: is no parameter of GeneralizedCylinder, which has contour, trajectory, ",
        START + "contour = {kind = 'circle', radius = -1}": "contour.radius: must be more than 0, got -1",
        START
        + "contour = {kind = 'circle', radius = '1 mm'}": "contour.radius: must be a number of metres, got '1 mm'",
        START + "twist = {kind = 'constant', value = '1'}": "twist: must be a number of radians, got '1'",
        START + "twist = '90 deg'": "twist: must be a number of radians or an expression of u, t, s: an operator is "
        "missing at character 4 before 'deg', got '90 deg'",
        START + "offset_x = '10 mm'": "offset_x: must be a number of metres or an expression of u, t, s: an operator "
        "is missing at character 4 before 'mm', got '10 mm'",
        START + "scale_x = '1 - q'": "scale_x: must be an expression of u, t, s: 'q' at character 5 is no name",
        START + "scale_x = nan": "scale_x: must be a number, got nan",
        START
        + "[contour]\nkind = 'circle'\nradius = "
        + "9" * 400: "contour.radius: must have numbers of at most 64 bits, got 999",
        START + "[trajectory]\nkind = 'polyline'\npoints = [[0, 0, 0], [0, 0, true]]": "trajectory.points: must be a "
        "list of 3 numbers each, got [0, 0, True] in row 2",
        START + "scale_x = [[0, true], [1, 1]]": "scale_x: must be a number, a formula in text or a list of points",
        "x = 0x" + "F" * 5000: "x: must have numbers of at most 64 bits, got 0xfff",
        "x = " + "[" * 30_000: "must be TOML, nested at most 32 deep, with numbers of at most 64 bits",
        "x = " + "9" * 30_000: "must be TOML, nested at most 32 deep, with numbers of at most 64 bits",
        "x = " + "[" * 40 + "]" * 40: "x: must be nested at most 32 deep, got 33",
        "\na" + ".a" * 100_000 + " = 1": "line 2: must have at most 32 names in a key",
    }.items(),
    ids=lambda text: repr(text)[:30],
)
def test_what_is_no_job_is_refused(text, sentence):
    with pytest.raises(ShapeError) as refusal:
        load(SHAPES, text)
    assert str(refusal.value).startswith(sentence) and "\n" not in str(refusal.value)


@pytest.mark.parametrize("value", [3, None, "tube", GeneralizedCylinder, contours.Circle(), RICH.scale_x])
def test_only_a_shape_is_written_as_a_job(value):
    with pytest.raises(ShapeError, match="^shape: must be a shape, got "):
        sw.dump(value)


@pytest.mark.parametrize("comment", ["\ud800", "\ud800\U0001f600", "\U0001f600", "'''", "\\", "\u2028"])
def test_a_text_is_the_same_in_python(comment):
    stock = sw.MachinedStock(program=f"({comment})\nG21 F300\nG1 Z-2\nX5")
    assert eval(python_source(stock), {"sw": sw}) == stock


@pytest.mark.parametrize("number", [-(2**63), 2**63 - 1])
def test_numbers_of_64_bits_are_toml(number):
    assert tables(f"version = {number}".encode()) == {"version": number}


def test_a_byte_order_mark_is_no_mistake():
    assert tables(b"\xef\xbb\xbfversion = 1\r\n") == {"version": 1}


numbers = st.floats(allow_nan=False, allow_infinity=False) | st.integers(-(2**62), 2**62) | st.booleans()
texts = st.text(st.characters(exclude_categories=["Cs"]), max_size=12)
values = st.recursive(numbers | texts, lambda inner: st.lists(inner, max_size=8), max_leaves=12)
keys = st.from_regex(r"[a-z_][a-z0-9_-]{0,20}", fullmatch=True)


@given(
    st.recursive(
        st.dictionaries(keys, values, max_size=4), lambda t: st.dictionaries(keys, values | t, max_size=4), max_leaves=4
    )
)
def test_any_table_is_read_by_the_standard_library(table):
    assert tomllib.loads(toml(table)) == table


@given(st.text(max_size=60) | st.binary(max_size=60) | st.dictionaries(keys, values, max_size=3).map(toml))
def test_any_text_is_a_shape_or_refused(text):
    try:
        load(SHAPES, text)
    except ShapeError as refusal:
        assert "\n" not in str(refusal)


def test_a_value_never_changes():
    circle = sw.contours.Circle(2.0)
    for change in (lambda: setattr(circle, "radius", 1.0), lambda: setattr(circle, "colour", 1)):
        with pytest.raises(FrozenInstanceError):
            change()
    with pytest.raises(FrozenInstanceError):
        del circle.radius
    assert circle == replace(circle) == pickle.loads(pickle.dumps(circle)) and circle.radius == 2.0


def test_a_kind_begins_with_the_value_that_its_union_begins_with():
    """A law is 1 by itself, but an offset and a twist begin at 0."""
    declared = {p.name: p for p in parameters(GeneralizedCylinder)}
    for name, value in {"scale_x": 1.0, "twist": 0.0, "offset_x": 0.0, "offset_y": 0.0}.items():
        assert inside(declared[name], Constant)[0].default == value

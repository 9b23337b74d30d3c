# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Expressions agree with Python's own arithmetic, and any other text is refused at once, in one sentence."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.formulas.expressions import compile

T = np.linspace(-2, 2, 9)


def value(text, **names):
    return float(compile(text, names).evaluate(**names))


@pytest.mark.parametrize(
    "text, expected",
    {
        "-2^2": -4,
        "-2**2": -4,
        "2^3^2": 512,
        "2^-1*3": 1.5,
        "(2^3)^2": 64,
        "7 - 2 - 1": 4,
        "8 / 4 / 2": 1,
        "-7 % 3": 2,
        "mod(-7, 3)": 2,
        "1 + 2 * 3": 7,
        ".5 + 1. + 1e1 + 2.5E-1": 11.75,
        "1 < 2 == 1": None,
        "(1 < 2) == 1": 1,
        "1 || 0 && 0": 1,
        "(1 < 2) + (2 < 3) + !0": 3,
        "-(1 < 2) - (2 || 0)": -2,
        "(1 < 2) < (3 < 4) + (0 == 0)": 1,
        "(1 < 2) && 0.5 || !(2 > 1)": 1,
        "if(1 < 2, 3 > 2, 5) / 2": 0.5,
        "not 1 == 2": 1,
        "!1 == 0": 1,
        "1 and not 0 or 0": 1,
        "if(2 > 1, 10, 1/0)": 10,
        "atan2(1, -1) - 3*pi/4": 0,
        "tau - 2*pi": 0,
        "log(e^2)": 2,
        "log10(1000)": 3,
        "min(3, 1, 2) + max(3, 1, 2)": 4,
        "clamp(5, 0, 2)": 2,
        "lerp(10, 20, 0.25)": 12.5,
        "smoothstep(0, 2, 1)": 0.5,
        "round(2.6) + floor(-0.5) + ceil(0.5) + trunc(-1.5) + sign(-3)": 1,
        "cosh(1)^2 - sinh(1)^2": 1,
        "asin(1) + acos(0) - 2*atan(1/0.0000000000000001)": 0,
    }.items(),
)
def test_precedence_and_functions(text, expected):
    if expected is None:
        with pytest.raises(ShapeError, match="second comparison"):
            compile(text, ())
    else:
        assert value(text) == pytest.approx(expected, abs=1e-12)


def test_names_are_arrays_and_constants_fill_them():
    expression = compile("1 - t^2/4", ("u", "t"))
    assert expression.names == ("t",)
    assert np.array_equal(expression.evaluate(t=T), 1 - T**2 / 4)
    assert np.array_equal(compile("2*pi", ("t",)).evaluate(t=T), np.full(9, 2 * math.pi))
    assert compile("u + t", ("u", "t")).evaluate(u=T[:, None], t=T).shape == (9, 9)
    assert value("e + pi", e=1.0) == 1 + math.pi  # a given name hides a constant


def test_a_choice_hides_what_is_not_chosen():
    assert np.array_equal(compile("if(t != 0, 1/t, 0)", "t").evaluate(t=[0, 2]), [0, 0.5])


KNOWN = "(u, t, pi, tau, e are)"


@pytest.mark.parametrize(
    "text, what",
    {
        "1 - q": f"'q' at character 5 is no name {KNOWN}, got '1 - q'",
        "t.__class__": "'.' at character 2 has no meaning, got 't.__class__'",
        "__builtins__": f"'__builtins__' at character 1 is no name {KNOWN}, got '__builtins__'",
        "sin": f"'sin' at character 1 is no name {KNOWN}, got 'sin'",
        "": "a value is missing at character 1, got ''",
        "1 +": "a value is missing at character 4, got '1 +'",
        "1 t": "an operator is missing at character 3 before 't', got '1 t'",
        "(1": "a closing bracket or an operator is missing at character 3, got '(1'",
        "sin()": "a value is missing at character 5 before ')', got 'sin()'",
        "atan2(t)": "atan2 at character 1 takes 2 values, not 1, got 'atan2(t)'",
        "0 < t < 1": "a second comparison at character 7 needs && or brackets, got '0 < t < 1'",
        "2 * not t": "a value is missing at character 5 before 'not', got '2 * not t'",
        "t**1e999": "'1e999' at character 4 is too large, got 't**1e999'",
        "\N{GREEK SMALL LETTER PI}": "'π' at character 1 is no name (u, t, pi, tau, e are), got 'π'",
        "1 ÷ 2": "'÷' at character 3 has no meaning, got '1 ÷ 2'",
        "lambda: t": f"'lambda' at character 1 is no name {KNOWN}, got 'lambda: t'",
        "(" * 300: f"more than 100 levels at character 101, got '...{'(' * 32}...'",
        "-" * 300: f"more than 100 levels at character 101, got '...{'-' * 32}...'",
        "(" * 10_000: f"it is 10000 characters long, at most 2000 are allowed, got '{'(' * 35}...'",
    }.items(),
    ids=lambda text: repr(text)[:30],
)
def test_refusals_say_what_is_wrong_and_where(text, what):
    with pytest.raises(ShapeError) as refusal:
        compile(text, ("u", "t"))
    assert str(refusal.value) == f"must be an expression of u, t: {what}"


def test_an_unknown_function_is_told_the_known_ones():
    with pytest.raises(ShapeError, match=r"'open' at character 1 is no function \(sin, .* are\), got 'open\(1\)'"):
        compile("open(1)", ())


@pytest.mark.parametrize("text", ["9**9**9**9", "1/0", "log(-1)", "0/0"])
def test_constants_are_finite_when_read(text):
    with pytest.raises(ShapeError, match="must be finite everywhere, got (inf|nan)$"):
        compile(text, ("t",))


def test_the_place_of_a_value_that_is_not_finite_is_named():
    with pytest.raises(ShapeError) as refusal:
        compile("1/(t - 0.5)", ("t",)).evaluate(t=[0, 0.25, 0.5], s=[0, 1, 2])
    assert str(refusal.value) == "must be finite everywhere, got inf at t = 0.5, s = 2"


@pytest.mark.parametrize("text", [3, None, b"t"])
def test_only_text_is_read(text):
    with pytest.raises(ShapeError, match="must be text, got"):
        compile(text, ())


numbers = st.floats(-8, 8).map(lambda number: round(number, 3))
leaves = st.sampled_from("tu") | numbers
trees = st.recursive(
    leaves,
    lambda inner: (
        st.tuples(st.sampled_from(["+", "-", "*", "/", "%", "**", "<", ">="]), inner, inner)
        | st.tuples(st.sampled_from(["-", "sin", "floor", "abs"]), inner)
    ),
    max_leaves=12,
)
PYTHON = {"sin": math.sin, "floor": math.floor, "abs": abs, "-": lambda a, b=None: -a if b is None else a - b}
PYTHON |= {"+": lambda a, b: a + b, "*": lambda a, b: a * b, "/": lambda a, b: a / b, "%": lambda a, b: a % b}
PYTHON |= {"**": math.pow, "<": lambda a, b: float(a < b), ">=": lambda a, b: float(a >= b)}


def written(tree):
    """A tree as text, every operation in brackets."""
    if not isinstance(tree, tuple):
        return f"({tree})"
    if len(tree) == 2:
        return f"({tree[0]}({written(tree[1])}))"
    return f"({written(tree[1])} {tree[0]} {written(tree[2])})"


def computed(tree, names):
    if not isinstance(tree, tuple):
        return names.get(tree, tree)
    return PYTHON[tree[0]](*(computed(part, names) for part in tree[1:]))


@given(trees, st.floats(-3, 3), st.floats(-3, 3))
def test_arithmetic_agrees_with_python(tree, t, u):
    try:
        expected = computed(tree, {"t": t, "u": u})
    except (ArithmeticError, ValueError):  # Python refuses 1/0 and a root of -1 on the way, we only at the end
        return
    try:
        assert value(written(tree), t=t, u=u) == pytest.approx(expected, rel=1e-9, abs=1e-9)
    except ShapeError:
        assert not math.isfinite(expected)


words = st.sampled_from(
    "t u pi sin( if( min( , ) ( ** ^ - + ! not and && == < 2 .5 1e9 1e999 . [ q _ \x00 é".split(" ")
)


@settings(max_examples=300)
@given(st.text(max_size=80) | st.lists(words, max_size=60).map("".join) | st.lists(words, max_size=60).map(" ".join))
def test_any_text_is_finite_or_refused_in_one_sentence(text):
    try:
        values = compile(text, ("t", "u")).evaluate(t=T, u=1.0)
    except ShapeError as refusal:
        assert "\n" not in str(refusal) and len(str(refusal)) < 400
    else:
        assert values.shape == T.shape and np.isfinite(values).all()


def test_squares_are_rounded_alike_in_arrays_and_in_numbers():
    squared = compile("x^2", ("x",))
    sides = np.random.default_rng(1).uniform(-9, 9, 1000)
    alone = [float(squared.evaluate(x=side)) for side in sides]
    assert squared.evaluate(x=sides).tolist() == alone == [side * side for side in sides.tolist()]

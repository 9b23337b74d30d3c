# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Productions that are Python functions derive what the same productions in text derive."""

import pytest

from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.grammars import GrammarError, LSystem

AXIOM = "#names leaf\naxiom: A(3, 1) B A(1, 2)"


@pytest.mark.parametrize(
    ("head", "successor", "function"),
    [
        ("A(x, y)", "F(y)[+A(x-1, x*y)]", lambda x, y: [("F", y), "[", "+", ("A", x - 1, x * y), "]"]),
        ("A(x, y) : x > 1", "leaf(2)A(y, x)", lambda x, y: [("leaf", 2), ("A", y, x)]),
        ("A(x, y) < B", "B A(y, x)", lambda x, y: ["B", ("A", y, x)]),
        ("A(x, y) > B", "*", lambda x, y: []),
    ],
)
def test_a_function_derives_what_its_text_derives(head, successor, function):
    told = LSystem.parse(f"{AXIOM}\n{head} -> {successor}")
    called = LSystem.parse(AXIOM).with_production(head, function)
    for generation in range(4):
        assert str(called.derive(generation)) == str(told.derive(generation))


def test_a_function_has_no_text():
    with pytest.raises(ShapeError, match="has no text where a successor is a Python function, got"):
        str(LSystem.parse(AXIOM).with_production("B", lambda: [("F", 1.0)]))


@pytest.mark.parametrize(
    ("head", "function", "sentence"),
    [
        ("B", 3, "function: must be a function, got 3"),
        ("B", lambda: "F", "must return a list of modules, got 'F'"),
        ("B", lambda: ["FF"], "must return names of single modules, got 'FF'"),
        ("B", lambda: [("F", *range(33))], "must return at most 32 parameters, got 33"),
    ],
)
def test_what_is_no_production_is_refused(head, function, sentence):
    with pytest.raises(ShapeError, match=sentence):
        LSystem.parse(AXIOM).with_production(head, function)


@pytest.mark.parametrize(("head", "function"), [("B <", lambda: ["F"]), ("B", lambda: ["[", "F"])])
def test_a_wrong_head_or_an_open_branch_is_told_as_in_a_text(head, function):
    with pytest.raises(GrammarError, match="line 1, column"):
        LSystem.parse(AXIOM).with_production(head, function)


@pytest.mark.parametrize(("head", "takes"), [("A(x)", "the parameters x of the head"), ("A", "no parameters")])
def test_a_function_that_takes_other_parameters_than_the_head_is_refused(head, takes):
    system = LSystem.parse("axiom: A(1)")
    function = (lambda: ["F"]) if "x" in head else (lambda x: ["F"])
    with pytest.raises(ShapeError, match=f"function: must take {takes}.*, got one that takes "):
        system.with_production(head, function)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Statements: variables of a derivation, and when they get their values."""

import pytest

from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.grammars import GrammarError, LSystem

RACEME = """
start: n = 1
start each: p = (2*n + 1)/n^2; q = 1 - p
end each: n = n + 1
axiom: A(n)
A(x) : x < 4 -> F(p) [+L(q)] A(n + 1)
"""


def test_variables_change_before_and_after_each_step():
    """By hand: n is 1, 2, 3 in the steps, p is 3, 5/4, 7/9; what a step writes has the values of that step."""
    system = LSystem.parse(RACEME)
    assert str(system.derive(0)) == "A(1)"
    assert str(system.derive(3)) == "F(3)[+L(-2)]F(1.25)[+L(-0.25)]F(0.777778)[+L(0.222222)]A(4)"
    assert str(system.derive(5)) == str(system.derive(3))


def test_variables_are_written_and_read_again():
    system = LSystem.parse(RACEME)
    lines = str(system).splitlines()
    assert lines[2:5] == ["start: n = 1", "start each: p = (2*n + 1)/n^2; q = 1 - p", "end each: n = n + 1"]
    assert str(LSystem.parse(str(system))) == str(system)


def test_conditions_and_contexts_hang_on_variables():
    """A frost in the third step, which a whole plant feels."""
    told = "end each: day = day + 1\naxiom: A\nA : day != 2 -> FA\nA : day == 2 -> D\nF < F : day == 2 -> f"
    assert [str(LSystem.parse(told).derive(n)) for n in range(5)] == ["A", "FA", "FFA", "FfD", "FfD"]


def test_the_turtle_is_told_by_the_values_at_the_end():
    """cpfg interprets a word after EndEach, and after End behind the last step."""
    told = "start: w = 1\nend each: w = w*2\nend: w = w + 100\naxiom: A\nA -> AA\nhomomorphism:\nA -> F(w)"
    system = LSystem.parse(told)
    assert str(system.derive(0).interpreted()) == "F(1)"
    assert str(system.derive(1).interpreted()) == "F(102)F(102)"
    assert str(system.derive(2).interpreted()) == "F(104)F(104)F(104)F(104)"


def test_variables_begin_at_0_and_may_be_given_values_in_braces():
    assert str(LSystem.parse("start each: {n = n + 2; m = n*n;}\naxiom: A(n)\nA(x) -> B(n,m)").derive(1)) == "B(2,4)"
    assert str(LSystem.parse("start each: n = n + 2\naxiom: A(n)").derive(0)) == "A(0)"


def test_parameters_and_groups_see_variables_too():
    told = "start each: n = n + 1\naxiom: A(5)\nA(n) -> A(n)B(n)\ngroup 2:\nA(x) -> C(x*n)"
    assert str(LSystem.parse(told).derive(2)) == "C(10)B(5)"  # a parameter hides a variable of its name


def test_random_numbers_of_statements_hang_on_the_seed_and_the_step():
    system = LSystem.parse("start each: r = ran(1)\naxiom: A\nA -> B(r)A")
    words = [str(system.derive(3, seed=seed)) for seed in (1, 1, 2)]
    assert words[0] == words[1] != words[2] and len(set(words[0].split("B"))) == 4


def test_sizes_follow_variables():
    assert LSystem.parse("start: n = 3\nend each: n = n - 1\naxiom: A\nA : n > 1 -> AA").sizes(4) == [1, 2, 4, 4, 4]


@pytest.mark.parametrize(
    ("told", "line", "expected"),
    [
        ("start: n\naxiom: A", 1, "a variable and its value"),
        ("start: n == 3\naxiom: A", 1, "a variable and its value"),
        ("start: n = \naxiom: A", 1, "a value"),
        ("start: n = m\naxiom: A", 1, "one of the names n"),
        ("#define n 3\nstart: n = 2\naxiom: A", 2, "a variable, for a constant"),
        ("start: n = 2\naxiom: A\nA -(n/4)-> B", 3, "one of the names pi"),
        ("start: open('x')\naxiom: A", 1, "a variable and its value"),
    ],
)
def test_what_is_wrong_with_statements_is_told_with_its_place(told, line, expected):
    with pytest.raises(GrammarError) as refusal:
        LSystem.parse(told)
    problem = refusal.value.problems[0]
    assert problem.line == line and problem.expected.startswith(expected)


def test_values_must_be_finite():
    with pytest.raises(ShapeError, match="line 2: n must be a finite number, got inf in generation 1"):
        LSystem.parse("axiom: A\nstart each: n = 1/m; m = 3").derive(2)


def test_end_is_a_name_as_well():
    assert str(LSystem.parse("#names end\naxiom: end(1)\nend : 1 < 2 -> F\nend(x) -> end").derive(2)) == "F"


CPFG = """#dialect cpfg
Lsystem: 1
Start: {n=1;}
StartEach: {p=(2*n+1)/(n*n);
 q=1-p;}
EndEach: {n=n+1;}
derivation length: 3
axiom: A(0.5)
A(t) : {t=t+0.5;} t<2 {u=t*t; v=u+n;} --> I(t)[+L(u,v)]A(t)
endlsystem
"""


def test_statements_of_cpfg_are_read():
    """In a production they name what follows: by hand t is 1, 1.5 and then 2."""
    system = LSystem.parse(CPFG)
    assert str(system.derive()) == "I(1)[+L(1,2)]I(1.5)[+L(2.25,4.25)]A(1.5)"
    assert [str(each) for each in system.start_each] == ["p = (2*n+1)/(n*n)", "q = 1-p"]
    assert str(LSystem.parse(str(system)).derive(3)) == str(system.derive())


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("A : {n = 2;} n > 1 --> B", "statements of a production's own names"),
        ("A : {x = ran(1);} x > 1 --> B", "statements as x = 2*y, without chance"),
        ("A : {if (1) {x = 1;}} x > 1 --> B", "statements without braces in them"),
        ("A : {while = 1;} 1 --> B", "statements as x = 2*y"),
        ("A : {x = 1; x > 1 --> B", "'}' behind statements"),
        ("A : x > 1} --> B", "'{' before statements"),
        ("A : {" + "x = x + x*x;" * 40 + "} 1 --> B(x)", "at most 100000 characters"),
    ],
)
def test_statements_of_cpfg_that_are_more_than_names_are_told(line, expected):
    with pytest.raises(GrammarError) as refusal:
        LSystem.parse(f"#dialect cpfg\nstart: {{n=1;}}\naxiom: A\n{line}")
    assert refusal.value.problems[0].line == 4 and refusal.value.problems[0].expected.startswith(expected)

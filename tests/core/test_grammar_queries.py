# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Queries: what a turtle and an environment fill in after each step, and productions that hang on it."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sequential_turtle import walk

from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.grammars import LSystem
from sweep_addon.core.grammars.deriving.describing import described
from sweep_addon.core.shapes.plant import Edges, Plant

START = {"x": ((1, 0, 0), (0, 1, 0), (0, 0, 1)), "z": ((0, 0, 1), (-1, 0, 0), (0, -1, 0))}
SQUARE = """
#heading y
#define L 9
#angle 90
#ignore + /
axiom: FA?P(x,y)
A > ?P(x,y) : abs(x) <= L/2 && abs(y - 4) <= L/2 -> oF/(180)A
A > ?P(x,y) : abs(x) > L/2 || abs(y - 4) > L/2 -> T%
F > T -> S
F > S -> SF
S -> *
T -> *
o > S -> [+FA?P(x,y)]
"""


def test_queries_are_filled_in_as_published():
    """Synthetic Topiary, section 3: positions follow what grows below them."""
    system = LSystem.parse("#heading y\n#angle 90\naxiom: A\nA -> F(1)?P(x,y)-A\nF(k) -> F(k+1)")
    assert [str(system.derive(n)) for n in range(4)] == [
        "A",
        "F(1)?P(0,1)-A",
        "F(2)?P(0,2)-F(1)?P(1,2)-A",
        "F(3)?P(0,3)-F(2)?P(2,3)-F(1)?P(2,2)-A",
    ]


def test_a_plant_that_is_cut_at_a_square_wakes_the_bud_below_and_stays_within():
    """After Synthetic Topiary: an apex outside leaves a signal, which takes a segment away and makes a bud grow."""
    system = LSystem.parse(SQUARE)
    words = [str(system.derive(n)).replace("oF/(180)", "i") for n in (8, 9, 10, 11)]
    assert [word.partition("?")[0] for word in words] == [
        "FiiiiiiiiA",
        "FiiiiiiiiT%",
        "FiiiiiiioS/(180)",
        "Fiiiiiii[+FA",
    ]
    for generation in (8, 17, 40):
        figure = system.derive(generation).figure()
        assert (np.abs(figure.start[:, 0]) < 4.5).all() and (np.abs(figure.start[:, 1] - 4) < 4.5).all()
    assert figure.bounds[:, :2] == pytest.approx(np.array([[0, 0], [4, 8]]), abs=1e-9)
    stem = LSystem.parse(SQUARE.replace("#define L 9", "#define L 1000")).derive(40).figure()
    assert stem.bounds[1, 1] == pytest.approx(41) and len(stem) == 41  # where nothing cuts, nothing branches


def nested(parts):
    """Words, each in a branch of the one before."""
    return "[".join(parts) + "]" * (len(parts) - 1) if parts else ""


def words():
    turn = st.builds("{}({})".format, st.sampled_from("+-&^\\/"), st.integers(-180, 180))
    move = st.builds("{}({})".format, st.sampled_from("Ff"), st.sampled_from([0.5, 1, 2]))
    query = st.sampled_from(["?P(a,b,c)", "?H(a,b,c)", "?L(*,*,*)", "?U(0,0,0)"])
    flat = st.lists(st.one_of(turn, move, query, st.sampled_from(["F", "$", "|"])), max_size=8)
    return st.recursive(flat.map("".join), lambda inner: st.lists(inner, max_size=3).map(nested), max_leaves=12)


@given(words(), st.sampled_from("xz"))
def test_queries_answer_as_a_turtle_that_goes_step_by_step(told, heading):
    word = LSystem.parse(f"#heading {heading}\n#tropism 0 0 -1 0.1\naxiom: F{told}?P(0,0,0)").derive(0)
    modules = [
        (name, tuple(column[place] for column in word.columns[:count]))
        for place, (name, count) in enumerate(word.tables.symbols[number] for number in word.symbols)
    ]
    asked = []
    axes = {name: np.array(axis, dtype=float) for name, axis in zip("HLU", START[heading], strict=True)}
    walk(modules, axes, tropism=(0, 0, -1, 0.1), asked=asked)
    for place, at, axes in asked:
        wanted = axes.get(modules[place][0][1], at)
        assert modules[place][1] == pytest.approx(wanted, abs=1e-7)


def test_queries_stand_where_what_their_word_means_takes_them():
    """cpfg interprets the word for its queries, homomorphism and all; queries of the homomorphism ask nothing."""
    system = LSystem.parse("axiom: A?P(x)\nA -> IA\nhomomorphism:\nI -> F(3)[?P(1)F(5)]")
    assert [str(system.derive(n)) for n in range(3)] == ["A?P(0)", "IA?P(3)", "IIA?P(6)"]


def test_queries_without_parameters_and_of_more_than_three_are_left_alone():
    assert str(LSystem.parse("axiom: F?P?H(1,1,1,7)").derive(0)) == "F?P?H(1,0,0,7)"


def test_an_environment_answers_after_each_step():
    """Growth goes on where a field of light says so, here left of x = 2."""
    system = LSystem.parse("axiom: A?E(1)\nA > ?E(l) : l > 0 -> FA\nA > ?E(l) : l <= 0 -> K")
    seen = []

    def light(asked):
        seen.append((asked.generation, asked.at.tolist(), asked.heading.tolist(), asked.values.tolist()))
        return 2 - asked.at[:, 0]

    assert str(system.derive(4, environment=light)) == "FFK?E(0)"
    assert seen[1] == (1, [[1.0, 0.0, 0.0]], [[1.0, 0.0, 0.0]], [[2.0]])
    assert str(system.derive(4)) == "FFFFA?E(1)"  # without one it says nothing


def test_an_environment_may_answer_several_numbers_to_modules_of_several_parameters():
    system = LSystem.parse("axiom: ?E(5)F?E(6,7)[+F?E(8,9,10)]")
    word = system.derive(0, environment=lambda asked: np.stack([asked.at[:, 0], asked.at[:, 1]], axis=1))
    assert str(word) == "?E(0)F?E(1,0)[+F?E(1,1,10)]"
    assert str(system.derive(0, environment=lambda asked: 3)) == "?E(3)F?E(3,7)[+F?E(3,9,10)]"


@pytest.mark.parametrize(
    ("environment", "sentence"),
    [
        (3, "must be a function"),
        (lambda asked: np.nan, "must return finite numbers"),
        (lambda asked: np.zeros((3, 1)), r"must return 2 rows of numbers, got an array of shape \(3, 1\)"),
        (lambda asked: np.zeros((2, 1, 1)), r"must return 2 rows of numbers, got an array of shape \(2, 1, 1\)"),
        (lambda asked: [1], r"must return 2 rows of numbers, got an array of shape \(1,\)"),
        (lambda asked: [[1], [1, 2]], r"must return 2 rows of numbers, got \[\[1\], \[1, 2\]\]"),
        (lambda asked: ["a", "b"], r"must return 2 rows of numbers, got \['a', 'b'\]"),
        (lambda asked: [1, 10**400], "must return 2 rows of numbers, got"),
        (lambda asked: {}, "must return 2 rows of numbers, got {}"),
    ],
)
def test_wrong_environments_are_refused(environment, sentence):
    with pytest.raises(ShapeError, match=f"^environment: {sentence}"):
        LSystem.parse("axiom: F?E(x)F?E(y)").derive(0, environment=environment)


def test_what_an_environment_itself_raises_is_not_changed():
    with pytest.raises(ZeroDivisionError):
        LSystem.parse("axiom: F?E(x)").derive(0, environment=lambda asked: 1 // 0)


def test_descriptions_tell_of_queries():
    told = described(LSystem.parse("start: n = 1\n#heading y\naxiom: A?P(x)?U(z)?E(y)"))
    assert told[0] == "class: open environmentally sensitive parametric D0L-system" and "step by step" in told[2]
    assert told[4:] == [
        "variables: n",
        "asks: ?P, ?U, which a turtle answers after each step",
        "asks: ?E, which an environment answers; that is a function of Python, and no file has one",
        "heading: y",
    ]
    assert "asks" not in "\n".join(described(LSystem.parse("axiom: A?P")))


def test_queries_of_cpfg_have_its_coordinates():
    """Its turtle starts along y; the ellipse of its authors' example of queries."""
    told = "#dialect cpfg\n#define in(x,y) ((x*x)/25+(y-10)*(y-10)/100 <= 1)\nconsider: ?P\naxiom: A?P(1,1)\n"
    told += "derivation length: 40\nA > ?P(x,y) : in(x,y) --> I[+(60)B][-(60)B]A?P(0,0)\n"
    told += "B > ?P(x,y) : in(x,y) --> I B?P(0,0)\nhomomorphism\nI --> F(1)"
    figure = LSystem.parse(told).derive().figure()
    x, y = figure.start[:, 0], figure.start[:, 1]
    assert y.max() > 15 and (x**2 / 25 + (y - 10) ** 2 / 100 <= 1 + 1e-9).all()


@pytest.mark.parametrize("angle", [30, 75])
def test_a_plant_asks_with_its_own_numbers(angle):
    """A curve that ends beyond x = 0.6: how long it is hangs on the step, the angle and where it starts."""
    told = "#angle 60\n#step 3\n#heading x\naxiom: A ?P(x,y)\nA > ?P(x,y) : x < 0.6 -> F+A\nA > ?P(x,y) : x >= 0.6 -> *"
    mesh = Plant(told, generations=30, angle=angle, step=0.5, output=Edges()).mesh()
    own = told.replace("#angle 60", f"#angle {angle}").replace("#step 3", "#step 0.5")
    figure = LSystem.parse(own).derive(30).figure()
    assert len(mesh.edges) == len(figure) and mesh.vertices.max(axis=0) == pytest.approx(figure.bounds[1], abs=1e-12)
    turned = Plant(told, generations=30, angle=angle, step=0.5, upright=True, output=Edges()).mesh()
    upwards = LSystem.parse(own.replace("#heading x", "#heading z")).derive(30).figure()
    assert len(turned.edges) == len(upwards) == 30 > len(figure)

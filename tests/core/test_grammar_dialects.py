# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts of other programs read as those of the book; what they have that is not known here is told with its line."""

import time
from contextlib import suppress
from dataclasses import replace

import numpy as np
import pytest

from sweep_addon.core.grammars import GrammarError, LSystem

FASS = """#dialect fractint
Fass1 { ; ABOP figure 1.16 a
  axiom -l
  Angle 4
  L=LF+RFR+FL-F-LFLFL-FRFR+   ; by Mariano
  R=-LFLF+RFRFR+F+RF-LFL-FR
}
"""
LEAF = """#dialect cpfg
/* a compound leaf: the authors' tutorial
   06-compound-param */
#define STEPS 4
#define R 2
lsystem: 1
derivation length: STEPS
angle increment: 45
axiom: A
A --> I(1)[+A][-A]I(1)A   // a comment
I(x) : * --> I(R*x)
homomorphism
I(x) --> F(x)
endlsystem
"""


def test_a_text_of_fractint_is_that_of_the_book():
    book = LSystem.parse("#angle 90\naxiom: -L\nL -> LF+RFR+FL-F-LFLFL-FRFR+\nR -> -LFLF+RFRFR+F+RF-LFL-FR")
    found = LSystem.parse(FASS)
    assert str(found) == str(book)
    assert len(found.derive(3)) == 2004  # ABOP figure 1.16 a


def test_moves_and_turns_of_fractint_have_their_meaning():
    told = "#dialect fractint\nCantor {\naxiom F\nangle 6\nF=FGF\nG=GGG\nX=\n}"
    assert str(LSystem.parse(told).derive(2)) == "FfFfffFfF"
    turned = LSystem.parse("#dialect fractint\nT {\naxiom D\\45D/30.5M\nangle 8\n}")
    assert str(turned.derive(0)) == "F+(45)F-(30.5)f"


def test_a_text_of_cpfg_is_that_of_the_book():
    found = LSystem.parse(LEAF)
    assert (found.generations, found.angle) == (4, 45)
    word = found.derive()
    assert len(word) == 401 and word.count("I") == 80 and word.columns[0].sum() == 130  # as in abop.json
    assert word.interpreted().count("F") == 80


@pytest.mark.parametrize(
    ("line", "book"),
    [
        ("A < B > C --> D : 0.4", "A < B > C -(0.4)-> D"),
        ("* < B(x) > * : x > 1 --> B(x-1)", "B(x) : x > 1 -> B(x-1)"),
        ("S > G[H=]M --> T", "S > G[H]M -> T"),
        ("ignore: +-F", "#ignore +-F"),
        ("X --> *", "X -> *"),
    ],
)
def test_lines_of_cpfg(line, book):
    told, wanted = (f"axiom: SABC\n{each}" for each in (line, book))
    assert str(LSystem.parse(f"#dialect cpfg\n{told}")) == str(LSystem.parse(wanted))


@pytest.mark.parametrize(
    ("told", "line", "expected"),
    [
        ("#dialect fractint\nA {\naxiom F\nangle 4\nF=F@.5F\n}", 5, "a symbol that has a meaning here"),
        ("#dialect fractint\nA {\naxiom F!\nangle 4\n}", 3, "a symbol that has a meaning here"),
        ("#dialect fractint\nA {\naxiom F+D\nangle 4\n}", 3, "turns of one kind"),
        ("#dialect fractint\nA {\nangle 5\naxiom F|F\n}", 4, "an even angle for |"),
        ("#dialect fractint\nA {\naxiom F\n}\nB {\n}", 5, "one curve in the text"),
        ("#dialect fractint\nA {\naxiom F\nwhat\n}", 4, "an angle, an axiom or a rule"),
        ("#dialect cpfg\naxiom: A\n#include <x>", 3, "the lines of that file in its place"),
        ("#dialect cpfg\naxiom: A\n#if x", 3, "#define"),
        ("#dialect cpfg\naxiom: A\n#define f(x,y) x\nA --> F(f(1))", 4, "2 parameters of f"),
        ("#dialect cpfg\naxiom: A\n#define f(2) x", 3, "names for the parameters of a macro"),
        ("#dialect cpfg\naxiom: A\nA[B] < C --> A", 3, "a left context without brackets"),
        ("#dialect cpfg\naxiom: A\nA(x) --> F(trunc(x))", 3, "no functions that mean something else"),
        ("#dialect cpfg\naxiom: A\nA(x) : atan2(x,1) > 3 --> F", 3, "no functions that mean something else"),
        ("#dialect cpfg\naxiom: A\nA --> !F", 3, "one number in brackets behind !"),
        ("#dialect cpfg\naxiom: A\nA --> F@M(1,2,3)", 3, "a symbol that has a meaning here"),
        ("#dialect cpfg\naxiom: A\nhomomorphism\nseed: 3", 4, "one seed"),
        ("#dialect cpfg\naxiom: A\n#define a b\n#define b a\nA --> F(a)", 5, "constants that do not need each other"),
        ("#dialect cpfg\naxiom: A\n#define a b b\n#define b a a\nA --> F(a)", 5, "at most 100000 characters"),
        ("#dialect cpfg\naxiom: A\nwhat is this", 3, "a keyword, or a production"),
    ],
)
def test_what_a_dialect_has_that_is_not_known_is_told_with_its_line(told, line, expected):
    with pytest.raises(GrammarError) as refusal:
        LSystem.parse(told)
    problem = refusal.value.problems[0]
    assert problem.line == line and problem.expected.startswith(expected)


MACROS = """#dialect cpfg
#define R 10
#define l 0.5  /* of a segment */
#define in(x,y) (4*x*x+(y-R)*(y-R) <= R*R)
#define LEAF [;(3) @o(0.2) \\
\t+(60) F(l)]
derivation length: 2
initial line width: 0.25
viewpoint: 0,0,300
axiom: A(0,3)
A(x,y) : in(x,y)
\t--> F(l) LEAF A(x+sin(30), y)
"""


def test_macros_of_cpfg_are_pasted_with_their_parameters_and_lines_go_on():
    """As the preprocessor of C does; its lines go on behind a backslash, those of cpfg with a tab."""
    found = LSystem.parse(MACROS)
    assert (found.generations, found.width) == (2, 0.25)
    assert str(found.derive(0)) == "A(0,3)"
    leaf = "['(3)~circle(0.2)+(60)F(0.5)]"
    assert str(found.derive(1)) == f"F(0.5){leaf}A(0.5,3)"  # the sine of 30 degrees
    assert str(found.derive(20)).count("F") == 2 * 8  # while 4 x^2 + 49 <= 100


def test_functions_that_mean_the_same_are_read():
    """fabs of C, and what L-Py has of Python's module math; 16 and 81 have whole roots."""
    cpfg = "#dialect cpfg\naxiom: A(-16)\nA(x) --> F(fabs(x), sqrt(fabs (x)), asin(1))"
    assert str(LSystem.parse(cpfg).derive(1)) == "F(16,4,90)"
    lpy = "#dialect lpy\nfrom math import *\nr = sqrt(81)\nAxiom: A(r)\nA(x) --> B(floor(x/2), log(e))"
    assert str(LSystem.parse(lpy).derive(1)) == "B(4,1)"


def test_recursion_of_cpfg_goes_one_level_deep_unless_it_says_how_deep():
    """In lsys_input.y of cpfg a homomorphism and a decomposition begin with depth 1."""
    told = "#dialect cpfg\naxiom: A\ndecomposition\n{}A --> BA\nhomomorphism\nB --> FB\n"
    assert str(LSystem.parse(told.format("")).derive(0)) == "BA"
    assert str(LSystem.parse(told.format("maximum depth: 3\n")).derive(0)) == "BBBA"
    assert str(LSystem.parse(told.format("")).derive(0).interpreted()) == "FBA"


HOUDINI = """#dialect houdini
# a bush
angle: 30
step size: 0.5
thickness scale: 0.5
generations: 2
variable b: 0.25
context ignore: +F
premise: FA(1)
rule 1: A(i):i<2="(0.5)!F[+B][-(120)&B]A(i+1):0.75
B<A(i)>C : i==2 = H_(0.5)F
B = f(b)J(0.2)*$
"""


def test_a_text_of_houdini_is_told_in_the_symbols_of_the_book():
    """Its + turns right, & pitches up and \\ rolls clockwise; a chance stands behind the successor."""
    found = LSystem.parse(HOUDINI)
    assert (found.angle, found.step, found.generations, found.ignore) == (30, 0.5, 2, ("-", "F"))
    assert [str(rule) for rule in found.productions] == [
        "A(i) : i<2 -(0.75)-> @Sl(0.5)@Sw(0.5)F[-B][+(120)^B]A(i+1)",
        "B < A(i) > C : i==2 -> @Sl(0.5)F@Sl(2)@Sl(1/(0.5))F",
        "B -> f(b)~J(0.2)/(180)$",
    ]


def test_a_premise_and_rules_of_houdini_may_be_told_in_several_ways():
    told = [
        "premise: FA\nrule 1: A=FA",
        "Premise = FA\nRULE12:A=FA",
        "premise:FA\n\nA = FA",
        "premise:FA\nrule: A:1<2=FA",
    ]
    words = [str(LSystem.parse(f"#dialect houdini\n{each}").derive(3)) for each in told]
    assert words == ["FFFFA"] * 4


def test_lengths_angles_and_widths_of_houdini_are_scaled_on_the_way():
    """The current length, angle and thickness are what F, + and tubes have that say nothing (help of the node)."""
    premise = 'F["(0.5);(2)!(0.1)F&F][_(0.5)F(3)F]^F'
    told = f"#dialect houdini\nangle: 30\nstep size: 2\nthickness: 0.4\npremise: {premise}"
    figure = LSystem.parse(told).derive(0).figure(upright=False)
    lengths = np.linalg.norm(figure.end - figure.start, axis=1)
    assert lengths == pytest.approx([2, 1, 1, 3, 4, 2], rel=1e-15)
    assert figure.width == pytest.approx([0.4, 0.04, 0.04, 0.4, 0.4, 0.4], rel=1e-15)
    rise = np.degrees(np.arcsin((figure.end - figure.start)[:, 2] / lengths))
    assert rise == pytest.approx([0, 0, 60, 0, 0, -30], abs=1e-12)


LPY = """#dialect lpy
c = 1   # the whole
p = 0.3
h = (p*(c - p)) ** 0.5
module Int(x), Fl
Axiom: _(0.002) -(90) F(1) Left(3) Int(2) Fl G(2) B[-A]A
derivation length: 2
ignore: +, -
production:
F(x) --> F(x*p) +(86) F(x*h)
B < A --> B
homomorphism:
Int(x) --> F(x);(3)
endlsystem
###### INITIALISATION ######
__copyright__ = "somebody's"
"""


def test_a_text_of_lpy_is_that_of_the_book():
    """Its widths are radii, and what only it draws with or without is renamed."""
    found = LSystem.parse(LPY)
    assert (found.generations, found.angle, found.width) == (2, 60, 0.2)
    assert found.constants[2].value == pytest.approx((0.3 * 0.7) ** 0.5, rel=1e-15)
    assert str(found.derive(0)) == "!(0.004)-(90)F(1)+(3)Int(2)Fl_G_(2)B[-A]A"
    assert str(found.derive(1)).endswith("B[-B]B") and found.derive(1).count("F") == 2
    assert str(found.derive(0).interpreted()).endswith("F(2)'(3)Fl_G_(2)B[-A]A")


def test_rolls_of_lpy_are_those_of_the_book():
    """PlantGL turns / by its angle about the heading, as the book does, though it calls it left."""
    told = "Axiom: F /(90) &(90) F"
    figures = [LSystem.parse(f"{head}{told}").derive(0).figure(upright=True) for head in ("#dialect lpy\n", "")]
    assert (figures[0].end == figures[1].end).all()


@pytest.mark.parametrize("told", [FASS, LEAF, MACROS, HOUDINI, LPY])
def test_other_programs_texts_are_exported_to_the_book_and_read_again(told):
    system = LSystem.parse(told)
    again = LSystem.parse(str(system))
    assert str(again) == str(system) and str(again.derive(2)) == str(system.derive(2))
    assert again.productions == tuple(
        replace(rule, line=again.productions[k].line) for k, rule in enumerate(system.productions)
    )


@pytest.mark.parametrize(
    ("told", "line", "expected"),
    [
        ("#dialect houdini\npremise: FT", 2, "no T, for by how much it bends"),
        ('#dialect houdini\npremise: F"F', 2, "a number in brackets, or a line 'step size scale"),
        ("#dialect houdini\npremise: F(1,0.2)", 2, "at most one parameter of F"),
        ("#dialect houdini\npremise: F$(1,2,3)", 2, "at most one parameter of $"),
        ("#dialect houdini\npremise: F'(0.1)", 2, "no ', for texture coordinates"),
        ("#dialect houdini\npremise: F\nF", 3, "a premise, a rule as A=FA, or a setting"),
        ("#dialect houdini\npremise: F\nA=F(t)", 3, "one of the names pi, tau, e"),
        ("#dialect houdini\npremise: F\nA=F(rand(1))", 3, "one of the functions"),
        ("#dialect houdini\npremise: F\n!=FA", 3, "a symbol that rules may replace"),
        ("#dialect houdini\npremise: F\nview: 3", 3, "a premise, a rule as A=FA, or one of"),
        ("#dialect houdini\npremise: F\nangle: x", 3, "a number"),
        ("#dialect lpy\nfrom random import *\nAxiom: F", 2, "a declaration, a value, or a rule with '-->'"),
        ("#dialect lpy\nAxiom: F\nF(x) :\n  produce F(x/2)", 3, "a declaration, a value, or a rule with '-->'"),
        ("#dialect lpy\nAxiom: F@O(2)", 2, "a symbol that has a meaning here"),
        ("#dialect lpy\nAxiom: F Sphere(2)", 2, "a symbol that has a meaning here"),
        ("#dialect lpy\nAxiom: F_", 2, "a radius in brackets"),
        ("#dialect lpy\nAxiom: F\nF >> A --> B", 3, "contexts with < and >"),
        ("#dialect lpy\nAxiom: F\nF > A=] --> B", 3, "modules by their names"),
        ("#dialect lpy\nAxiom: F\nF --> F(sin(1))", 3, "no angles in formulas"),
        ("#dialect lpy\nAxiom: F\ngroup 1:", 3, "group 0"),
        ("#dialect lpy\nAxiom: F\nF(x) --> A(y)", 3, "one of the names x"),
    ],
)
def test_what_houdini_and_lpy_have_that_is_not_known_is_told_with_its_line(told, line, expected):
    with pytest.raises(GrammarError) as refusal:
        LSystem.parse(told)
    problem = refusal.value.problems[0]
    assert problem.line == line and problem.expected.startswith(expected)
    assert problem.source == told.splitlines()[line - 1]


@pytest.mark.thorough
@pytest.mark.parametrize(
    "told",
    [
        "/*" * 400_000,
        "axiom: A\nA --> " + ":" * 400_000,
        "#define a " + "a" * 200 + "\naxiom: " + "a " * 40_000,
        "/" * 900_000,
        "#define f(x) x\naxiom: " + "f " * 200_000,
        "#define f(x) " + "f(x)" * 400 + "\naxiom: f(1)",
        "#define f(x) " + "x" * 400 + "\naxiom: " + "f(" * 20_000 + ")" * 20_000,
        "axiom: A\n" + "\t\\\n" * 18_000,
    ],
)
def test_hostile_texts_of_cpfg_are_read_or_refused_soon(told):
    started = time.process_time()
    with suppress(GrammarError):
        LSystem.parse(f"#dialect cpfg\n{told}")
    assert time.process_time() - started < 5


def test_a_condition_in_the_notation_of_the_book_is_told_as_one_in_lpy():
    with pytest.raises(GrammarError) as refusal:
        LSystem.parse("#dialect lpy\nAxiom: B(3,1)\nproduction:\nB(x,y) : x > 3 --> B(x-1, y)")
    (problem,) = refusal.value.problems
    assert problem.expected.startswith("no condition, which L-Py has in Python") and "x > 3" in problem.found

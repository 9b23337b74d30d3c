# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The text of grammars: what it may say, and that anything else is refused at once with its place."""

import time

import pytest
from conftest import FULL
from grammar_inputs import grammars
from hypothesis import given
from hypothesis import strategies as st
from test_grammar_conformance import ENTRIES, text

from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.grammars import Budget, GrammarError, LSystem

SMALL = Budget(modules=5000, bytes=10_000_000, seconds=2)
MANY = 8000 if FULL else 2000  # productions
WHOLE = r"""#dialect abop
#names internode, Fl              # names of more than one letter
#define r1 0.9                    # 0.5 .. 1.2 length ratio
#define q (1 - r1)^0.5            # of an earlier one
#define angle 22.5                # 0 .. 90 deg of branches
#ignore + - / $
#angle 22.5
#step 0.5
#width 0.02
#seed 7
#generations 10
#tropism 0 0 -1 0.22
# a comment in Ελληνικά
axiom: A(1, 10) internode
A(l, w) : l > 0.01 -> !(w) F(l) [ &(45) A(l*r1, w*q) ] /(137.5) A(l*r1, w*q)
0 < 0 > 1 -> 1 [ + F 1 F 1 ]
BC<S>G[H]M -> T
F -(0.33)-> F [ + F ] F           # by chance
- -> +
-(a) -> -(a*2)
X -> *
group 2:
internode -> Fl @v ?P(0,0,0) ~H(2)
decomposition:
maximum depth: 3
Fl -> F F
homomorphism:
T -> { . G . }
"""


def test_every_construct_is_read():
    system = LSystem.parse(WHOLE)
    assert system.names == ("internode", "Fl") and system.ignore == ("+", "-", "/", "$")
    r1, q, angle = system.constants
    assert (r1.value, r1.low, r1.high, r1.doc, r1.unit) == (0.9, 0.5, 1.2, "length ratio", "")
    assert q.value == pytest.approx(0.1**0.5, rel=1e-12) and q.doc == "of an earlier one" and q.low is None
    assert (angle.unit, angle.doc) == ("angle", "of branches")
    assert (system.angle, system.step, system.width, system.seed, system.generations) == (22.5, 0.5, 0.02, 7, 10)
    assert system.tropism == (0, 0, -1, 0.22)
    assert [module.name for module in system.axiom] == ["A", "internode"]
    assert len(system.productions) == 7
    ((number, (rule,)),) = system.groups
    assert number == 2 and [m.name for m in rule.successor] == ["Fl", "@v", "?P", "~", "H"]
    assert system.decomposition_depth == 3 and system.homomorphism_depth is None
    minus, parametric = system.productions[4:6][::-1][1], system.productions[5]
    assert str(parametric) == "-(a) -> -(a*2)" and minus.predecessor.name == "-"


def test_what_is_written_reads_as_the_same():
    system = LSystem.parse(WHOLE)
    again = LSystem.parse(str(system))
    assert str(again) == str(system)
    assert again.constants == system.constants and again.axiom == system.axiom


def test_words_of_formulas_stay_apart_when_written():
    system = LSystem.parse("axiom: A(2)\nA(x) : not x < 1 and x < 3 -> B( not x or x == 2 , x - -1 , if(x > 1, 3, 4) )")
    assert str(system.productions[0].successor[0]) == "B(not x or x==2,x--1,if(x>1,3,4))"
    assert str(LSystem.parse(str(system)).derive(1)) == str(system.derive(1)) == "B(1,3,3)"


def test_modules_whose_letters_make_another_name_stay_apart_when_written():
    told = "#names ab, abc\naxiom: a b abc ? P(1) @ v\na b < ab > @ v -> a bc"
    system = LSystem.parse(told)
    assert [module.name for module in LSystem.parse(str(system)).axiom] == ["a", "b", "abc", "?", "P", "@", "v"]
    assert str(LSystem.parse(str(system))) == str(system)
    assert [each.name for each in LSystem.parse(str(system)).productions[0].left] == ["a", "b"]


@given(grammars())
def test_any_grammar_reads_as_the_same_when_written(told):
    system = LSystem.parse(told)
    assert str(LSystem.parse(str(system))) == str(system)


def test_a_homomorphism_may_be_called_interpretation():
    told = "axiom: A\nhomomorphism:\nmaximum depth: 2\nA -> FA"
    assert str(LSystem.parse(told.replace("homomorphism", "interpretation"))) == str(LSystem.parse(told))


def test_blanks_never_matter():
    rule = "0 < A ( x ) > [ B ] C : x > 1 -( 0.5 )-> F ( x , 2 ) [ + F ]"
    said = [LSystem.parse(f"axiom: A(2)\n{each}").productions[0] for each in (rule, rule.replace(" ", ""))]
    assert str(said[0]) == str(said[1]).replace("x>1", "x > 1")


def test_constants_may_be_given_other_values():
    system = LSystem.parse("#define r 0.5\n#define s r^2\naxiom: F(s)\n")
    assert str(system.with_constants(r=3).derive(0)) == "F(9)"
    assert str(system.with_constants(s=7, r=3).derive(0)) == "F(7)"
    with pytest.raises(ShapeError, match="^constants.t: is no constant of the text, which has r, s$"):
        system.with_constants(t=1)


def test_the_book_is_read_as_it_is_printed():
    """Names of productions, = for equality, & and | for and and or: heterocysts of ABOP section 3.3."""
    told = "#define CH 900\naxiom: F(6,1,CH)\np1 : F(s,t,c) : t=1 & s>=6 -> F(s/3*2,2,c)f(1)F(s/3,1,c)"
    assert str(LSystem.parse(told).derive(1)) == "F(4,2,900)f(1)F(2,1,900)"


def test_angles_of_formulas_are_degrees():
    assert str(LSystem.parse("axiom: F(sin(30), cos(60), atan2(1, 1))").derive(0)) == "F(0.5,0.5,45)"


@pytest.mark.parametrize(
    ("told", "line", "column", "expected", "found"),
    [
        ("axiom: F[+F\n", 1, 9, "']' after it", "'['"),
        ("axiom: F]+F\n", 1, 9, "'[' before it", "']'"),
        ("axiom: F\nF -> F[+F]]", 2, 11, "'[' before it", "']'"),
        ("axiom: F\nF -> F(", 2, 7, "')' after it", "'('"),
        (
            "axiom: F\nF .33→ FF",
            2,
            1,
            "one module to be replaced; a probability stands in the arrow: F -(0.5)",
            "'F .33'",
        ),
        ("axiom: A(1)\nA(p) -(p)-> F", 2, 1, "one module to be replaced; a probability is a constant", "'A(p) -(p)'"),
        ("axiom: F\nF -> F[+(25F]F", 2, 9, "')' after it", "'('"),
        ("axiom: F\nG(x -> F", 2, 2, "')' after it and before the arrow", "'('"),
        ("axiom: F\nA(x) : x > (1 -> F", 2, 12, "')' after it and before the arrow", "'('"),
        ("axiom: F~leaf(0.5)", 1, 9, "an organ of one letter, or a line '#names leaf'", "'~leaf'"),
        ("axiom: F\n#width -0.2", 2, 8, "a diameter of at least 0", "'-0.2'"),
        ("axiom: F\n#Ingore + -", 2, 2, "#ignore, or a blank before a comment", "'Ingore'"),
        ("axiom: F\nF -> F(1+)", 2, 10, "a value", "the end of the formula"),
        ("axiom: F\nF(x) -> F(y)", 2, 11, "one of the names x, pi, tau, e", "'y'"),
        ("axiom: F\nF(x) -> F(open(x))", 2, 11, "one of the functions sin, cos", "'open'"),
        ("axiom: F\nF(2) -> F", 2, 3, "a name for the parameter", "'2'"),
        ("axiom: F\nF(x) < F(x) -> F", 2, 10, "each name for one parameter", "'x'"),
        (
            "axiom: F\nFl -> F",
            2,
            1,
            "one module to be replaced; a name of several letters is declared: #names Fl",
            "'Fl'",
        ),
        ("axiom: A(1)\nA(x) -> A(1/0)", 2, 11, "a finite number", "inf"),
        ("axiom: F\nF = F", 2, 1, "a production with '->', or further right the rest of one", "'F = F'"),
        ("axiom: F\nF ->", 2, 5, "a word, or * for the empty one", "the end of the line"),
        ("axiom: F\nF -> F*F", 2, 7, "a module", "'*'"),
        ("axiom: F\n < F -> F", 2, 2, "a module of the context", "'<'"),
        ("axiom: F\nF < A < B -> F", 2, 7, "one '<' and behind it one '>'", "'<'"),
        ("axiom: F\n[ -> F", 2, 1, "a module to be replaced, for brackets stay", "'['"),
        ("axiom: F\nF -(0.7)-> FF\nF -(0.5)-> F", 3, 3, "probabilities of F that sum to at most 1", "1.2"),
        ("axiom: F\nF -(1.5)-> FF", 2, 5, "a probability from 0 to 1", "1.5"),
        ("axiom: F\n#angle 1/0", 2, 8, "a finite number", "inf"),
        ("axiom: F\n#generations 2.5", 2, 14, "a whole number from 0 to 1000000", "'2.5'"),
        ("axiom: F\n#ingore + -", 2, 2, "#ignore, or a blank before a comment", "'ingore'"),
        ("axiom: F\n#dialect maya", 2, 10, "one of the dialects abop, cpfg, fractint", "'maya'"),
        ("axiom: F\n#define a b\n#define b a", 2, 11, "constants that do not need each other", "'a'"),
        ("axiom: F\n#define a 1\n#define a 2", 3, 9, "each constant once", "'a'"),
        ("axiom: F\naxiom: G", 2, 1, "one axiom", "a second one"),
        ("F -> FF", 1, 8, "a line 'axiom: ...' in the text", "the end of the line"),
        ("axiom: F\nF -> F\x00", 2, 7, "text", "the character 0"),
        ("axiom: F\nF -> é", 2, 6, "a module", "'é'"),
        ("axiom: F\n[A] < F -> F", 2, 1, "a module before '['", "'['"),
        ("axiom: F\nA[ < F -> F", 2, 2, "']' after it", "'['"),
        ("axiom: F\nF > [[A]B] -> F", 2, 6, "the module that a branch begins with", "'['"),
    ],
)
def test_what_is_wrong_is_told_with_its_place(told, line, column, expected, found):
    with pytest.raises(GrammarError) as refusal:
        LSystem.parse(told)
    problem = refusal.value.problems[0]
    assert (problem.line, problem.column) == (line, column)
    assert problem.expected.startswith(expected) and problem.found.startswith(found)
    source, caret = problem.shown.split("\n")
    assert source[4:].strip() in told and caret.index("^") == 4 + column - 1


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("premise: A", "'#dialect houdini'"),
        ("X=F[+X]", "'#dialect houdini', or Fractint's, '#dialect fractint'"),
        ("A(i)=F", "'#dialect houdini'"),
        ("derivation length: 3", "'#dialect cpfg', those of L-Py with '#dialect lpy'"),
        ("Lsystem: 1", "'#dialect cpfg'"),
        ("module A(x)", "'#dialect lpy'"),
        ("Koch {", "'#dialect fractint'"),
        ("angle: 25", "'#angle 25'"),
        ("p24f.l", "system = { file = '...' }"),
        ("trees/honda.txt", "system = { file = '...' }"),
    ],
)
def test_a_line_of_another_notation_is_told_where_it_is_read(line, said):
    with pytest.raises(GrammarError) as refusal:
        LSystem.parse(line)
    assert said in refusal.value.problems[0].expected and "->" in refusal.value.problems[0].expected


def test_directives_are_read_in_any_case_and_angles_with_a_degree_sign():
    system = LSystem.parse("#Dialect abop\n#Define r 3\n#DEFINE d 22.5° # 0 .. 90 deg\n#Angle 25 °\naxiom: F(r)+(d)")
    assert system.angle == 25 and str(system.derive(0)) == "F(3)+(22.5)"
    assert LSystem.parse("#Dialect fractint\nX {\nAxiom F\nF=FF\n}").derive(2).count("F") == 4


def test_organs_of_letters_stand_apart_in_what_is_written():
    """``~l f`` is an organ l and a move; without the blank a reader would ask for the name of an organ ``lf``."""
    system = LSystem.parse("axiom: A\nA -> ~l f")
    assert LSystem.parse(str(system)).productions[0].successor == system.productions[0].successor
    assert len(LSystem.parse("#names leaf\naxiom: F~leaf(0.5)").derive(0)) == 3


def test_a_diameter_below_nothing_is_nothing():
    assert LSystem.parse("axiom: !(-0.2)F").derive(0).figure().width.tolist() == [0]


def test_all_wrong_lines_are_told_at_once():
    with pytest.raises(GrammarError) as refusal:
        LSystem.parse("axiom: F(\nF -> F[\nF -> G\nG < -> F\n#angle x\n")
    assert [problem.line for problem in refusal.value.problems] == [1, 2, 4, 5]


@pytest.mark.parametrize(
    "told",
    [
        "axiom: A\nA -> FA\ndecomposition:\nA -> AA\n#generations 3",
        "axiom: A\nA -> FA\ndecomposition:\nA -> FA\n#generations 3",
        "axiom: A(1)\nA(x) -> A(x/0)\n#generations 1",
        "axiom: A(1)\nA(x) : 1/(x-1) -> A(x)\n#generations 1",
        "axiom: A(1)\nA(x) -> A(x*1e300)\n#generations 3",
        "axiom: F\nF -> FFFFFFFFFF\n#generations 12",
        "axiom: F\nF -> FFFFFFFFFF\n#generations 1000000",
        "axiom: F\nF -(0.9)-> FFFFFFFFFF\n#generations 1000000",
        "axiom: A(9)\nA(x) : x > 0 -> A(x)A(x)\n#generations 1000000",
        "x" * 10_000_000,
        "\n" * 10_000_000,
        "axiom: " + "F(" * 50_000,
        "axiom: A" + "(1" * 5000 + ")" * 5000,
        "#define a " + "(" * 1000 + "1" + ")" * 1000 + "\naxiom: A(a)",
        "#define a 9^9^9^9\naxiom: A(a)",
    ],
    ids=range(15),
)
def test_hostile_grammars_are_refused_soon(told):
    started = time.process_time()
    with pytest.raises(ShapeError) as refusal:
        LSystem.parse(told).derive(budget=Budget(modules=1_000_000, seconds=1))
    assert time.process_time() - started < 1.5
    assert len(str(refusal.value)) < 2000


def test_a_refusal_of_a_known_size_comes_at_once():
    system = LSystem.parse("axiom: X\nX -> F-[[X]+X]+F[+FX]-X\nF -> FF\n")
    assert len(system.derive(5)) == 6263  # ABOP figure 1.24 f
    size = (37 * 4**20 - 9 * 2**20 - 22) // 6
    started = time.process_time()
    with pytest.raises(ShapeError, match=f"at most 20,000,000 modules, but 20 make {size:,}"):
        system.derive(20)
    assert time.process_time() - started < 0.01


@pytest.mark.thorough
def test_a_nest_of_branches_deeper_than_any_recursion_is_derived():
    depth = 100_000 if FULL else 25_000
    system = LSystem.parse(f"#ignore +\naxiom: A{'[+' * depth}B{']' * depth}\nA < B -> C")
    assert str(system.derive(1)) == f"A{'[+' * depth}C{']' * depth}"


@given(
    st.text(max_size=200)
    | st.lists(st.sampled_from(list("AF+-[](),:<>*#&!\n 1x.") + ["->", "axiom:", "#define "])).map("".join)
)
def test_any_text_is_a_grammar_or_refused(told):
    try:
        LSystem.parse(told).derive(2, budget=SMALL)
    except ShapeError as refusal:
        assert len(str(refusal)) < 20_000


@given(st.sampled_from(ENTRIES), st.data())
def test_any_change_of_a_grammar_is_derived_or_refused(entry, data):
    told = text(entry)
    for _ in range(data.draw(st.integers(1, 4))):
        at, length = data.draw(st.integers(0, len(told))), data.draw(st.integers(0, 3))
        told = told[:at] + data.draw(st.text("AF+-[](),:<>*#&!^/\n 01xl.$%{}|=", max_size=3)) + told[at + length :]
    try:
        word = LSystem.parse(told).derive(3, budget=SMALL)
    except ShapeError as refusal:
        assert "Traceback" not in str(refusal)
    else:
        assert len(word) <= SMALL.modules and isinstance(str(word), str)


@pytest.mark.parametrize("line", ["#define a 1 # " + "." * 500_000 + "x", "#define a 1 # " + "1" * 500_000 + " ..x"])
def test_a_comment_that_is_nearly_a_range_is_one_at_once(line):
    assert LSystem.parse(f"{line}\naxiom: A(a)").constants[0].low is None


def test_a_list_of_groups_is_bounded():
    with pytest.raises(GrammarError, match="at most 100000 steps"):
        LSystem.parse("#groups " + "1*9999 " * 10_000 + "\naxiom: A")


@pytest.mark.thorough
@pytest.mark.parametrize(
    "rules",
    [
        "\n".join(f"A(x) : x > {k + 1} -> B" for k in range(MANY)),
        "\n".join(f"A(x) : x < {k - MANY} -> A(x)A(x)" for k in range(MANY)) + "\nA(x) -> A(x)A(x)",
        "\n".join(f"{chr(65 + k % 50)} < A(x) > {chr(65 + k // 50 % 50)} -> AB" for k in range(2 * MANY)),
    ],
    ids=["conditions", "growing", "contexts"],
)
def test_thousands_of_productions_are_no_trap(rules):
    started = time.process_time()
    try:
        LSystem.parse(f"axiom: A(1)\n{rules}").derive(2000, budget=Budget(modules=10_000, seconds=1 if FULL else 0.3))
    except ShapeError as refusal:
        assert len(str(refusal)) < 20_000
    assert time.process_time() - started < (20 if FULL else 4)


@pytest.mark.parametrize("number", ["0.4", "2", "1/3", "-1", "1e-1", "1/0", "(.5)"])
def test_a_number_is_no_condition(number):
    """It would always hold, where a probability is meant that programs write elsewhere."""
    with pytest.raises(GrammarError, match=r"line 2, column 5: expected a condition that compares, .* -\(0.4\)->"):
        LSystem.parse(f"axiom: A\nA : {number} -> B")


@pytest.mark.parametrize("condition", ["1", "0", "2 > 1", "p", "p > 0.3", "ran(1) < 2", "x"])
def test_always_never_and_what_names_say_are_conditions(condition):
    word = LSystem.parse(f"#define p 0.4\naxiom: A(1)\nA(x) : {condition} -> B").derive(1)
    assert str(word) == ("A(1)" if condition == "0" else "B")


@pytest.mark.parametrize("text", ["#dialect cpfg\nAxiom: A\nA : .4 --> B", "#dialect houdini\nPremise: A\nA:0.4=B"])
def test_a_fraction_is_no_condition_of_another_program(text):
    with pytest.raises(GrammarError, match="line 3, .* compares, for a probability stands behind the successor"):
        LSystem.parse(text)


def test_a_probability_without_a_value_is_told_how_to_have_one():
    with pytest.raises(GrammarError, match="a probability is a constant, no parameter: #define p 0.5, found 'A -"):
        LSystem.parse("axiom: A\nA -(p)-> B")

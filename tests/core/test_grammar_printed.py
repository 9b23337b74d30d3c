# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grammars pasted as the book prints them, and with the arrow of cpfg and L-Py, are those that are typed."""

import pytest
from test_grammar_conformance import ENTRIES
from test_grammar_conformance import text as typed_out

import sweep_addon as sw
from sweep_addon.core.grammars import GrammarError, LSystem

TYPED = "#generations 5\n#angle 25.7\naxiom: X\nX -> F[+X]F[-X]+X\nF -> FF\n"  # figure 1.24d
PRINTED = [
    "n=5, δ=25.7°\nω : X\np1 : X → F[+X]F[−X]+X\np2 : F → FF\n",
    "δ = 25.7\n#generations 5\nω:X\np1:X→F[+X]F[–X]+X\np2:F→FF",
    "#angle 25.7\n#generations 5\naxiom: X\nX --> F[+X]F[-X]+X\nF-->FF",
]


@pytest.mark.parametrize("text", PRINTED)
def test_printed_text_is_the_typed_one(text):
    assert str(LSystem.parse(text)) == str(LSystem.parse(TYPED))


UNDER_FIGURES = [
    ("n=2, δ=90◦\nF−F−F−F\nF → F−F+F+FF−F−F+F", "#generations 2\n#angle 90\naxiom: F-F-F-F\nF -> F-F+F+FF-F-F+F"),
    ("n=2,δ=90∘\n−L\nL → LF+RFR\nR → −LF", "#generations 2\n#angle 90\naxiom: -L\nL -> LF+RFR\nR -> -LF"),
    ("#ignore b\nbaaa\nb < a → b\nb → a", "#ignore b\naxiom: baaa\nb < a -> b\nb -> a"),
    ("ω : F\np : F → FF−F", "axiom: F\nF -> FF-F"),
    ("ω : F\np: F -> F-\n  F", "axiom: F\nF -> F-F"),
    ("ω : F\np:F→F−F", "axiom: F\nF -> F-F"),
    ("ω : A(1)\np : A(x) : x < 3 -> A(x+1)", "axiom: A(1)\nA(x) : x < 3 -> A(x+1)"),
    ("ω : A(2)\np1 : A(x) → A(x×2·x)", "axiom: A(2)\nA(x) -> A(x*2*x)"),
]


@pytest.mark.parametrize(("printed", "typed"), UNDER_FIGURES)
def test_an_axiom_without_a_name_and_an_only_production_as_under_figures(printed, typed):
    assert str(LSystem.parse(printed)) == str(LSystem.parse(typed))


def test_names_may_be_greek_and_have_subscripts():
    printed = "#define α₁ 10◦\n#define ρ 0.5 /* ratio */\nω : A(1,60)\np₁ : A(s,φ) : s>ρ → F(s)[&(α₁)A(s∗ρ,φ)]+(φ)"
    typed = "#define a 10\n#define r 0.5\naxiom: A(1,60)\nA(s,f) : s>r -> F(s)[&(a)A(s*r,f)]+(f)"
    system = LSystem.parse(printed)
    assert str(system.derive(2)) == str(LSystem.parse(typed).derive(2))
    assert str(LSystem.parse(str(system))) == str(system)
    assert [constant.name for constant in system.constants] == ["α1", "ρ"]


def test_a_constant_with_a_greek_name_is_kept_by_a_job():
    plant = sw.Plant("#define α 10\naxiom: F[+(α)F]", constants={"α": 20})
    assert sw.load(sw.dump(plant)) == plant
    told = sw.dump(plant).replace('"α" = 20.0', '"β" = 20.0')
    with pytest.raises(sw.ShapeError, match="constants.β: is no constant of the text, which has α"):
        sw.load(told)


def test_the_tropism_under_a_table_is_told_how_it_is_written():
    with pytest.raises(GrammarError, match="a tropism is written '#tropism 0 0 -1 0.22'"):
        LSystem.parse("ω : F\nT=(0.00,−1.00,0.00), e=0.22")


def test_a_module_p_with_a_condition_is_no_label():
    assert str(LSystem.parse("#define c 2\naxiom: p\np : c > 1 -> q").derive(1)) == "q"


WEEPING = """ω : !(1)F(200)/(45)A
p1 : A : ∗ → !(1.7)F(50)[&(19)F(50)A]/(95)
[&(19)F(50)A]/(132)[&(19)F(50)A]
p2 : F(l) : ∗ → F(l∗1.1)
p3 : !(w) : ∗ → !(w∗1.7)"""


def test_what_has_no_number_among_numbered_productions_is_the_rest_of_one():
    typed = WEEPING.replace("/(95)\n", "/(95)")
    assert str(LSystem.parse(WEEPING).derive(2)) == str(LSystem.parse(typed).derive(2))
    assert len(LSystem.parse(WEEPING).derive(1)) == 22


@pytest.mark.parametrize("text", ["F → F+F\nF[", "n=2\nF", "axiom F\nF → F", "a = b\nF → F", "F\nF → G\nF"])
def test_what_might_be_a_mistake_is_no_axiom_and_no_rest(text):
    with pytest.raises(GrammarError):
        LSystem.parse(text)


def test_the_books_condition_that_always_holds():
    text = "#define c 1\n#define p 0.3\nω : F(1)\np1 : F(x) : ∗ → F(x∗p)+F(x∗(c−p))"
    typed = "#define c 1\n#define p 0.3\naxiom: F(1)\nF(x) -> F(x*p)+F(x*(c-p))"
    assert str(LSystem.parse(text)) == str(LSystem.parse(typed))


def test_comparisons_as_printed():
    text = "axiom: A(3)A(4)A(5)\nA(s) : s ≥ 4 & s≠5 → B\nA(s) : s ≤ 3 → C"
    assert str(LSystem.parse(text).derive(1)) == "CBA(5)"


def test_a_minus_of_the_context_or_the_predecessor_is_no_part_of_the_arrow():
    assert str(LSystem.parse("axiom: F-F\n- -> +").derive(1)) == "F+F"
    assert str(LSystem.parse("axiom: F-F\n--> +").derive(1)) == "F+F"
    assert str(LSystem.parse("axiom: F-F\nF > --> G").derive(1)) == "G-F"
    assert str(LSystem.parse("axiom: FB-F\nF > B- -> G").derive(1)) == "GB-F"


def test_what_is_written_is_read_again_with_every_arrow():
    for text in ("axiom: FB-F\nF > B- -> G", "axiom: F-\n- -> F", "axiom: F-\nF < - > F -(0.5)-> F"):
        written = str(LSystem.parse(text))
        assert str(LSystem.parse(written)) == written


def test_comments_keep_their_signs():
    system = LSystem.parse("#define r 0.5  # 0 .. 1 größer → länger\naxiom: F(r)")
    assert system.constants[0].doc == "größer → länger"


def test_a_refusal_points_into_the_line_that_is_shown():
    with pytest.raises(GrammarError) as refusal:
        LSystem.parse("ω : F\nF → F(x)")
    problem = refusal.value.problems[0]
    assert problem.line == 2
    assert problem.source[problem.column - 1] == "x"


@pytest.mark.parametrize("text", ["n=5.5, δ=25°\naxiom: F", "n=99999999\naxiom: F", "δ=2.5.5\naxiom: F"])
def test_legends_are_checked_as_directives_are(text):
    with pytest.raises(GrammarError):
        LSystem.parse(text)


HETEROCYSTS = """#define CH 900 /* high concentration */
#define CT 0.4 /* concentration threshold */
#define ST 3.9 /* segment size threshold */
#include H /* heterocyst shape specification */
#ignore: f ∼ H
ω : −(90)F(0,0,CH)F(4,1,CH)F(0,0,CH)
p1 : F(s,t,c) : t=1 & s>=6 → F(s/3∗2,2,c)f(1)F(s/3,1,c)
p2 : F(s,t,c) : t=2 & s>=6 → F(s/3,2,c)f(1)F(s/3∗2,1,c)
p3 : F(h,i,k) < F(s,t,c) > F(o,p,r) : s>ST|c>CT → F(s+.1,t,c+0.25∗(k+r−3∗c))
p4 : F(h,i,k) < F(s,t,c) > F(o,p,r) : !(s>ST|c>CT) → F(0,0,CH) ∼ H(1)
p5 : H(s) : s<3 → H(s∗1.1)
"""


def test_the_listing_of_the_filament_with_heterocysts_as_printed():
    entry = next(entry for entry in ENTRIES if entry["id"] == "abop-anabaena-heterocysts")
    system = LSystem.parse(HETEROCYSTS)
    assert str(system.derive(entry["iterations"])) == str(LSystem.parse(typed_out(entry)).derive())
    assert system.constants[0].doc == "high concentration"


def test_signs_of_print_in_directives():
    printed = "#define p 0.3\n#define q 1 − p\n#define h (p∗q) ∧ 0.5 /* height */\n#angle −60\nω : F(h)"
    typed = "#define p 0.3\n#define q 1 - p\n#define h (p*q)^0.5 # height\n#angle -60\naxiom: F(h)"
    assert LSystem.parse(printed).angle == -60
    assert str(LSystem.parse(printed).derive(0)) == str(LSystem.parse(typed).derive(0)) == "F(0.458258)"


def test_probabilities_and_contexts_as_printed():
    printed = "ω : F+F\nF →(.33) FF\nF →(.67) G\n∗ < + > ∗ → −\n− → ε"
    typed = "axiom: F+F\nF -(.33)-> FF\nF -(.67)-> G\n+ -> -\n- -> *"
    for generations in (1, 2):
        assert str(LSystem.parse(printed).derive(generations)) == str(LSystem.parse(typed).derive(generations))


def test_comments_as_in_c_are_no_part_of_a_word():
    told = "axiom: A /* all */ B  # a /* b\nA -> F/F /* roll */\nB -> /F /* not closed"
    assert str(LSystem.parse(told).derive(1)) == "F/F/F"


WRAPPED = """ω : −(90)F(0,0,900)F(4,1,900)F(0,0,900)
p1 : F(s,t,c) : t=1 & s>=6 →  /* the wall
   F(s/3∗2,2,c)f(1)        # between
   F(s/3,1,c)
p2 : F(s,t,c) : t=2 & s>=6 →
F(s/3,2,c)f(1)F(s/3∗2,1,c)
p3 : F(h,i,k) < F(s,t,c) > F(o,p,r)
   : s>3.9|c>0.4 → F(s+.1,t,
c+0.25∗(k+r
−3∗c))
p4 : F(h,i,k) < F(s,t,c) > F(o,p,r)
   : !(s>3.9|c>0.4)
   → F(0,0,900) [
∼ H(1) ]
homomorphism : H(s) → +(s)
   F(s)
#ignore: f ∼ H
"""
UNWRAPPED = """#ignore: f ~ H
axiom: -(90)F(0,0,900)F(4,1,900)F(0,0,900)
F(s,t,c) : t=1 & s>=6 -> F(s/3*2,2,c)f(1)F(s/3,1,c)
F(s,t,c) : t=2 & s>=6 -> F(s/3,2,c)f(1)F(s/3*2,1,c)
F(h,i,k) < F(s,t,c) > F(o,p,r) : s>3.9|c>0.4 -> F(s+.1,t,c+0.25*(k+r-3*c))
F(h,i,k) < F(s,t,c) > F(o,p,r) : !(s>3.9|c>0.4) -> F(0,0,900)[~H(1)]
homomorphism:
H(s) -> +(s)F(s)
"""


def test_axioms_and_productions_go_on_over_several_lines():
    assert str(LSystem.parse(WRAPPED).derive(30)) == str(LSystem.parse(UNWRAPPED).derive(30))
    assert str(LSystem.parse("axiom:\n  A\n\tB\nA -> C\n\n  D").derive(1)) == "CDB"


@pytest.mark.parametrize(
    ("text", "line", "column"),
    [
        ("axiom: F\nF(x) -> G  # long\n    H\n    F(y)", 4, 7),  # the name y
        ("axiom: F\nF ->\n  [+F   # open\n  F", 3, 3),  # the bracket
        ("axiom: F(1,\n  2", 1, 9),  # the bracket that is left open
        ("axiom: A B\n  F(1, ,\n  2)", 2, 8),  # the parameter that is none
        ("axiom: F\nF -(0.6)-> G\nF\n  -(0.6)-> H", 3, 1),  # no arrow, for the line below may be of the module -
        ("axiom: F\nF -(0.6)-> G\nF : 1\n  : 2 -> H", 4, 3),  # one condition
    ],
)
def test_a_refusal_points_into_the_line_that_goes_on(text, line, column):
    with pytest.raises(GrammarError) as refusal:
        LSystem.parse(text)
    problem = refusal.value.problems[0]
    assert (problem.line, problem.column) == (line, column)
    assert problem.source == text.split("\n")[line - 1]


def test_probabilities_of_productions_that_go_on_are_told_where_they_stand():
    with pytest.raises(GrammarError, match="line 3, column 3: expected probabilities of F") as refusal:
        LSystem.parse("axiom: F\nF -(0.6)-> G\nF -(0.6)->\n  H\n  H")
    assert refusal.value.problems[0].source == "F -(0.6)->"


@pytest.mark.parametrize("alone", ["group 1: F -> G", "start: n = 1", "n=5", "#angle 30", "G -> H", "homomorphism:"])
def test_a_line_that_stands_for_itself_ends_the_one_before_however_far_right_it_stands(alone):
    assert str(LSystem.parse(f"axiom: FG\nF -> FF\n{alone}")) == str(
        LSystem.parse(f"axiom: FG\nF -> FF\n      {alone}")
    )


def test_what_stands_no_further_right_goes_on_in_nothing():
    for text in (
        "axiom: F\nF -> G\nG",
        "  axiom: F\n  F -> G\n  G",
        "axiom: F\n#angle 3\n  G",
        "axiom: F\ngroup 1:\n  G",
    ):
        with pytest.raises(GrammarError, match="expected a production with '->'"):
            LSystem.parse(text)


def test_lines_without_number_go_on_at_once():
    """Each line is looked at once: else a text of 20,000 lines would take minutes."""
    text = "axiom: F\nF ->\n" + "\n".join(["  [ F"] * 9_990 + ["  ] F"] * 9_990)
    assert len(LSystem.parse(text).derive(1)) == 4 * 9_990


TERNARY = """n=6
#define d1 94.74 /* divergence angle 1 */
#define d2 132.63 /* divergence angle 2 */
#define a 18.95 /* branching angle */
#define lr 1.109 /* elongation rate */
#define vr 1.732 /* width increase rate */
ω : !(1)F(200)/(45)A
p1 : A : ∗ → !(vr)F(50)[&(a)F(50)A]/(d1)
             [&(a)F(50)A]/(d2)[&(a)F(50)A]
p2 : F(l) : ∗ → F(l∗lr)
p3 : !(w) : ∗ → !(w∗vr)
"""


def test_the_listing_of_a_tree_with_ternary_branching_as_printed():
    entry = next(entry for entry in ENTRIES if entry["id"] == "abop-2.8a")
    assert str(LSystem.parse(TERNARY).derive(3)) == str(LSystem.parse(typed_out(entry)).derive(3))


def test_the_dragon_curve_is_read_as_printed_once_its_names_are_declared():
    printed = "#names Fl Fr\n#angle 90\nω: Fₗ\nFₗ → Fₗ+Fᵣ+\nFᵣ → −Fₗ−Fᵣ"
    assert str(LSystem.parse(printed).derive(2)) == "Fl+Fr++-Fl-Fr+"  # by hand, ABOP figure 1.10 a


def test_a_power_is_read_as_documents_set_it():
    assert str(LSystem.parse("#define h (2 * 8) ˆ 0.5\naxiom: F(h)").derive(0)) == "F(4)"

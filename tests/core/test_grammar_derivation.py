# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Words derived by arrays are those that reading from left to right derives, for any grammar."""

import numpy as np
import pytest
import sequential_deriver
from conftest import FULL
from grammar_inputs import crowded, grammars, sectioned
from hypothesis import example, given, settings
from hypothesis import strategies as st
from sequential_deriver import text

from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.grammars import Budget, LSystem
from sweep_addon.core.grammars.deriving.derivation import strategy
from sweep_addon.core.grammars.deriving.growth import bounds

SMALL = Budget(modules=2000)
MORE = settings(max_examples=(2 if FULL else 1) * settings().max_examples)
GENERATIONS = 4


def same_words(told, seed):
    """Compare all generations with the reference, up to the first that is too large or has no finite parameter."""
    system = LSystem.parse(told)
    found = []
    for generation in range(GENERATIONS + 1):
        try:
            found.append(str(system.derive(generation, seed, SMALL)))
        except ShapeError:
            break
    wanted = [text(word) for word in sequential_deriver.derive(system, len(found) - 1, seed)]
    assert found == wanted


@given(grammars())
@example("axiom: ABC[DE][SG[HI[JK]L]MNO]\nBC < S > G[H]M -> T")
@example("axiom: A[[B]C[D]]E\nA < B -> X\nA < D -> Y\nA < E -> Z\nA > [C] -> Q")
@example("axiom: A[B%C[D]E]F%G\nB -> BB\nC < D -> %")
def test_any_grammar_derives_the_words_of_the_reference(told):
    same_words(told, seed=3)


@MORE
@given(sectioned())
@example(
    "#groups 3 1 ...\naxiom: AB\nA -> AA\ngroup 1:\nA > A -> B\ngroup 3:\nB -(0.5)-> A[B%]A\ndecomposition:\nA < B -> *"
)
def test_any_grammar_with_sections_derives_the_words_of_the_reference(told):
    same_words(told, seed=5)


@MORE
@given(sectioned())
def test_any_word_is_interpreted_as_by_the_reference(told):
    system = LSystem.parse(told)
    try:
        found = str(system.derive(2, 8, SMALL).interpreted(SMALL))
    except ShapeError:
        return
    assert found == text(sequential_deriver.interpreted(system, sequential_deriver.derive(system, 2, 8)[-1], 2))


@given(grammars(cut=False, axial=True))
@example("#ignore + -\naxiom: FAB[A]F\nA < B > F -> [C]AB[F]F\nF < A -> AA\nA > B -> BA\n+ -> -+\nB > F : 1 -> F[B]FB")
def test_grammars_whose_axes_stay_are_derived_by_links_as_by_the_reference(told):
    assert strategy(LSystem.parse(told).compiled) in ("pool", "forest", "doubling")
    same_words(told, seed=6)


@MORE
@given(crowded())
@example("axiom: A(3)A(2)A(3)A(1)\nA(x) : x == 1 -> A(4)B\nA(y) < A(x) > A(z) : x > 1 -> A(x-1)\nB < A(x) -> BA(3)")
@example("axiom: A(1)A(2)A(3)\nA(x) : x < 2 -> B\nA(x) > A(z) : z-2 -> A(z)A(x)\nA(x) > A(z) : x -> BA(z)")
def test_modules_with_many_productions_take_those_of_the_reference(told):
    assert strategy(LSystem.parse(told).compiled) in ("pool", "forest")
    same_words(told, seed=4)


KINDS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstu"


def test_words_of_many_kinds_are_derived_by_links_as_by_the_reference():
    """Three of more than 40 kinds are more than 16 bits can number."""
    rules = [f"{one} < {two} -> {one}" for one, two in zip(KINDS, KINDS[1:], strict=False)]
    told = "\n".join([f"axiom: {KINDS}", *rules[::2], f"u < {KINDS[0]} -> AB", f"{KINDS[2]} > D -> CDA"])
    assert strategy(LSystem.parse(told).compiled) == "pool"
    same_words(told, seed=0)
    assert str(LSystem.parse(told).derive(1)).startswith("AACDACEEGG")


@given(grammars(context=False))
def test_grammars_without_context_derive_the_words_of_the_reference(told):
    same_words(told, seed=11)


@given(grammars(context=False, stochastic=False, cut=False))
def test_grammars_without_chance_derive_the_words_of_the_reference(told):
    same_words(told, seed=0)


@pytest.mark.parametrize(
    ("told", "generations", "wanted"),
    [
        # ABOP 1.6.2: signals towards the tips, and to the root
        ("#ignore + -\naxiom: b[+a]a[-a]a[+a]a\nb < a -> b", 3, "b[+b]b[-b]b[+b]b"),
        ("#ignore + -\naxiom: a[+a]a[-a]a[+a]b\na > b -> b", 3, "b[+a]b[-a]b[+a]b"),
        # ABOP figure 1.28
        ("axiom: ABC[DE][SG[HI[JK]L]MNO]\nBC < S > G[H]M -> T", 1, "ABC[DE][TG[HI[JK]L]MNO]"),
        ("axiom: ABC[DE][SG[II[JK]L]MNO]\nBC < S > G[H]M -> T", 1, "ABC[DE][SG[II[JK]L]MNO]"),
        # a cut acts in the step after the one that writes it
        ("axiom: A[BC]D\nB -> %", 1, "A[%C]D"),
        ("axiom: A[BC]D\nB -> %", 2, "A[]D"),
        # the first production that matches is taken; what none matches stays
        ("axiom: A(1)A(2)A(3)\nA(x) : x > 1 -> B(x)\nA(x) : x > 2 -> C", 1, "A(1)B(2)B(3)"),
        ("axiom: A(1)A(1,2)A\nA(x) -> B", 1, "BA(1,2)A"),
        ("axiom: AXA\nX -> *", 1, "AA"),
        # in a step the productions of its group are tried first
        ("axiom: A\nA -> AB\ngroup 2:\nA -> C\nB -> D", 2, "CD"),
        ("#groups 1*2 2\naxiom: A\ngroup 1:\nA -> AB\ngroup 2:\nA -> C", 4, "CBB"),
        ("#groups 1 2 ...\naxiom: A\ngroup 1:\nA -> BA\ngroup 2:\nB -> C\n", 4, "CCA"),
        # what a module is made of stands in its place at once
        ("axiom: A\nA -> AB\ndecomposition:\nB -> CD\nD -> E", 1, "ACE"),
        ("axiom: B(2)\ndecomposition:\nmaximum depth: 2\nB(x) -> CB(x+1)", 0, "CCB(4)"),
    ],
)
def test_published_semantics(told, generations, wanted):
    assert str(LSystem.parse(told).derive(generations)) == wanted


IN_ORDER = "\ndecomposition:\nQ -> QQ"  # of what no word has: it is derived step by step


@given(grammars(context=False, cut=False))
@example("axiom: F[+A]\nF -> FA\nA -> F[-A]")
def test_words_that_are_laid_out_once_are_those_derived_step_by_step(told):
    words = []
    for text_ in (told, told + IN_ORDER):
        try:
            words.append(LSystem.parse(text_).derive(3, 5, SMALL))
        except ShapeError:
            words.append(None)
    once, stepwise = words
    assert (once is None) == (stepwise is None)
    if once is not None:
        assert str(once) == str(stepwise)
        assert once.births.tolist() == stepwise.births.tolist()


def test_numbers_drawn_in_an_interpretation_do_not_hang_on_how_the_word_was_derived():
    told = "axiom: A\nA -> F[+A]A\nhomomorphism:\nF -(0.5)-> G\nA : ran(1) < 0.3 -> H(ran(2))"
    once, stepwise = (LSystem.parse(text_).derive(5, 1) for text_ in (told, f"{told}{IN_ORDER}"))
    assert str(once.interpreted()) == str(stepwise.interpreted())
    assert 0 < once.interpreted().count("G") < once.count("F")  # what is left as it is, is so for good


def test_a_changed_production_alters_what_grows_out_of_its_own_modules_alone():
    """The random numbers of A's branches are the same, whatever B becomes."""
    told = "axiom: A[B]A\nA -(0.5)-> A[+F]\nA -(0.5)-> [-F]A\nB -> {}\nC -(0.5)-> D"
    words = [str(LSystem.parse(told.format(successor)).derive(6, 2)) for successor in ("B", "CBC", "BCC")]
    others = [word.translate(dict.fromkeys(map(ord, "BCD"))) for word in words]
    assert len(set(words)) == 3
    assert others[0] == others[1] == others[2] and others[0].count("F") == 12


@pytest.mark.parametrize(("told", "mean", "spread"), [("ran(4)", 2, 4 / 12**0.5), ("nran(3, 0.5)", 3, 0.5)])
def test_random_numbers_have_their_distribution(told, mean, spread):
    word = LSystem.parse(f"axiom: A\nA -> AA\ngroup 15:\nA -> B({told})").derive(15, 9)
    values = word.columns[0]
    assert len(values) == 2**14
    assert abs(values.mean() - mean) < 4 * spread / 2**7
    assert abs(values.std() / spread - 1) < 0.03


class StoppedError(Exception):
    """What a progress raises to stop."""


WAYS = pytest.mark.parametrize(
    "told",
    ["axiom: A(1)\nA(x) -> F A(x+1)", "axiom: A B\nA < B -> A B", "axiom: A\nA -> FA\ndecomposition:\nF -> GG"],
    ids=["forest", "pool", "in order"],
)


@WAYS
def test_progress_rises_and_may_stop_a_derivation(told):
    parts = []
    system = LSystem.parse(told)
    system.derive(20, progress=parts.append)
    assert parts == sorted(parts) and parts[-1] == 1 and len(set(parts)) == 20

    def stop(part):
        if part > 0.5:
            raise StoppedError

    with pytest.raises(StoppedError):
        system.derive(20, progress=stop)


@WAYS
def test_progress_has_the_floating_point_errors_of_who_gave_it(told):
    """Formulas divide by zero in silence; what a caller does in between does not."""
    with np.errstate(divide="raise"), pytest.raises(FloatingPointError):
        LSystem.parse(told).derive(3, progress=lambda part: np.float64(1) / np.float64(0))


@pytest.mark.parametrize(
    ("told", "budget", "sentence"),
    [
        ("axiom: A\nA -> AA", Budget(modules=100), "at most 100 modules, but 10 make 1,024"),
        ("axiom: A(1)\nA(x) : x -> A(x)A(x)", Budget(modules=100), "at most 100 modules, but generation 7 has 128"),
        ("axiom: A\nB < A -> A\nA -> AA", Budget(modules=100), "at most 100 modules, but generation 7 has 128"),
        ("axiom: A(1)\nA(x) -> A(x)A(x)", Budget(bytes=1000), "at most 1,000 bytes, but 10 make 9,216"),
        ("axiom: A(1)\nA(x) -> A(x+1)", Budget(seconds=0), "at most 0 seconds, but generation 1 of 10 took longer"),
        ("axiom: A\nA -> B\ndecomposition:\nB -> BB", Budget(modules=100), "but generation 1 has 128"),
        ("axiom: A\nA -> B\ndecomposition:\nB -> C\nC -> B", Budget(), "must end within 100 levels"),
    ],
)
def test_what_is_over_the_budget_is_refused(told, budget, sentence):
    with pytest.raises(ShapeError, match=sentence):
        LSystem.parse(told).derive(10, budget=budget)


@pytest.mark.parametrize("generations", [-1, 1.5, "3", 10**7])
def test_only_whole_numbers_of_generations_are_taken(generations):
    with pytest.raises(ShapeError, match="generations: must be a whole number from 0 to 1,000,000"):
        LSystem.parse("axiom: A").derive(generations)


@pytest.mark.parametrize(
    ("told", "sizes"),
    [
        ("axiom: A\nA -> AB\nB -> A", [1, 2, 3, 5, 8, 13]),
        ("axiom: A(2)\nA(x) : x > 0 -> A(x-1)A(x-1)", [1, 2, 4, 4, 4, 4]),
        ("axiom: AB\nA < B -> BB\nB -> A", [2, 3, 4, 5, 6, 7]),
    ],
)
def test_sizes_are_those_of_the_words(told, sizes):
    system = LSystem.parse(told)
    assert system.sizes(5) == [len(system.derive(n)) for n in range(6)]
    assert system.sizes(5) == sizes


def test_bounds_of_a_stochastic_word_are_those_of_the_book():
    """ABOP figure 1.27: no word is longer than if the longest production were always taken."""
    told = "axiom: F\nF -(0.33)-> F[+F]F[-F]F\nF -(0.33)-> F[+F]F\nF -(0.34)-> F[-F]F"
    least, most = bounds(LSystem.parse(told).compiled, 5)
    assert least <= 606 and most == 7811


@given(grammars(cut=False))
def test_no_word_is_out_of_its_bounds(told):
    system = LSystem.parse(told)
    try:
        sizes = system.sizes(GENERATIONS, 4, SMALL)
    except ShapeError:
        return
    for generation, size in enumerate(sizes):
        least, most = bounds(system.compiled, generation)
        assert least <= size <= most


def test_a_stochastic_word_that_is_too_large_in_any_case_is_refused_at_once():
    system = LSystem.parse("axiom: F\nF -(0.5)-> FF\nF -(0.5)-> FFF")
    with pytest.raises(ShapeError, match="at most 20,000,000 modules, but 40 make at least 1,099,511,627,776"):
        system.derive(40)


def test_chance_of_an_interpretation_alone_leaves_the_word_as_it_is():
    word = LSystem.parse("axiom: F\nF -> FF\nhomomorphism:\nF -(0.5)-> G").derive(10, 3)
    assert str(word) == "F" * 1024
    assert 1024 / 2 - 5 * 16 < word.interpreted().count("G") < 1024 / 2 + 5 * 16


def test_steps_beyond_what_is_foretold_are_derived():
    system = LSystem.parse("axiom: A\nA -> B\nB -> A")
    assert str(system.derive(3001)) == "B" and system.sizes(3000) == [1] * 3001


@given(grammars(cut=False, axial=True), st.integers(0, 6), st.sampled_from(["", "#groups 2 1 ...\n", "#groups 1 2\n"]))
def test_tables_of_productions_are_derived_alike_in_all_ways(told, at, schedule):
    lines = told.split("\n")
    rules = [k for k, line in enumerate(lines) if "->" in line]
    first = rules[min(at, len(rules) - 1)]
    told = schedule + "\n".join([*lines[:first], "group 1:", lines[first], "group 2:", *lines[first + 1 :]])
    words = []
    for text_ in (told, told + IN_ORDER):
        system = LSystem.parse(text_)
        try:
            words.append([str(system.derive(n, 5, SMALL)) for n in range(4)])
        except ShapeError:
            words.append(None)
    assert words[0] == words[1]


def test_births_in_a_pool_are_those_derived_step_by_step():
    told = "#ignore F + -\naxiom: F1F1F1\n0 < 0 > 1 -> 1[+F1F1]\n0 < 1 > 1 -> 1F1\n1 < 1 > 1 -> 0\n+ -> -"
    word, ordered = (LSystem.parse(text_).derive(8) for text_ in (told, told + IN_ORDER))
    assert strategy(word.tables) == "pool" and strategy(ordered.tables) == "in order"
    assert word.births.tolist() == ordered.births.tolist()


@pytest.mark.parametrize(
    ("word", "rule", "wanted"),
    [
        ("A[I[E]H]HB[C[E]D]D", "A[I]H < B -> X", "A[I[E]H]HX[C[E]D]D"),  # test_matching_future.lpy of L-Py
        ("A[B]C", "A[B] < C -> X", "A[B]X"),
        ("A[D]C", "A[B] < C -> X", "A[D]C"),
        ("A[BD]C", "A[BD] < C -> X", "A[BD]X"),
        ("A[B]C", "A[BD] < C -> X", "A[B]C"),
        ("A[D][B]C", "A[D][B] < C -> X", "A[D][B]X"),
        ("A[D][B]C", "A[B] < C -> X", "A[D][B]C"),  # the first pair is the first branch
        ("A[B][C]", "A[B] < C -> X", "A[B][X]"),  # a left context steps out of its branch
        ("A[B]CA[B]DC", "A[B] < C -> X", "A[B]XA[B]DC"),
        ("A[B[E]F]DC", "A[B[E]F]D < C -> X", "A[B[E]F]DX"),
        ("A[B[D]F]DC", "A[B[E]F]D < C -> X", "A[B[D]F]DC"),
        ("A(1)[B(2)]C(3)", "A(x)[B(y)] < C(z) > * -> X(x,y,z)", "A(1)[B(2)]X(1,2,3)"),
        ("E[D]A[B]CG", "E[D]A[B] < C > G : 1 < 2 -> X", "E[D]A[B]XG"),
    ],
)
def test_brackets_in_a_left_context_hold_what_a_branch_begins_with(word, rule, wanted):
    rule = rule.replace(" > *", "")
    assert str(LSystem.parse(f"axiom: {word}\n{rule}").derive(1)) == wanted

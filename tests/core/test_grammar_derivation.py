# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Words derived by arrays are those that reading from left to right derives, for any grammar."""

import pytest
import sequential_deriver
from grammar_inputs import grammars
from hypothesis import example, given, settings
from sequential_deriver import text

from sweep_addon.core.grammars import Budget, LSystem
from sweep_addon.core.parameters import ShapeError

SMALL = Budget(modules=2000)
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
@settings(max_examples=300)
@example("axiom: ABC[DE][SG[HI[JK]L]MNO]\nBC < S > G[H]M -> T")
@example("axiom: A[[B]C[D]]E\nA < B -> X\nA < D -> Y\nA < E -> Z\nA > [C] -> Q")
@example("axiom: A[B%C[D]E]F%G\nB -> BB\nC < D -> %")
def test_any_grammar_derives_the_words_of_the_reference(told):
    same_words(told, seed=3)


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

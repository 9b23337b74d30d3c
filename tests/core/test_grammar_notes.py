# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a grammar says and never does is told, and not refused."""

import pytest
from test_grammar_conformance import ENTRIES, text

from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.grammars import GrammarError, LSystem
from sweep_addon.core.grammars.deriving.describing import described
from sweep_addon.core.grammars.deriving.noting import notes
from sweep_addon.core.shapes.plant import Plant


@pytest.mark.parametrize(
    ("told", "said"),
    [
        ("axiom: A\nA -> AB\nA -> BA", ["Line 3: A is replaced by line 2 first, always; where chance"]),
        ("axiom: A(1)\nA(x) -> B\nA(x) : x > 1 -> C", ["Line 3: A(x) is replaced by line 2 first, always; what holds"]),
        ("axiom: A\nA -> B\nA -(0.5)-> C\nA -(0.5)-> D", ["Line 3: A is replaced by line 2 first"]),
        ("axiom: A\nA(x) -> F(x)", ["Line 2: A(x) never occurs; A does, and has no production"]),
        ("axiom: A(1, 2)\nA(x) -> F(x)", ["Line 2: A(x) never occurs; A(...,...) does"]),
        ("axiom: {F+F", ["{ draws nothing without }"]),
        ("axiom: @Gs F @Gc F", ["@Gs draws nothing without @Ge"]),
        ("axiom: A\nA -(0.5)-> AB\nA -(0.5)-> BA", []),
        ("axiom: A(1)\nA(x) : x > 1 -> B\nA(x) -> C", []),
        ("axiom: BA\nB < A -> B\nA -> C", []),
        ("axiom: A A(1)\nA -> A(1)\nA(x) -> A", []),
        ("axiom: {A\nA -> F+F}", []),
        ("axiom: F\nX -> Y", []),
    ],
)
def test_what_never_happens_is_noted(told, said):
    found = notes(LSystem.parse(told))
    assert len(found) == len(said) and all(note.startswith(begin) for note, begin in zip(found, said, strict=True))


def test_systems_of_the_book_have_nothing_to_note():
    assert [notes(LSystem.parse(text(entry))) for entry in ENTRIES] == [[]] * len(ENTRIES)


def test_notes_are_described_and_told_with_the_mesh():
    told = "axiom: FA\nA(x) -> F(x)"
    (note,) = notes(LSystem.parse(told))
    assert f"note: {note}" in described(LSystem.parse(told))
    assert Plant(told).mesh().told == (note,)
    assert Plant("axiom: F").mesh().told == ()


def test_a_word_that_draws_nothing_says_so():
    (note,) = Plant("axiom: A\nA -> AB", generations=3).mesh().told
    assert note.startswith("The word draws nothing: segments are F and G")
    for drawing in ("F", "{f+f+f}", "~A"):
        assert not any("draws nothing" in note for note in Plant(f"axiom: {drawing}").mesh().told)


@pytest.mark.parametrize(("width", "told"), [(10, True), (0.1, False)])
def test_diameters_in_other_units_than_lengths_are_noticed(width, told):
    """Figure 2.6 b as printed: a trunk of ten, where the first length is 1 and all of them add up to ten."""
    text = f"axiom: A(1,{width})\nA(l,w) -> !(w)F(l)[&(45)A(l*0.9,w*0.707)]/(137.5)A(l*0.9,w*0.707)"
    said = Plant(text, generations=10).mesh().told
    assert any(note.startswith("Tubes are up to 10 m thick in a figure of ") for note in said) == told
    assert bool(said) == told


def test_what_is_wrong_with_a_statement_is_told_once():
    with pytest.raises(GrammarError) as refusal:
        LSystem.parse("axiom: F\nstart: n := 1")
    assert len(refusal.value.problems) == 1


def test_a_number_of_segments_is_refused_by_the_module_that_says_it():
    with pytest.raises(ShapeError, match="@Ge: must ask for 1 to 1000 segments, got -3"):
        LSystem.parse("axiom: @Gs F @Gc F @Ge(-3)").derive(0).figure()


@pytest.mark.parametrize("context", ["", "G < "])
def test_a_number_that_is_none_is_told_with_its_module_and_step(context):
    """x is 2, 1, 0 in the words of steps 0, 1, 2: the third step divides by 0."""
    system = LSystem.parse(f"axiom: G F(2)\n{context}F(x) -> F(x-1+0/x)")
    with pytest.raises(ShapeError, match=r"line 2: parameter 1 of F .* got nan for F\(0\) in step 3$"):
        system.derive(4)

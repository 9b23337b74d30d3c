# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grammars that mean harm, or that somebody has half typed: a word and a figure of them, or a refusal, and soon."""

import time
import tracemalloc

import numpy as np
import pytest
from conftest import FULL
from hypothesis import given, settings
from hypothesis import strategies as st
from test_grammar_conformance import ENTRIES, text
from test_grammar_dialects import FASS, LEAF
from test_grammar_language import WHOLE

from sweep_addon import presets
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.grammars import Budget, GrammarError, LSystem
from sweep_addon.core.grammars.deriving.neighbours import Neighbours
from sweep_addon.core.grammars.deriving.tables import CLOSES, OPENS, SEEN

OFFERED = [str(presets.shape(preset.name).system) for preset in presets.PRESETS if preset.group == presets.GROWN]
SMALL = Budget(modules=5000, bytes=5_000_000, seconds=1)
SECONDS = 10.0  # of processor time: a text that hangs, not one that a busy machine reads slowly; the slowest takes one
MOMENT = 2.0  # beyond a budget: ten times what the longest takes between two looks at the clock
LARGEST = 20.0 if FULL else 5.0  # for a text as large as one may be, or a quarter of it: the slowest takes two
MANY = settings(max_examples=(10 if FULL else 4) * settings().max_examples)
PIECES = (
    "axiom: |#define a |#names |#ignore |#consider |#angle |#groups |#tropism |#dialect cpfg|#dialect fractint|group 2:"
    "|decomposition:|homomorphism:|maximum depth: |-(0.5)->|->|-->| : | < | > |[|]|(|)|{|}|.|,|*|&&|ran(|nran(1,|if("
    "|A(x)|A|B(x,y)|x|y|F|F(1)|f|G|+|-|&|^|\\|/|$|!|'|~|%|?P(x,y,z)|@Gs|@Ge|0|1|2|0.5|1e308|1e-308|/0|\0"
    "|start: n = 1|start each: n = n+1|end: n = 2|n|lsystem 1:|?(1,2)|?E(x)|@Gc(3)|@Gt(1,2)|@Sl(2)|@Sa(x)|#heading y"
    "|#names Fl, leaf|Fl|leaf|->(0.5)|/*|*/|→|−|ε|* < |\n|\n|\n| |Ω|\ud800"
)


def some(most):
    """How much of what a text may have: a quarter shows as well as all of it whether time grows by the square."""
    return most if FULL else most // 4


def drawn(told):
    """All that comes of a text, within the budget; or nothing, where the text is refused."""
    started = time.process_time()
    try:
        word = LSystem.parse(told).derive(3, budget=SMALL)
        figure = word.figure(budget=SMALL)
        mesh = figure.mesh(sides=3)
    except ShapeError as refusal:
        assert str(refusal) and len(str(refusal)) < 20_000 and "Traceback" not in str(refusal)
        return
    assert len(word) <= SMALL.modules and isinstance(str(word), str)
    assert figure.bounds.shape == (2, 3) and figure.at.shape == (3,) and mesh.vertices.shape[1] == 3
    assert len(figure.order) == len(figure.axes) == len(figure.width) == len(figure.colour) == len(figure)
    assert sum(len(organ.place) for organ in figure.organs) <= len(word)
    assert all(len(polygon) > 2 for polygon in figure.polygons)
    assert time.process_time() - started < SECONDS


@MANY
@given(st.lists(st.sampled_from(PIECES.split("|")) | st.text(max_size=2), max_size=60).map("".join))
def test_any_pieces_are_a_grammar_or_refused(told):
    drawn(told if "axiom:" in told else f"axiom: A F\n{told}")


@MANY
@given(st.sampled_from([*map(text, ENTRIES), *OFFERED, WHOLE, LEAF, FASS]), st.data())
def test_any_mutation_of_a_grammar_is_one_or_refused(told, data):
    for _ in range(data.draw(st.integers(1, 6))):
        at, to = sorted(data.draw(st.tuples(*[st.integers(0, len(told))] * 2)))
        new = data.draw(st.sampled_from(PIECES.split("|")))
        change = data.draw(st.integers(0, 3))
        if change == 0:  # a piece comes in
            told = told[:at] + new + told[at:]
        elif change == 1:  # a few letters go
            told = told[:at] + told[at + data.draw(st.integers(1, 5)) :]
        elif change == 2:  # a letter becomes a piece
            told = told[:at] + new + told[at + 1 :]
        else:  # a part is there twice
            told = told[:to] + told[at : at + 200] + told[to:]
    drawn(told)


NAMES = "#names " + " ".join(f"nm{k}" for k in range(10_000)) + "\n"


@pytest.mark.thorough
@pytest.mark.parametrize(
    "told",
    [
        f"{NAMES}axiom: {'nm1 nm9999 F' * some(10_000)}",
        f"{NAMES}#ignore {' '.join(f'nm{k}' for k in range(10_000))}\naxiom: nm1\nnm1 < nm2 -> nm3",
        "#names "
        + " ".join("a" * 40 + str(k) for k in range(some(9999)))
        + "\naxiom: "
        + ("a" * 60 + " ") * some(5000),
        "#names " + " ".join("a" * k for k in range(2, 65)) + " " + "a" * 63 + "b\naxiom: " + ("a" * 62 + "c") * 8000,
        "\n".join(f"#define a{k} a{k + 1}" for k in range(some(10_000))) + f"\n#define a{some(10_000)} 1\naxiom: A(a0)",
        "#define a0 1\n"
        + "\n".join(f"#define a{k + 1} a{k}" for k in range(some(10_000)))
        + f"\naxiom: A(a{some(10_000)})",
        "\n".join(f"#define a{k} a{(k + 1) % some(10_000)}" for k in range(some(10_000))) + "\naxiom: A(a0)",
        "\n".join(f"#define a{k} 1" for k in range(some(9000))) + "\naxiom: A" + "\nA(x) -> A(x+a7)" * some(9000),
        "\n".join(f"#define a{k} 1" for k in range(some(9000))) + "\naxiom: A" + "\nA(x) -> A(q)" * some(9000),
        "axiom: A" + "\nF -> [(" * some(19_000),
        "axiom: A\n" + ",".join(f"a{k}" for k in range(some(100_000))).join(("A(", ") -> B")),
        "axiom: A\n" + "".join(f"A(a{k})" for k in range(some(50_000))) + " < A > B -> C",
        "axiom: A\nA -> B" + "\ngroup 1:\nA -> C" * some(9000),
        "axiom: A\nA > B -(0.00001)-> B" * some(9000),
        "axiom: F\nF" + "->F" * some(300_000),
        "axiom: F\nF -" + "(" * 400_000 + "1" + ")" * 400_000 + "-> F",
        "axiom: F\nn=5" + " " * 900_000 + "x",
        "axiom: F" + "(1)F" * some(200_000),
        "axiom: F" + " " * 900_000 + "F",
        "\r" * 900_000,
        "\n" * 10_000_000,
        "x" * 10_000_000,
    ],
    ids=range(22),
)
def test_no_text_takes_long_to_read(told):
    started = time.process_time()
    try:
        LSystem.parse(told).compiled  # noqa: B018 as a derivation does first
    except ShapeError as refusal:
        assert len(str(refusal)) < 20_000
    assert time.process_time() - started < LARGEST


@pytest.mark.parametrize("given", [{"a": "1"}, {"a": None}, {"a": 10**400}, {"a": 1e999}, {"a": [1]}, [1], {1: 2}])
def test_only_finite_numbers_stand_for_constants(given):
    with pytest.raises(ShapeError, match="^constants: must|^constants.1: is no constant"):
        LSystem.parse("#define a 1\naxiom: A(a)", given)


@pytest.mark.parametrize("told", ["axiom: F\ud800F", "#names \udcff\naxiom: F", "axiom: \u202eF\x7f\x9b"])
def test_what_cannot_be_printed_is_refused_in_print(told):
    with pytest.raises(GrammarError) as refusal:
        LSystem.parse(told)
    assert str(refusal.value).encode() and str(refusal.value).replace("\n", "").isprintable()


RUNAWAY = {  # text, generations
    "10^12 modules": ("axiom: F\nF -> FFFFFFFFFF", 12),
    "10^12 modules at least": ("axiom: F\nF -(0.5)-> FFFFFFFFFF\nF -(0.5)-> FFFFFFFFFFF", 12),
    "10^12 modules by conditions": ("axiom: F(1)\nF(x) : x > 0 -> F(x)F(x)F(x)F(x)F(x)F(x)F(x)F(x)F(x)F(x)", 12),
    "10^12 modules by contexts": ("axiom: AF\nA < F -> FFFFFFFFFF\nF < F -> FFFFFFFFFF", 12),
    "no growth": ("axiom: AB\nA -> B\nB -> A", 10**6),
    "no growth, parameters": ("axiom: A(1)B\nA(x) -> A(x+1)\nB -> B", 10**6),
    "no growth, contexts": ("axiom: AB\nA < B -> A\nB > A -> B", 10**6),
    "no growth, in order": ("axiom: AB%\nA < B -> A\nB > A -> B", 10**6),
    "erased": ("axiom: A(1)\nA(x) -> B(x)A(x+1)\nB(x) -> *", 10**6),
    "erased by the hundred thousand": (f"axiom: A\nA -(0.5)-> {'B' * some(100_000)}A\nB -> *", 1000),
    "in a pool": ("axiom: CA\nC < A -> " + "[B]" * 600 + "A\nB > C -> B\nB -> C", 1000),
    "long words by contexts": ("axiom: CA\nC < A -> " + "[B]" * 10_000 + "A\nB > C -> B\nB -> C", 1000),
    "erased, copied words": (f"axiom: A\nA -> {'B' * some(400_000)}A\nB -> *", 1000),
    "alive for good": ("axiom: A(1)\nA(x) : x > 0 -(0.5)-> B(x)A(x+1)\nB(x) -> B(x+1)", 20_000),
    "left-recursive": ("axiom: A\ndecomposition:\nA -> AF", 2),
    "left-recursive growth": ("axiom: A\ndecomposition:\nA -> AA", 2),
    "a chain of thousands": (NAMES + "axiom: nm0" + "".join(f"\nnm{k} -> nm{k + 1}" for k in range(some(9999))), 10**4),
    "numbers drawn": (f"axiom: {'A' * some(100_000)}\nA -> B({'+'.join(['ran(1)'] * 200)})A", 3),
    "contexts of thousands": (f"axiom: {'A' * 5000}\n{'A' * 2000} < A > {'A' * 2000} -> B", 2),
    "many long contexts": ("axiom: " + "A" * 5000 + f"\n{'A' * 500} < A > {'A' * 500} -> B" * some(400), 2),
    "thousands of branches": (f"axiom: A{'[B]' * 5000}\nA > {'[B]' * 3000} -> C", 2),
    "thousands of groups": ("axiom: A\nA -> B" + "".join(f"\ngroup {k}:\nA -> AB" for k in range(1, some(9999))), 1000),
    "thousands of conditions": (f"axiom: {'A(1)' * 50_000}" + "\nA(x) : x > 1 -> B" * some(5000), 1),
    "a long word for long": ("axiom: " + "A(1)" * some(200_000) + "\nA(x) -> A(x+1)", 10**6),
    "32 parameters": (
        "axiom: A({0})\nA({1}) -> A({1})A({1})".format(*[",".join(f"{s}1{k}" for k in range(32)) for s in ("", "x")]),
        18,
    ),
    "divided by zero": ("axiom: A(1)\nA(x) -> A(1/(x-1))", 2),
    "infinite": ("axiom: A(9)\nA(x) -> A(x^9)", 20),
}


@pytest.mark.thorough
@pytest.mark.parametrize("name", RUNAWAY)
def test_a_runaway_derivation_is_stopped_in_time_and_memory(name):
    """Arrays of formulas and of contexts come on top of the budget, and what is a fixed number of blocks of them."""
    told, generations = RUNAWAY[name]
    budget = Budget(modules=1_000_000, bytes=20_000_000, seconds=0.5 if FULL else 0.1)
    system = LSystem.parse(told)
    system.compiled  # noqa: B018 whose time is that of the text
    for measured in (0, 1):
        started = time.process_time()
        if measured:
            tracemalloc.start()
        try:
            assert len(system.derive(generations, budget=budget)) <= budget.modules
        except ShapeError as refusal:
            assert len(str(refusal)) < 1000
        if not measured:
            assert time.process_time() - started < budget.seconds + MOMENT
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 4 * budget.bytes


@pytest.mark.parametrize("word", ["[B]", "BBB", "[[B]]"])
def test_who_stands_beside_whom_takes_less_than_64_bytes_a_module(word):
    """Seven arrays of 32 bits that stay, and what sorting takes meanwhile."""
    kind = np.tile(np.array([{"[": OPENS, "]": CLOSES, "B": SEEN}[letter] for letter in word], dtype=np.uint8), 50_000)
    tracemalloc.start()
    Neighbours(kind)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 64 * len(kind)


@pytest.mark.parametrize(
    ("told", "sentence"),
    [
        (RUNAWAY["10^12 modules"][0], "12 make 1,000,000,000,000"),
        (RUNAWAY["10^12 modules at least"][0], "12 make at least 1,000,000,000,000"),
        (RUNAWAY["10^12 modules by conditions"][0], "generation 7 has 10,000,000"),
        (RUNAWAY["10^12 modules by contexts"][0], "generation 6 has 1,000,001"),
    ],
)
def test_runaway_growth_is_refused_with_its_size_before_it_is_made(told, sentence):
    """Foretold where it is exact, and counted where it is only bounded: nothing is made that is too large."""
    system = LSystem.parse(told)
    started = time.process_time()
    with pytest.raises(ShapeError, match=sentence):
        system.derive(12, budget=Budget(modules=1_000_000))
    assert time.process_time() - started < SECONDS


class StoppedError(Exception):
    """What a progress raises to stop."""


@pytest.mark.thorough
@pytest.mark.parametrize(
    "told", [RUNAWAY["thousands of conditions"][0], "axiom: " + "A" * 100_000 + "\nB < A -> B" * some(9000)]
)
def test_one_long_generation_can_be_stopped(told):
    system, asked = LSystem.parse(told), []

    def stop(part):
        asked.append(part)
        raise StoppedError

    with pytest.raises(StoppedError):
        system.derive(1, progress=stop, budget=Budget(seconds=20))
    assert asked == [0]


def test_chances_of_a_group_are_its_own():
    """They are tried before those of every step, with which they do not sum."""
    told = "axiom: AB\nA -(0.7)-> X\nA -(0.3)-> Y\nB -> C\ngroup 1:\nA -(0.6)-> Z"
    words = {str(LSystem.parse(told).derive(1, seed)) for seed in range(40)}
    assert words == {"AC", "ZC"}


DRAWN = {
    "a length": "axiom: F(1e308)F(1e308)",
    "many lengths": "axiom: A\nA -> F(ran(1e308))A",
    "a step": "#step 1e308\naxiom: FFF",
    "a turn": "axiom: F+(1e308)F",
    "a turn in space": "axiom: F&(1e308)F",
    "a width": "axiom: !(1e308)F",
    "a default width": "#width 1e308\naxiom: F",
}


@pytest.mark.parametrize("name", DRAWN)
def test_what_no_figure_can_be_drawn_of_is_refused(name):
    word = LSystem.parse(DRAWN[name]).derive(5)
    with np.errstate(all="raise"), pytest.raises(ShapeError, match=r"figure: must .* at most 1e\+12 (m|degrees)"):
        word.figure().mesh()


@pytest.mark.parametrize(
    "told",
    [
        "#tropism 1e-320 0 0 1\naxiom: F&F[$F]F",
        "#tropism 1e308 1e308 -1e308 1e308\naxiom: F&F[$F]F",
        "#angle 999999999999\naxiom: F+F&F$F",
        "axiom: !(-1)F(-1)F(0)+F!(0)F",
        "axiom: }}F{F+F}F{F.F+F{F+F{{{{",
        "axiom: {[F+F+F]}{}[{F]F}F{f+f+f+f}~~~F~",
        "axiom: F(1e-320)F!(1e-320)F",
        "axiom: " + "[&" * 3000 + "F" + "]" * 3000,
        "axiom: " + "F&(1)$" * 3000,
    ],
    ids=range(9),
)
def test_what_is_drawn_is_finite(told):
    figure = LSystem.parse(told).derive(0).figure()
    mesh = figure.mesh(sides=3)
    assert np.isfinite(mesh.vertices).all() and np.isfinite(figure.axes).all() and np.isfinite(figure.bounds).all()
    assert all(np.isfinite(value).all() for value in mesh.attributes.values())
    assert (figure.width >= 0).all()


@pytest.mark.thorough
@pytest.mark.parametrize(
    "told",
    [
        "axiom: " + "{F+F+F}" * some(20_000),
        "axiom: " + "{" * some(60_000) + "F+F+F" + "}" * some(60_000),
        "axiom: " + "[F&" * some(30_000) + "F$" + "]" * some(30_000),
        "axiom: " + "F&$" * some(20_000),
        NAMES + "axiom: " + "".join(f"~nm{k} F" for k in range(some(9000))),
        "axiom: " + "@Gs f[+" * some(10_000) + "@Ge f]" * some(10_000),
        "axiom: " + "?(1,0.9)F" * some(20_000) + "$" * some(20_000) + "\nlsystem 1:\nF -> F",
    ],
    ids=["polygons", "polygons in polygons", "a nest", "a path", "organs", "curves in branches", "systems in systems"],
)
def test_no_word_takes_long_to_draw(told):
    word = LSystem.parse(told).derive(0)
    started = time.process_time()
    figure = word.figure()
    assert len(figure.order) == len(figure.axes) and figure.mesh(sides=3).vertices.shape[1] == 3
    assert all(map(len, figure.polygons)) and all(len(organ.at) for organ in figure.organs)
    assert time.process_time() - started < LARGEST


def test_figures_and_their_meshes_keep_a_budget():
    word = LSystem.parse("axiom: F\nF -> F+F[&F]").derive(9)
    for bytes_ in (100_000, 1_000_000, 10_000_000, 100_000_000):
        budget = Budget(bytes=bytes_)
        tracemalloc.start()
        try:
            word.figure(budget=budget).mesh(budget=budget)
        except ShapeError as refusal:
            assert f"must take at most {bytes_:,} bytes, but needs about" in str(refusal)
        else:
            assert bytes_ >= 10_000_000
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        assert peak < 2 * bytes_

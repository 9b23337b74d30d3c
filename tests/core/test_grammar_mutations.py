# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Half-typed texts of every dialect and construct: what is read is written and read again as it was, or refused."""

import time

import pytest
from hypothesis import given
from hypothesis import strategies as st
from test_grammar_dialects import FASS, HOUDINI, LEAF, LPY, MACROS
from test_grammar_hostile import LARGEST, MANY, SMALL, drawn, some
from test_grammar_queries import SQUARE
from test_grammar_statements import CPFG as STATED
from test_grammar_statements import RACEME
from test_grammar_subsystems import CPFG as NESTED
from test_grammar_subsystems import FLOWERING

from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.grammars import LSystem

CURVED = """axiom: !(0.2) @Gs A(0.2)
A(w) -> f(1) !(w*0.7) @Gc(6) [+ f(1) !(w*0.3) @Gt(1,2) @Ge(6)] - A(w*0.7)
A[B(x)]C < D > E[F] -> @Sl(0.5) @Sa(2) @Sw(3) F
"""
TEXTS = [FASS, LEAF, MACROS, HOUDINI, LPY, RACEME, STATED, FLOWERING, NESTED, SQUARE, CURVED]
PIECES = (
    """( ) [ ] { } : ; = --> -> < > * ? $ @ # " ' % ~ ! _ , ^ 0 1 1e9 -1 x é \0 ?P(x) ?E(x,y) @Gc(3) @Ge @Sl(0)
@Sa(2) ?(2,0) ?(2,0.5) f(1) produce {x=x*2;} /* //""".split()
    + [
        *(
            "\n",
            "\t",
            " ",
            "\\\n",
            "start: ",
            "end each: ",
            "lsystem 2:\n",
            "lsystem: 2\n",
            "homomorphism\n",
            "premise: ",
        ),
        *("rule 1: ", "module A", "group 1:", "#define f(x) x\n", "interpretation:\n", "maximum depth: 2\n"),
    ]
)


@MANY
@given(st.sampled_from(TEXTS), st.sampled_from(TEXTS), st.data())
def test_any_mutation_of_any_dialect_is_read_and_written_or_refused(told, other, data):
    for _ in range(data.draw(st.integers(1, 6))):
        at, to = sorted(data.draw(st.tuples(*[st.integers(0, len(told))] * 2)))
        change = data.draw(st.integers(0, 3))
        if change < 2:  # a piece comes in
            told = told[:at] + data.draw(st.sampled_from(PIECES)) + told[at:]
        elif change == 2:  # a few letters go
            told = told[:at] + told[min(to, at + 8) :]
        else:  # a part of another text comes in
            start = data.draw(st.integers(0, len(other)))
            told = told[:at] + other[start : start + 60] + told[at:]
    drawn(told)
    try:
        system = LSystem.parse(told)
        again = LSystem.parse(str(system))
        assert str(again) == str(system)
        assert str(again.derive(2, budget=SMALL)) == str(system.derive(2, budget=SMALL))
    except ShapeError:
        pass


LONG = some(400_000)


@pytest.mark.thorough
@pytest.mark.parametrize(
    "told",
    [
        "#dialect houdini\npremise" + " " * LONG + "A",
        "#dialect houdini\n" + "a " * LONG + ":",
        "#dialect houdini\npremise: A\nA=" + "~" * some(100_000),
        "#dialect houdini\npremise: A\nA" + ":" * LONG + "=B",
        "#dialect lpy\ngroup" + " " * LONG + "x",
        "#dialect lpy\nmodule "
        + ", ".join(f"nm{k}" for k in range(some(9000)))
        + "\nAxiom: "
        + "nm1 x nm2249 " * some(20_000),
        "#dialect lpy\nAxiom: A\n" + "A" + "(" * LONG + " --> B",
        "#dialect lpy\nx = a" + " " * LONG + "b",
        "#dialect cpfg\nstart" + " " * LONG + "x",
        "#dialect cpfg\ntwist:" + "0" * LONG + "x",
        "#dialect cpfg\nA : {x = a" + " " * LONG + "b;} 1 --> B",
        "#dialect cpfg\n#define a " + "b " * 900 + "\n" + "A --> a a a a a a a a a a\n" * some(18_000),
        "#dialect cpfg\naxiom: A\n" + "A : {x = y + y; z = x + x; w = z + z;} 1 --> B(w)\n" * some(15_000),
        "#dialect cpfg\n" + "A" * LONG + "\n" + "\tB\n" * some(18_000),
        "#dialect cpfg\nA " + ": " * LONG + "--> B",
        "start: " + "n = 1; " * some(100_000) + "\naxiom: A",
        "axiom: A\n" + "A[B]" * some(25_000) + " < A -> B",
        "axiom: " + "?(1,2)" * some(30_000) + "F",
        "axiom: " + "?(1,2)F$$" * some(30_000),
        "axiom: @Gs" + "f@Gc(1000)" * 30_000,
        "axiom: " + "F?P(x,y)[" * some(30_000) + "]" * some(30_000),
    ],
    ids=range(21),
)
def test_no_text_of_any_dialect_takes_long(told):
    started = time.process_time()
    try:
        LSystem.parse(told).derive(1).figure()
    except ShapeError as refusal:
        assert len(str(refusal)) < 20_000
    assert time.process_time() - started < LARGEST

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts of other programs read as those of the book; what they have that is not known here is told with its line."""

import time

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
        ("#dialect cpfg\naxiom: A\n#include <x>", 3, "#define"),
        ("#dialect cpfg\naxiom: A\n#define f(x) x", 3, "a constant without parameters"),
        ("#dialect cpfg\naxiom: A\nA(x) : {y = 2;} y > 1 --> B", 3, "a condition without statements"),
        ("#dialect cpfg\naxiom: A\nA(x) --> B(sin(x))", 3, "no angles in formulas"),
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


@pytest.mark.parametrize(
    "told",
    [
        "/*" * 400_000,
        "axiom: A\nA --> " + ":" * 400_000,
        "#define a " + "a" * 200 + "\naxiom: " + "a " * 40_000,
        "/" * 900_000,
    ],
)
def test_hostile_texts_of_cpfg_are_read_or_refused_soon(told):
    started = time.process_time()
    with pytest.raises(GrammarError):
        LSystem.parse(f"#dialect cpfg\n{told}")
    assert time.process_time() - started < 5

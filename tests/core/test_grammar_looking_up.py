# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How much of a text is looked at to find names in it, and what is refused before that."""

import pytest

from sweep_addon.core.grammars import GrammarError, LSystem
from sweep_addon.core.grammars.dialects import lpy
from sweep_addon.core.grammars.dialects.pasting import DEFINED, LONGEST, Pasting
from sweep_addon.core.grammars.text.passages import Passage, PassageError
from sweep_addon.core.shapes import growing


class Sliced(str):
    """A text that counts the characters of all its slices."""

    count_of = 0

    def __getitem__(self, place):
        found = super().__getitem__(place)
        self.count_of += len(found)
        return found


def macros():
    found = Pasting()
    found.define(DEFINED.match("#define f(x) x+1"), Passage("", 1))
    return found


@pytest.mark.parametrize("times", [100, 10_000])
def test_names_of_macros_are_looked_at_and_not_the_rest_of_their_line(times):
    line = Sliced("f " * times)
    assert macros().once(line, Passage(line, 1)) == line
    assert line.count_of <= 10 * times


def test_a_line_that_is_too_long_is_refused_before_constants_are_pasted(monkeypatch):
    monkeypatch.setattr(Pasting, "once", None)
    with pytest.raises(PassageError, match=f"at most {LONGEST} characters"):
        macros().pasted("A" * (LONGEST + 1), Passage("", 1))
    assert Pasting().pasted("A" * (LONGEST + 1), Passage("", 1)) == "A" * (LONGEST + 1)  # nothing is pasted


def test_names_of_lpy_are_the_longest_that_are_declared_and_found_with_one_slice():
    declared = ["a" * count for count in range(2, 65, 3)] + ["a" * 9 + "b", "Interpolate", "Int"]
    reader = lpy.Reader([f"module {', '.join(declared)}"])
    for told in ("a" * 70, "a" * 9 + "b" + "a", "aab", "b", "Inte", "Interpolated", "InterpolateColorsX", "Scaled"):
        known = {*declared, *lpy.NAMES, *lpy.OTHERS}
        whole = Sliced(told)
        assert reader.named(whole, 0) == max(
            (name for name in known if told.startswith(name)), key=len, default=told[0]
        )
        assert whole.count_of <= lpy.LONGEST_NAME + 3


def test_a_name_that_lpy_takes_for_a_module_without_a_line_is_spelled_as_no_other():
    """There G draws nothing; here it does, so it is called otherwise, and not as a module that is declared."""
    told = "#dialect lpy\nmodule G_\nAxiom: G G_\nproduction:\nG --> F"
    system = LSystem.parse(told)
    assert str(system.derive(1)) == "FG_" and len(system.derive(0).figure()) == 0
    assert str(LSystem.parse(told.replace("G_", "G_, G__, Fl, Fl_", 1)).derive(1)) == "FG_"
    assert str(LSystem.parse("#dialect lpy\nAxiom: G G\nG --> F G").derive(1)) == "FG_FG_"


@pytest.mark.parametrize(("digits", "refused"), [("9" * 5000, True), ("1", True), ("0" * 5000, False), ("", False)])
def test_groups_of_lpy_have_any_number_of_digits(digits, refused):
    told = f"#dialect lpy\nAxiom: F\ngroup {digits}:"
    assert [problem.line for problem in growing.problems(told)] == [3] * refused


@pytest.mark.parametrize(
    ("told", "line", "column", "sentence"),
    [
        ("axiom: F\r\n" + "x" * 1_000_000, 2, 999_991, "at most 1,000,000 characters in 20,000 lines"),
        ("x" * 10_000_000, 1, 1_000_001, "at most 1,000,000 characters in 20,000 lines"),
        ("axiom: F\n" * 20_001, 20_001, 1, "at most 1,000,000 characters in 20,000 lines, found 180,009 in 20,002"),
        ("\r\n" * 400_000, 20_001, 1, "at most 1,000,000 characters in 20,000 lines"),
        ("axiom: F\n" + "".join(f"start: v{k} = 1\n" for k in range(1001)), 1002, 1, "at most 1,000 variables"),
        ("axiom: F\n" + "".join(f"#names v{k}\n" for k in range(10_001)), 10_002, 8, "at most 10,000 names"),
    ],
)
def test_what_there_is_too_much_of_is_told_with_its_line_as_all_problems_are(told, line, column, sentence):
    """So that the sidebar, which shows the problems of any text, has them."""
    with pytest.raises(GrammarError, match=sentence) as refusal:
        LSystem.parse(told)
    assert [(problem.line, problem.column) for problem in refusal.value.problems] == [(line, column)]
    assert growing.problems(told) == refusal.value.problems and len(str(refusal.value)) < 500

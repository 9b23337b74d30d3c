# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sub-systems: parts of a word with productions and a scale of their own."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.grammars import GrammarError, LSystem
from sweep_addon.core.grammars.deriving.describing import described
from sweep_addon.core.grammars.deriving.subsystems import Regions

FLOWERING = """
#names internode
axiom: A(0)
A(t) : t < 2 -> internode [+(45) ?(2, 0.5) A(0) $] A(t+1)
A(t) : t >= 2 -> ?(3) K $
lsystem 2:
A(x) -> internode L A(x+1)
lsystem 3:
K -> { K }
homomorphism:
internode -> F(1)
"""


def test_modules_develop_by_the_productions_of_their_own_system():
    words = [str(LSystem.parse(FLOWERING).derive(n)).replace("internode", "i") for n in range(4)]
    assert words[:3] == [
        "A(0)",
        "i[+(45)?(2,0.5)A(0)$]A(1)",
        "i[+(45)?(2,0.5)iLA(1)$]i[+(45)?(2,0.5)A(0)$]A(2)",
    ]
    assert words[3] == "i[+(45)?(2,0.5)iLiLA(2)$]i[+(45)?(2,0.5)iLA(1)$]?(3)K$"
    assert str(LSystem.parse(FLOWERING).derive(5)).endswith("?(3){{K}}$")


def test_sub_systems_stand_in_each_other_and_none_is_known_by_another():
    told = "axiom: A?(1)A?(2)A$A?(7)A$$A$A\nA -> a\nlsystem 1:\nA -> b\nlsystem 2:\nA -> c"
    assert str(LSystem.parse(told).derive(1)) == "a?(1)b?(2)c$b?(7)A$$a$a"  # nobody replaces what is in system 7


def test_contexts_see_across_the_bounds_of_sub_systems():
    told = "#ignore ? $\naxiom: A?(1)A A$A\nA < A > A -> X\nlsystem 1:\nA < A > A -> Y"
    assert str(LSystem.parse(told).derive(1)) == "A?(1)YY$A"


def test_what_is_drawn_is_scaled_and_the_turtle_goes_on_from_there():
    """cpfg scales lengths that are said too, and widths, until the sub-system ends."""
    word = LSystem.parse("#step 2\n#width 0.4\naxiom: F?(2,0.5)F F(3)!(1)F?(2,0.1)F~K(2)$F$F").derive(0)
    figure = word.figure()
    assert (figure.end - figure.start)[:, 0].tolist() == pytest.approx([2, 1, 1.5, 1, 0.1, 1, 2], rel=1e-15)
    assert figure.width.tolist() == pytest.approx([0.4, 0.2, 0.2, 0.5, 0.05, 0.5, 1.0], rel=1e-15)
    assert figure.organs[0].scale.tolist() == pytest.approx([0.1], rel=1e-15)


def test_a_dollar_that_ends_no_sub_system_rolls_the_turtle_level():
    """The left of a turtle that has rolled is level again behind it: ABOP section 1.5.3."""
    told = "axiom: &(30)?(1,1)/(40)F$ F $ F"
    axes = LSystem.parse(told).derive(0).figure(upright=True).axes
    assert axes[1, 1, 2] == pytest.approx(axes[0, 1, 2]) and abs(axes[0, 1, 2]) > 0.1 and abs(axes[2, 1, 2]) < 1e-12


def test_chance_and_decomposition_reach_into_sub_systems():
    told = "axiom: ?(1)A A A A A A A A$\nlsystem 1:\nA -(0.5)-> B\nA -(0.5)-> C\ndecomposition:\nB -> DD"
    word = LSystem.parse(told).derive(1)
    assert word.count("D") == 2 * (8 - word.count("C")) and 0 < word.count("C") < 8


def test_sub_systems_are_written_and_read_again():
    system = LSystem.parse(FLOWERING)
    assert "lsystem 2:" in str(system).splitlines() and str(LSystem.parse(str(system))) == str(system)
    assert "sub-systems: 2, 3" in described(system)


@given(st.lists(st.sampled_from(["?(1)", "?(2,3)", "$", "F", "[", "]"]), max_size=30))
def test_each_module_is_in_the_innermost_sub_system_that_is_begun_before_it(parts):
    depth, kept = 0, []
    for part in parts:  # brackets in pairs
        depth += (part == "[") - (part == "]")
        if depth < 0:
            depth = 0
            continue
        kept.append(part)
    kept += ["]"] * depth
    word = LSystem.parse(f"axiom: ?(1)?(2,3)$${''.join(kept)}").derive(0)
    parts, stack, wanted, scales = ["?(1)", "?(2,3)", "$", "$", *kept], [], [], []
    for place, part in enumerate(parts):
        if part[0] == "?":
            stack.append(place)
        wanted.append(stack[-1] if stack else -1)
        scales.append(3.0 ** sum(parts[at] == "?(2,3)" for at in stack[: len(stack) - (part == "$")]))
        if part == "$" and stack:
            stack.pop()
    regions = Regions(word.tables, word.state)
    assert regions.opener.tolist() == wanted
    assert regions.scales() == pytest.approx(np.array(scales), rel=1e-12)


@pytest.mark.parametrize("scale", ["0", "-1"])
def test_scales_are_positive(scale):
    with pytest.raises(ShapeError, match="must have a positive scale"):
        LSystem.parse(f"axiom: ?(1,{scale})F$").derive(0).figure()


def test_what_begins_a_sub_system_is_not_replaced():
    with pytest.raises(GrammarError, match="what begins a sub-system stays"):
        LSystem.parse("axiom: A\n?(x) -> A")


CPFG = """#dialect cpfg
#define SPIKE ?(2,0.5)S(1)$
lsystem: 1
derivation length: 3
axiom: A(2)
A(n) : n > 0 --> F(1)[+(30)SPIKE]A(n-1)
endlsystem
lsystem: 2
axiom: S(1)
S(t) --> F(1)S(t+1)
endlsystem
"""


def test_sub_systems_of_cpfg_are_read():
    system = LSystem.parse(CPFG)
    assert str(system.derive()) == "F(1)[+(30)?(2,0.5)F(1)F(1)S(3)$]F(1)[+(30)?(2,0.5)F(1)S(2)$]A(0)"
    assert (system.derive().figure().end - system.derive().figure().start)[1] @ np.ones(3) == pytest.approx(
        0.5 * (np.cos(np.pi / 6) + 0.5)
    )


@pytest.mark.parametrize("line", ["homomorphism", "decomposition", "ignore: F", "start: {n=1;}", "seed: 3"])
def test_what_sub_systems_of_cpfg_have_that_is_not_known_is_told(line):
    with pytest.raises(GrammarError) as refusal:
        LSystem.parse(CPFG.replace("S(t) -->", f"{line}\nS(t) -->"))
    assert refusal.value.problems[0].expected.startswith("productions of the sub-system alone")

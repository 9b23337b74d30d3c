# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Directives that need constants follow them: in the text that is written, with other constants, and in plants."""

from dataclasses import replace

import numpy as np
import pytest

import sweep_addon as sw

TEXT = (
    "#define a 20\n#angle 2*a\n#step a/10\n#width a/1000\n#generations a/10\n#tropism 0 0 -1 a/100\naxiom: F\nF -> F+F"
)
SAID = {"angle": 40.0, "step": 2.0, "width": 0.02, "generations": 2, "tropism": (0.0, 0.0, -1.0, 0.2)}


@pytest.mark.parametrize("name", SAID)
def test_a_directive_follows_its_constant(name):
    system = sw.LSystem.parse(TEXT)
    assert getattr(system, name) == SAID[name]
    twice = np.array(SAID[name]) * [1, 1, 1, 2] if name == "tropism" else 2 * SAID[name]
    for other in (
        sw.LSystem.parse(TEXT, {"a": 40}),
        system.with_constants(a=40),
        sw.LSystem.parse(str(system), {"a": 40}),
    ):
        assert getattr(other, name) == pytest.approx(twice)


def test_a_number_that_is_replaced_is_written_instead_of_its_formula():
    system = replace(sw.LSystem.parse(TEXT), angle=33.0, step=1.0)
    again = sw.LSystem.parse(str(system))
    assert (again.angle, again.step, again.width) == (33.0, 1.0, 0.02)


def test_the_last_directive_counts():
    assert sw.LSystem.parse("#define a 20\n#angle a\n#angle 5\naxiom: F").with_constants(a=40).angle == 5.0


def test_a_plant_turns_by_its_constant_whatever_its_own_number():
    plant = sw.Plant("#define a 60\n#angle a\naxiom: F+F", constants={"a": 90}, output="edges")
    wide, tall = np.ptp(plant.mesh().vertices, axis=0)[:2]  # one metre along x, and then one along y
    assert (wide, tall) == pytest.approx((1.0, 1.0))
    assert replace(plant, constants={}).angle == 60.0
    assert replace(plant, angle=10.0).angle == 90.0

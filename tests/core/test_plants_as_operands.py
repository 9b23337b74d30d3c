# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plants in sweep-CSG trees: the solid of their tubes, which overlap where branches begin, without their leaves."""

import numpy as np
import pytest

pytest.importorskip("manifold3d")

import sweep_addon as sw

# Octagonal tubes along z: one of 2 m, and a thinner one of 3 m that begins within it and leaves it.
BAR = "axiom: [!(0.2) F(2)] f(0.7) !(0.1) F(3)"
LEAF = " [f(0.3) +(120) { f(0.3) +(120) f(0.3) +(120) f(0.3) }]"
VOLUME = 2 * np.sqrt(2) * (2 * 0.1**2 + 1.7 * 0.05**2)
BLOCK = sw.solids.Block(10.0, 10.0, 10.0)  # around all of it


@pytest.mark.parametrize("text", [BAR, BAR + LEAF])
def test_tubes_count_once_and_leaves_not(text):
    plant = sw.Plant(text, upright=True)
    assert plant.united().mesh().volume() == pytest.approx(VOLUME, rel=1e-9)
    assert (plant & plant).mesh().volume() == pytest.approx(VOLUME, rel=1e-9)
    assert (BLOCK - plant).mesh().volume() == pytest.approx(1000 - VOLUME, rel=1e-9)


def test_points_are_classified_against_a_plant():
    plant = sw.Plant(BAR, upright=True)
    assert sw.classify(plant, np.array([(0, 0, 1.0), (0, 0, 3.0), (0.09, 0, 3.0)])).tolist() == [1, 1, -1]


def test_a_plant_without_tubes_is_refused_in_a_sentence():
    with pytest.raises(sw.ShapeError, match="must have tubes to be an operand"):
        BLOCK - sw.Plant(BAR, output="edges")


def test_what_is_no_set_of_points_is_no_operand():
    with pytest.raises(TypeError):
        sw.Plant(BAR) - 1

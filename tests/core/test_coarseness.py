# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A tolerance that makes a heptagon of a small bend is told, with one that does, and none that is meant is told."""

import re

import numpy as np
import pytest

from sweep_addon import presets
from sweep_addon.core.contours import Circle
from sweep_addon.core.rings.corners import Round
from sweep_addon.core.shapes.canal_surface import CanalSurface
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.shapes.pd_curve_sweep import PDCurveSweep
from sweep_addon.core.stations.coarseness import told_coarse
from sweep_addon.core.stations.sampling import Count, Tolerance, place
from sweep_addon.core.trajectories import Arc, Bezier, Helix, Line, Polyline

SPRING = Helix(radius=0.01, pitch=0.002, turns=5)
WIRE = Circle(0.0005)
TOLD = re.compile(r"Samples: the path turns by (\d+) degrees between two of them; a chord of about (\S+) mm")


def coarse(mesh):
    return [sentence for sentence in mesh.told if TOLD.match(sentence)]


@pytest.mark.parametrize("samples", [Tolerance(), Tolerance(0.0009)])
@pytest.mark.parametrize(
    "shape",
    [
        lambda samples: GeneralizedCylinder(WIRE, SPRING, samples),
        lambda samples: PDCurveSweep(WIRE, SPRING, samples=samples),
        lambda samples: CanalSurface(SPRING, 0.0005, samples=samples),
    ],
    ids=["generalized cylinder", "pd-curve sweep", "canal surface"],
)
def test_a_spring_of_a_centimetre_is_told_and_the_chord_that_is_named_is_enough(shape, samples):
    """A chord c over a circle of radius r spans 2 acos(1 - c / r); with the one named a turn takes about fifty."""
    (sentence,) = coarse(shape(samples).mesh())
    degrees, chord = map(float, TOLD.match(sentence).groups())
    widest = np.degrees(2 * np.arccos(1 - samples.chord / 0.01))
    assert widest - 4 < degrees < widest + 1
    finer = Tolerance(chord / 1000)
    assert coarse(shape(finer).mesh()) == []
    assert 45 < len(place(SPRING, finer).s) / SPRING.turns < 60


@pytest.mark.parametrize(
    ("trajectory", "samples", "reach"),
    [
        (SPRING, Count(20), 0.0005),  # whoever counts has chosen
        (SPRING, Tolerance(0.001, render=0.00002), 0.0005),
        (Helix(radius=0.5), Tolerance(), 0.01),
        (Line(), Tolerance(10.0), 0.01),
        (Polyline([(0, 0, 0), (1, 0, 0), (0, 0.1, 0), (0, 1, 0)]), Tolerance(), 0.01),  # mitres
        (Polyline([(0, 0, 0), (1, 0, 0), (1, 1, 0)], corner=Round(0.003)), Tolerance(), 0.001),
        (Arc(radius=0.005, angle=3.0), Tolerance(), 0.03),  # which folds there, and is told of that
    ],
)
def test_what_is_meant_is_not_told(trajectory, samples, reach):
    assert told_coarse(place(trajectory, samples), samples, reach) == ()


def test_the_tightest_bend_of_a_large_path_is_told():
    """Handles of 3 mm turn the path back within them, and a wire of a millimetre fits."""
    turn = Bezier([(0, 0, 0), (1, 0, 0), (1, 0, 0), (2, 0, 0), (2.008, 0, 0), (2.008, 0.012, 0), (2, 0.012, 0)])
    (sentence,) = coarse(GeneralizedCylinder(WIRE, turn).mesh())
    assert 46 < float(TOLD.match(sentence)[1]) <= 60


@pytest.mark.parametrize("preset", [p.name for p in presets.PRESETS if p.group in ("", "mixed_dimension")])
def test_no_preset_is_told(preset, made_once):
    assert coarse(presets.shape(preset).mesh()) == []

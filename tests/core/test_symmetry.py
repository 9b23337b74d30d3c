# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The symmetry of a contour is the number of turns that map it to itself."""

import numpy as np
import pytest
from contour_inputs import ngon, square

from sweep_addon.core.contours import (
    Aerofoil,
    Circle,
    Ellipse,
    Outline,
    Rectangle,
    RegularPolygon,
    Section,
    Star,
    Superellipse,
)
from sweep_addon.core.contours.symmetry import turned_onto

HOLES = [ngon(24, 3.0), *(ngon(5, 0.4, *place) for place in ngon(4, 2.0))]  # the holes do not turn with their places
ROUND_HOLES = [ngon(24, 3.0), *(ngon(8, 0.4, *place) for place in ngon(4, 2.0))]
SYMMETRIES = [
    (Circle(points=7), 7),
    (Circle(points=4096), 4096),
    (Ellipse(2.0, 1.0, points=64), 2),
    (Ellipse(2.0, 1.0, points=7), 1),
    (Ellipse(1.0, 1.0, points=64), 64),
    (Rectangle(1.0, 2.0), 2),
    (Rectangle(2.0, 2.0), 4),
    (Rectangle(2.0, 2.0, 0.5), 4),
    (Rectangle(1.0, 2.0, 0.5, corner_points=5), 2),
    (RegularPolygon(6), 6),
    (RegularPolygon(5, rounding=0.2), 5),
    (Star(5), 5),
    (Superellipse(2.0, 1.0), 2),
    (Superellipse(1.0, 1.0), 4),
    (Aerofoil(), 1),
    (Aerofoil("0012"), 1),
    (Outline(), 1),
    (Outline([square(2, -1, -1)]), 4),
    (Outline([square(2, 3, 3)]), 1),
    (Outline([[(-1, 0), (1, 0)], [(-0.5, 0), (0.5, 0)]], [[1, 1], [1, 1]], tolerance=0.3), 12),
    (Outline(ROUND_HOLES), 4),
    (Outline(HOLES), 1),
]


@pytest.mark.parametrize(("contour", "turns"), SYMMETRIES, ids=lambda value: type(value).__name__)
def test_symmetry_is_the_number_of_turns(contour, turns):
    section = contour.section()
    assert section.symmetry == turns
    for more in {2, 3, 4, 5, 6, 7, 8, 64} - {n for n in range(1, turns + 1) if turns % n == 0}:
        assert turned_onto(section, more) is None


@pytest.mark.parametrize(("contour", "turns"), SYMMETRIES, ids=lambda value: type(value).__name__)
def test_a_turn_takes_every_point_and_edge_to_another(contour, turns):
    """Rotating the section by a rotation matrix gives the same points, edges and corners in another order."""
    section = contour.section()
    onto = turned_onto(section, turns)
    sine, cosine = np.sin(2 * np.pi / turns), np.cos(2 * np.pi / turns)
    turned = section.points @ np.array([(cosine, sine), (-sine, cosine)])
    assert section.points[onto] == pytest.approx(turned, abs=1e-9)
    assert sorted(onto.tolist()) == list(range(len(onto)))
    assert np.array_equal(section.following[onto], onto[section.following])
    assert np.array_equal(section.sharp[onto], section.sharp)


def test_a_corner_that_is_not_sharp_breaks_the_symmetry():
    assert Section.from_loops([square(2, -1, -1)], sharp=[[True, True, True, True]]).symmetry == 4
    assert Section.from_loops([square(2, -1, -1)], sharp=[[True, False, True, False]]).symmetry == 2

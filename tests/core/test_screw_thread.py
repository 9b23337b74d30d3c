# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A screw thread, swept, has in every axial cut the profile of ISO 68-1 and the diameters of ISO 724."""

from math import pi, sqrt

import numpy as np
import pytest
from solids import assert_solid

from sweep_addon.core.contours import Fit, ScrewThread, fitted
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.trajectories import Line

ISO_724 = {  # millimetres: pitch (coarse, ISO 261), d, d2 and d1
    "M3": (0.5, 3, 2.675, 2.459),
    "M4": (0.7, 4, 3.545, 3.242),
    "M5": (0.8, 5, 4.480, 4.134),
    "M6": (1, 6, 5.350, 4.917),
    "M8": (1.25, 8, 7.188, 6.647),
    "M10": (1.5, 10, 9.026, 8.376),
    "M12": (1.75, 12, 10.863, 10.106),
    "M16": (2, 16, 14.701, 13.835),
    "M20": (2.5, 20, 18.376, 17.294),
    "M24": (3, 24, 22.051, 20.752),
}


def swept(pitch, diameter, turns=3, hand=1, **options):
    """A thread of so many millimetres in metres, and its vertices: radius, and place along the axis in pitches."""
    thread = ScrewThread(diameter / 1000, pitch / 1000, **options)
    lead = thread.starts * thread.pitch
    mesh = GeneralizedCylinder(
        thread,
        Line(end=(0, 0, turns * lead)),
        samples={"kind": "count", "contours": 40 * turns + 1},
        twist=f"{hand} * 2*pi*s/{lead!r}",
    ).mesh()
    x, y, z = mesh.vertices.T
    place = z / lead - hand * np.arctan2(y, x) / (2 * pi)
    return mesh, 1000 * np.hypot(x, y), (thread.starts * place + 0.5) % 1 - 0.5


@pytest.mark.parametrize("size", ISO_724)
@pytest.mark.parametrize("hand", [1, -1])
def test_axial_cut_is_the_basic_profile(size, hand):
    """Flat crests of P/8, flanks that rise by 1 in tan 30 degrees, flat roots of P/4 (ISO 68-1)."""
    pitch, diameter, *_ = ISO_724[size]
    mesh, radius, place = swept(pitch, diameter, hand=hand)
    beside_crest = np.clip(np.abs(place) - 1 / 16, 0, 5 / 16)
    assert radius == pytest.approx(diameter / 2 - beside_crest * pitch / np.tan(pi / 6), abs=1e-12)
    assert_solid(mesh, euler=2)


@pytest.mark.parametrize("size", ISO_724)
def test_diameters_are_those_of_the_table(size):
    pitch, major, middle, minor = ISO_724[size]
    _, radius, place = swept(pitch, major)
    order = np.argsort(np.abs(place))
    at_pitch_diameter = np.interp(0.25, np.abs(place)[order], radius[order])  # ridge and groove are as wide there
    found = 2 * np.array([radius.max(), at_pitch_diameter, radius.min()])
    assert found.round(3).tolist() == [major, middle, minor]


def test_a_thread_of_several_starts_has_the_profile_in_each():
    mesh, radius, place = swept(2, 20, starts=3)
    assert radius == pytest.approx(10 - np.clip(np.abs(place) - 1 / 16, 0, 5 / 16) * 2 * sqrt(3), abs=1e-12)
    assert_solid(mesh, euler=2)


def test_edges_are_where_flanks_meet_crest_and_root():
    section = ScrewThread(points=16, starts=2).section()
    radii = np.hypot(*section.points[section.sharp].T)
    assert len(section.points) == 32 and section.sharp.sum() == 8
    assert np.sort(radii) == pytest.approx(np.repeat(np.array(ScrewThread().radii)[::-1], 4), rel=1e-12)


@pytest.mark.parametrize("starts", [1, 2, 5])
def test_area_is_what_many_points_enclose(starts):
    thread = ScrewThread(0.01, 0.0015, starts)
    many = ScrewThread(0.01, 0.0015, starts, points=1024)
    assert many.section().area == pytest.approx(thread.area, rel=1e-5)
    assert fitted(thread, Fit.AREA_TRUE).area == pytest.approx(thread.area, rel=1e-9)
    assert thread.section().symmetry == starts


def test_a_pitch_whose_roots_reach_the_axis_is_refused():
    sentence = "pitch: must be less than 0.00739008, or the roots reach the axis, got 0.0074"
    with pytest.raises(ShapeError, match=sentence):
        ScrewThread(0.008, 0.0074)

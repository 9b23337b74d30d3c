# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Presets are closed, quick to drag, and as large as the source that each names says.

Those of mixed dimension are not closed; what they are is in tests/core/test_mixed_dimension.py. Plane regions are flat.
Of grammars tests/test_grammar_presets.py tells.
"""

from dataclasses import replace
from math import atan, degrees, pi

import numpy as np
import pytest
from conftest import FULL

from sweep_addon import presets
from sweep_addon.batch import job
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.stations.sampling import place

ALL = [preset.name for preset in presets.PRESETS]
OPEN = ("mixed_dimension", "plane_region", "l_system")
SOLID = [preset for preset in presets.PRESETS if preset.group not in OPEN]
LONG = {"general_sweep": pytest.mark.thorough}  # presets whose meshes take seconds
MOST_VERTICES = 65_536  # Blender draws so many in a few milliseconds


def size(name):
    """The extent of a preset in millimetres along x, y and z."""
    return 1000 * np.ptp(presets.shape(name).mesh().vertices, axis=0)


def radii(name, s):
    """Distances from the x axis in millimetres of the ring that is nearest to a place on it, in metres."""
    vertices = presets.shape(name).mesh().vertices
    there = np.abs(vertices[:, 0] - s)
    return 1000 * np.hypot(*vertices[there < there.min() + 1e-9, 1:].T)


def test_presets_are_these_and_sizes_are_in_order():
    single = [preset.name for preset in presets.PRESETS if not preset.group]
    threads = [preset.title for preset in presets.PRESETS if preset.group == "screw_thread"]
    assert single == sorted(single) and len(single) >= 12
    assert threads == [f"Screw Thread M{size}" for size in (3, 4, 5, 6, 8, 10, 12, 16, 20, 24)]
    assert len({preset.doc for preset in presets.PRESETS}) == len(ALL)


@pytest.mark.parametrize("preset", [pytest.param(p, id=p.name, marks=LONG.get(p.group, ())) for p in SOLID])
def test_preset_is_a_job_for_a_closed_mesh_that_says_no_more_than_how_fine_it_is(made_once, preset):
    """Of solids in general motion half the cells stand for all, which have four times the vertices."""
    understood = job.read(preset.path)
    assert understood.shape == presets.shape(preset.name)
    fewer = 2 if preset.group in LONG and understood.shape.make_solid and not FULL else 1
    shape = replace(understood.shape, cells=understood.shape.cells // fewer) if fewer > 1 else understood.shape
    mesh = shape.mesh()
    assert len(mesh.boundary_edges()) == len(mesh.non_manifold_edges()) == 0 and mesh.volume() > 0
    assert fewer**2 * len(mesh.vertices) <= MOST_VERTICES
    assert all(said.startswith("Solid: cells of") for said in mesh.told)


def test_presets_of_mixed_dimension_are_the_six_of_the_lecture():
    mixed = [preset for preset in presets.PRESETS if preset.group == "mixed_dimension"]
    assert len(mixed) == 6
    for preset in mixed:
        assert job.read(preset.path).shape == presets.shape(preset.name)


@pytest.mark.parametrize(
    ("name", "area"),
    [
        ("ring_of_a_disc", 20 * pi),  # between circles of 4 and 6 m
        ("gasket", 0.018 * (2 * (0.12 + 0.07) + 0.04 * pi)),  # its width times the edge's length, as no corner is sharp
        ("growing_disc", None),
    ],
)
def test_plane_region_is_flat_and_bounded(name, area):
    mesh = presets.shape(f"plane_region_{name}").mesh()
    assert np.ptp(mesh.vertices[:, 2]) == 0 and len(mesh.boundary_edges()) and not len(mesh.non_manifold_edges())
    assert job.read(presets.BY_NAME[f"plane_region_{name}"].path).shape == presets.shape(f"plane_region_{name}")
    assert area is None or mesh.area() == pytest.approx(area, rel=3e-3)


@pytest.mark.parametrize("preset", presets.PRESETS, ids=ALL)
def test_preset_says_what_it_is_as_a_tooltip_does(preset):
    assert 10 < len(preset.doc) < 110 and preset.doc[0].isupper() and not preset.doc.endswith(".")


@pytest.mark.parametrize("name", [name for name in ALL if name.startswith("screw_thread")])
def test_screw_thread_turns_once_in_its_pitch(name):
    """That its profile and diameters are those of ISO 724 is tested where the contour is."""
    shape = presets.shape(name)
    stations = place(shape.trajectory, shape.samples)
    end = shape.trajectory.length()
    turns = shape.twist.evaluate(stations.u, np.array([0, 1]), np.array([0, end]))[-1] / (2 * pi)
    assert turns == pytest.approx(end / shape.contour.pitch, rel=1e-12)
    assert name == f"screw_thread_m{1000 * shape.contour.diameter:g}"


def test_bolt_head_is_the_hexagon_of_an_m12():
    """ISO 4014: 18 mm across the flats, 7.5 mm high."""
    across, _, high = size("bolt_head")
    assert min(size("bolt_head")[:2]) == pytest.approx(18, rel=1e-9) and across > 18 and high == pytest.approx(7.5)


def test_wine_glass_has_the_measures_and_holds_what_iso_3591_says():
    """In millimetres: 155 high, 65 across the foot and the bowl, 46 across the rim; 215 ml, 10 more or less."""
    across, _, high = size("wine_glass")
    section = presets.shape("wine_glass").contour.section()
    x, y = 1000 * section.points.T
    assert (across, high) == (pytest.approx(65, rel=1e-3), pytest.approx(155.4, abs=0.1))  # the rim is round
    assert 2 * x[np.abs(y - 155) < 1e-6].max() == pytest.approx(46) and 2 * x[np.abs(y - 30) < 21].min() == 9
    inside = slice(int(np.argmin(np.abs(section.points - (0.0222, 0.155)).sum(axis=1))), None)
    r, h = x[inside] / 10, y[inside] / 10  # in centimetres, from the rim down to the bottom on the axis
    held = np.abs(np.sum(np.diff(h) * (r[1:] ** 2 + r[1:] * r[:-1] + r[:-1] ** 2))) * pi / 3
    assert 205 <= held <= 225


def test_pipe_elbow_has_the_measures_of_its_standard():
    """ASME B16.9 and B36.10, in millimetres: its ends 76 from their corner, 60.3 across; metal as Pappus says."""
    shape = presets.shape("pipe_elbow")
    x, y, z = size("pipe_elbow")
    assert (x, y, z) == pytest.approx((76 + 60.3 / 2, 60.3, 76 + 60.3 / 2), rel=1e-3)
    metal = pi * (30.15**2 - 26.24**2) * 76 * pi / 2
    assert 1e9 * shape.mesh().volume() == pytest.approx(metal, rel=3e-3)


def test_auger_rises_by_its_diameter_in_each_turn():
    """CEMA 350: a standard pitch is the diameter."""
    shape = presets.shape("auger")
    across, _, high = size("auger")
    assert across == pytest.approx(150, rel=1e-3) and high == pytest.approx(3 * 150 + 5) and shape.pitch == 0.15


def test_cable_is_three_cores_of_the_size_of_h05v_k():
    """EN 50525-2-31: insulation of 0.6 mm, at most 2.8 mm across; three circles that touch reach 2.155 of theirs."""
    section = presets.shape("cable").contour.section()
    across = 1000 * section.perimeters / pi
    assert section.depth.tolist() == [0, 1, 2] * 3
    assert across[0::3] == pytest.approx(2.5, abs=0.02) and (across[0::3] < 2.8).all()
    assert (across[0::3] - across[1::3]) / 2 == pytest.approx(0.6, abs=0.01)
    assert 2 * radii("cable", 0.0).max() == pytest.approx((1 + 2 / np.sqrt(3)) * 2.5, abs=0.03)


def test_wire_rope_has_the_wires_and_the_diameter_of_its_class():
    """API Specification 9A, table C.2: 6 x 7 with a wire strand core, 8 mm: 8.00 to 8.40 mm."""
    section = presets.shape("wire_rope").contour.section()
    assert len(section.perimeters) == 7 * 7 and not section.depth.any()
    assert 8.00 <= 2 * radii("wire_rope", 0.0).max() <= 8.40


def test_hose_is_a_conduit_pf_22():
    """JIS C 8411:2019, table 5: 30.5 mm outside, at least 20.9 mm inside."""
    shape = presets.shape("hose")
    _, width, height = size("hose")
    distances = 1000 * np.hypot(*shape.mesh().vertices[:, 1:].T)
    assert width == pytest.approx(30.5, abs=0.05) and height == pytest.approx(30.5, abs=0.05)
    assert 2 * distances.min() == pytest.approx(20.9, abs=0.05)


def test_horn_is_the_bessel_horn_of_a_trombone():
    """Smyth, Scott 2011: 10 mm at the throat, 108 mm at the mouth, flare 0.7, and b = 0.0063 in metres."""
    assert radii("horn", 0.0).max() == pytest.approx(10, rel=1e-3)
    assert radii("horn", 0.502).max() == pytest.approx(108, rel=1e-3)
    b = 0.0063
    start = (b / 0.108) ** (1 / 0.7)
    for s in (0.1, 0.3, 0.45):
        along = presets.shape("horn").mesh().vertices[:, 0]
        nearest = along[np.abs(along - s).argmin()]
        expected = 1000 * b * (0.502 - nearest + start) ** -0.7
        assert radii("horn", nearest).max() == pytest.approx(expected, rel=0.01)


def test_propeller_blade_follows_its_pitch():
    """Pitch P means an angle of atan(P / 2 pi r); at three quarters of the radius the chord was measured as 0.199."""
    vertices = presets.shape("propeller_blade").mesh().vertices
    radius = 0.0254 * 8.9 / 2
    at = vertices[np.abs(vertices[:, 0] - 0.75 * radius).argmin(), 0]
    ring = vertices[np.abs(vertices[:, 0] - at) < 1e-9, 1:]
    nose, tail = ring[ring[:, 0].argmin()], ring[ring[:, 0].argmax()]
    rise, run = nose[1] - tail[1], tail[0] - nose[0]
    assert degrees(atan(rise / run)) == pytest.approx(degrees(atan(4.7 * 0.0254 / (2 * pi * at))), abs=1)
    assert np.hypot(rise, run) / radius == pytest.approx(0.199, abs=0.003)
    assert vertices[:, 0].max() == pytest.approx(radius, rel=1e-4) and rise > 0


def test_ribbon_is_as_long_and_as_wide_as_the_norm_asks():
    """FIG Apparatus Norms: at least 6 m, 40 to 60 mm."""
    shape = presets.shape("ribbon")
    assert 6.0 <= shape.trajectory.length() <= 6.1
    assert 0.04 <= shape.contour.height <= 0.06


def test_handrail_keeps_the_distances_of_the_ada_standards():
    """2010 ADA Standards, 504 and 505, in millimetres: clear of the wall, above the nosings, beyond the last steps."""
    shape = presets.shape("handrail")
    rail = place(shape.trajectory, shape.samples)
    x, y, z = 1000 * rail.points.T
    thick = 2000 * shape.contour.radius
    assert 32 <= thick <= 51 and y.max() - thick / 2 == pytest.approx(38, abs=0.5)
    nosings = np.array([(279.4 * step, 177.8 * (step + 1)) for step in range(3)])
    above = np.interp(nosings[:, 0], x[y > 56.9], z[y > 56.9]) + thick / 2 - nosings[:, 1]
    assert (865 <= above).all() and (above <= 965).all()
    assert x.min() <= -279.4 and x.max() - nosings[-1, 0] >= 304.8
    assert y[[0, -1]] == pytest.approx([0, 0], abs=1e-9)


def test_steel_arch_is_an_ipe_200_that_stands_on_the_ground():
    """EN 10365: 28.48 square centimetres, 200 by 100 mm."""
    shape = presets.shape("steel_arch")
    section, mesh = shape.contour.section(), shape.mesh()
    assert 1e4 * section.area == pytest.approx(28.48, abs=0.1)  # the fillets are chords
    assert 1000 * np.ptp(section.points, axis=0) == pytest.approx([100, 200])
    assert mesh.vertices[:, 2].min() == pytest.approx(0, abs=1e-15)
    assert (np.abs(mesh.vertices[:, 2]) < 1e-12).sum() == 2 * len(section.points)


def test_duct_has_the_openings_of_en_1505_and_en_1506_and_one_sheet():
    """400 x 400 mm to a diameter of 315 mm inside; the sheet is as thick everywhere that its normal is across."""
    swept = presets.shape("duct").swept()
    square, disc = swept.body.ends
    assert 1e6 * np.abs(square.areas[1]) == pytest.approx(400**2)
    assert 1e6 * np.abs(disc.areas[1]) == pytest.approx(pi * 157.5**2, rel=3e-3)
    assert 1000 * np.ptp(square.points) - 400 == pytest.approx(1.8)


def test_canoe_has_the_measures_of_one_of_sixteen_feet_and_ends_in_points():
    vertices = presets.shape("canoe").mesh().vertices
    assert 1000 * np.ptp(vertices, axis=0) == pytest.approx([16 * 304.8, 914, 600], rel=1e-3)
    assert (vertices[:, 0] == vertices[:, 0].max()).sum() == (vertices[:, 0] == 0).sum() == 1


def test_a_preset_that_is_none_is_refused_with_the_nearest():
    told = r"^preset: must be one of \d+ names, as hose(, \w+){0,2}, got 'hoose': did you mean 'hose'\?$"
    with pytest.raises(ShapeError, match=told):
        presets.shape("hoose")

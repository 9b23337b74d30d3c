# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Round ends: half a ball on a circle, a dome on any outline that is seen whole from its centroid."""

from dataclasses import replace

import numpy as np
import pytest
from solids import GLYPHS, assert_solid, box
from test_enclosing import winding

from sweep_addon.core.contours import Aerofoil, Circle, Ellipse, Outline, Rectangle, RegularPolygon, Star, Superellipse
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.grids.laying import CAP, SIDE
from sweep_addon.core.rings.ends import Flat, Open, Round, Taper
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.stations.sampling import Count, Tolerance
from sweep_addon.core.trajectories import Arc, Helix, Line, Polyline

UP = Line(end=(0, 0, 2))
SEEN_WHOLE = [
    Ellipse(0.5, 0.2),
    Rectangle(0.4, 0.2),
    Rectangle(0.4, 0.2, 0.05),
    RegularPolygon(5, 0.3),
    Star(7, 0.3, 0.1),
    Superellipse(0.4, 0.2, 0.7),
    Outline([box((0.1, 0.2), (0.3, 0.6))]),
]


def pill(contour=None, samples=None, height=1.0, **given):
    """Two metres of a tube with two round ends."""
    ends = {"start": Round(height), "end": Round(height)}
    return GeneralizedCylinder(contour or Circle(0.5), UP, samples or Tolerance(1e-3), **{**ends, **given})


def beyond(mesh):
    """The vertices above the end of the path, as (k, 3) from it."""
    return mesh.vertices[mesh.vertices[:, 2] > 2] - (0, 0, 2)


@pytest.mark.parametrize("samples", [Tolerance(1e-2), Tolerance(1e-5), Count(2), Count(50)])
@pytest.mark.parametrize("points", [3, 4, 5, 16, 64])
def test_all_vertices_on_a_circle_are_on_a_ball(samples, points):
    mesh = pill(Circle(0.5, points), samples).mesh()
    assert_solid(mesh, euler=2)
    assert np.abs(np.linalg.norm(beyond(mesh), axis=1) - 0.5).max() < 1e-15
    assert mesh.vertices[:, 2].min() == pytest.approx(-0.5) and mesh.vertices[:, 2].max() == pytest.approx(2.5)


@pytest.mark.parametrize("samples", [Tolerance(1e-2), Tolerance(1e-4), Count(2), Count(50)])
@pytest.mark.parametrize("points", [3, 8, 64])
def test_a_dome_has_the_volume_of_the_polyhedron_of_its_rings(samples, points):
    """Frusta between regular polygons: h / 3 (A + B + sqrt(A B))."""
    mesh = pill(Circle(0.5, points), samples, start=Flat()).mesh()
    height = np.unique(beyond(mesh)[:, 2].round(12))
    height = np.append(0.0, height)
    radius = np.sqrt((0.25 - height**2).clip(0.0))
    area = points / 2 * np.sin(2 * np.pi / points) * radius**2
    frusta = np.diff(height) / 3 * (area[1:] + area[:-1] + np.sqrt(area[1:] * area[:-1]))
    tube = 2 * area[0]
    assert mesh.volume() == pytest.approx(tube + frusta.sum(), rel=1e-11)


def test_half_a_ball_in_the_limit():
    """2 / 3 pi r^3, to the second order of the steps; with a count there are as many of them as round a quarter."""
    errors = []
    for points in (32, 64, 128, 256):
        domes = pill(Circle(0.5, points), Count(100)).mesh().volume() - 2 * Circle(0.5, points).section().area
        errors.append(1 - domes / (4 / 3 * np.pi * 0.125))
    assert errors[0] < 0.02 and np.divide(errors[:-1], errors[1:]) == pytest.approx(4, rel=0.01)


@pytest.mark.parametrize("chord", [1e-2, 1e-3, 1e-5])
@pytest.mark.parametrize("height", [0.25, 1.0, 3.0])
def test_chords_of_a_dome_are_within_the_tolerance_and_not_many_more_than_that_asks_for(chord, height):
    """Of the ellipse through the vertices of one column; where it is as round as its larger half axis, by as much."""
    mesh = pill(Circle(0.5, 4), Tolerance(chord), height, start=Flat()).mesh()
    column = beyond(mesh)[:, [0, 2]]
    column = column[(column[:, 0] > 1e-9) | (column[:, 1] > 0.5 * height - 1e-9)]
    angle = np.sort(np.append(0.0, np.arctan2(column[:, 1] / height, column[:, 0])))
    middle, step = (angle[1:] + angle[:-1]) / 2, np.diff(angle)
    most = 0.5 * max(1.0, height) * (1 - np.cos(step / 2)).max()  # the same part of both half axes
    assert most <= chord * (1 + 1e-9) and step.max() <= np.radians(30) + 1e-9
    assert most > chord / 2.5 or step.max() > np.radians(25)
    assert len(middle) == len(step)


def test_height_is_measured_in_half_breadths():
    """The distance of the nearest side from the centroid; on a circle it is the radius, however few its points."""
    for contour, half in (
        (Circle(0.3, 5), 0.3),
        (Rectangle(0.4, 0.2), 0.1),
        (RegularPolygon(6, 0.3), 0.3 * np.cos(np.pi / 6)),
        (Outline([box((2.0, 3.0), (2.1, 3.8))]), 0.05),
        (Outline([[(0, 0.2), (-0.2, 0), (0, -0.2), (0.2, 0)]]), 0.2 / np.sqrt(2)),
    ):
        for height in (0.5, 1.0, 2.0):
            mesh = pill(contour, height=height).mesh()
            assert np.ptp(mesh.vertices[:, 2]) == pytest.approx(2 + 2 * height * half, rel=1e-12)
    assert np.ptp(pill(Ellipse(0.5, 0.2, 256)).mesh().vertices[:, 2]) == pytest.approx(2.4, abs=1e-3)
    assert np.ptp(pill(Rectangle(0.4, 0.2, 0.05)).mesh().vertices[:, 2]) == pytest.approx(2.2, abs=1e-3)


@pytest.mark.parametrize("contour", SEEN_WHOLE)
@pytest.mark.parametrize(
    ("laws", "scale"),
    [
        ({}, (1, 1)),
        ({"scale_x": -1}, (-1, 1)),
        ({"scale_x": -1, "scale_y": -1}, (-1, -1)),
        ({"scale_x": "1+t", "scale_y": 0.5}, (2, 0.5)),
        ({"twist": "t"}, (1, 1)),
    ],
)
def test_a_dome_on_any_outline_that_is_seen_whole_is_a_solid_with_its_tip_over_the_centroid(contour, laws, scale):
    mesh, flat = pill(contour, **laws).mesh(), GeneralizedCylinder(contour, UP, **laws).mesh()
    assert_solid(mesh, euler=2)
    assert mesh.volume() > flat.volume() > 0
    tip = mesh.vertices[mesh.vertices[:, 2].argmax(), :2]
    assert np.linalg.norm(tip) == pytest.approx(np.linalg.norm(contour.section().centroid * scale), abs=1e-12)
    around = mesh.vertices[mesh.vertices[:, 2] == 2][:, :2] - tip
    rim = flat.vertices[flat.vertices[:, 2] == 2][:, :2]
    assert np.abs(np.sort(around + tip, axis=0) - np.sort(rim, axis=0)).max() < 1e-15


def test_a_scaled_circle_has_an_ellipsoidal_dome():
    """2 / 3 pi a b c, c the smaller half axis."""
    mesh = pill(Circle(1.0, 512), Tolerance(1e-5), start=Flat(), scale_x=0.6, scale_y=0.3).mesh()
    tube = 2 * Circle(1.0, 512).section().area * 0.18
    assert mesh.volume() - tube == pytest.approx(2 / 3 * np.pi * 0.6 * 0.3 * 0.3, rel=1e-4)
    parts = beyond(mesh) / (0.6, 0.3, 0.3)
    turned = beyond(mesh)[:, [1, 0, 2]] / (0.6, 0.3, 0.3)
    assert min(np.abs(np.linalg.norm(p, axis=1) - 1).max() for p in (parts, turned)) < 1e-4


def test_a_dome_stands_across_the_end_of_a_bent_path():
    quarter = Arc(2.0, np.pi / 2)
    mesh = GeneralizedCylinder(Circle(0.5), quarter, start=Round(), end=Round()).mesh()
    assert_solid(mesh, euler=2)
    for tip in ((2, -0.5, 0), (-0.5, 2, 0)):
        assert np.linalg.norm(mesh.vertices - tip, axis=1).min() < 1e-14


def test_a_sweep_that_runs_backward_beside_its_path_has_its_domes_outside():
    """Three metres towards the centre of a circle of two, a half turn goes the other way round, one metre out."""
    half = Arc(2.0, np.pi)
    for offset in ({"offset_x": 3.0}, {"offset_x": -3.0}, {"offset_y": 3.0}, {"offset_y": -3.0}):
        shape = GeneralizedCylinder(Circle(0.2, 16), half, start=Round(), end=Round(), **offset)
        mesh, flat = shape.mesh(), GeneralizedCylinder(Circle(0.2, 16), half, **offset).mesh()
        assert_solid(mesh, euler=2)
        ball = pill(Circle(0.2, 16)).mesh().volume() - 2 * Circle(0.2, 16).section().area
        assert mesh.volume() - flat.volume() == pytest.approx(ball, rel=1e-9)


def test_texture_and_arc_length_go_on_over_the_dome_and_u_does_not():
    mesh = pill(Circle(0.5, 64), Tolerance(1e-4)).mesh()
    attributes, angle = mesh.attributes, np.arcsin((beyond(mesh)[:, 2] / 0.5).clip(0, 1))
    on_dome = mesh.vertices[:, 2] > 2
    assert attributes["arc_length"][on_dome] == pytest.approx(2 + 0.5 * angle, abs=1e-3)
    assert attributes["arc_length"].min() == pytest.approx(-0.25 * np.pi, abs=1e-3)
    assert (attributes["u"][on_dome] == 1).all() and attributes["u"].min() == 0
    run = np.ptp(mesh.uv[:, 0])
    assert run == pytest.approx(2 + 0.5 * np.pi, abs=1e-3)
    along = mesh.uv[mesh.topology.following] - mesh.uv
    ends = mesh.vertices[mesh.corners[mesh.topology.following]] - mesh.vertices[mesh.corners]
    meridians = np.abs(along[:, 1]) < 1e-12
    assert np.abs(along[meridians, 0]) == pytest.approx(np.linalg.norm(ends[meridians], axis=1), abs=1e-12)


def test_a_unit_texture_covers_the_domes_too():
    for given in ({}, {"start": Flat()}, {"end": Taper(0.5)}):
        mesh = pill(texture="unit", **given).mesh()
        sides = np.repeat(np.diff(mesh.offsets), np.diff(mesh.offsets)) < 5
        assert np.abs(mesh.uv[sides].min(axis=0)).max() < 1e-15 and np.abs(mesh.uv[sides].max(axis=0) - 1).max() < 1e-15


def test_a_dome_is_smooth_and_has_the_material_of_caps():
    mesh = pill(Circle(0.5, 16), Count(4), start=Flat()).mesh()
    face = np.repeat(np.arange(len(mesh.offsets) - 1), np.diff(mesh.offsets))
    lowest = np.full(len(mesh.offsets) - 1, np.inf)
    np.minimum.at(lowest, face, mesh.vertices[mesh.corners, 2])
    highest = np.full(len(mesh.offsets) - 1, -np.inf)
    np.maximum.at(highest, face, mesh.vertices[mesh.corners, 2])
    assert ((mesh.topology.material == CAP) == ((highest == 0) | (lowest >= 2))).all()
    assert set(mesh.topology.material) == {SIDE, CAP}
    sharp = mesh.vertices[mesh.edges[mesh.topology.sharp]]
    assert (sharp[..., 2] == 0).all() and len(sharp) == 16
    square = pill(Rectangle(0.4, 0.4), Count(4)).mesh()
    rims = np.ptp(square.vertices[square.edges[square.topology.sharp]][..., 2], axis=1)
    assert (rims > 0).all()  # from tip to tip, and none round the ends


def test_mitres_stay_sharp_behind_a_dome():
    bent = Polyline([(0, 0, 0), (0, 0, 2), (0, 2, 2)])
    for start in (Flat(), Round()):
        mesh = GeneralizedCylinder(Circle(0.2, 12), bent, start=start, end=Round()).mesh()
        rims = mesh.vertices[mesh.edges[mesh.topology.sharp]]
        mitre = (np.abs(rims[..., 1] + rims[..., 2] - 2) < 1e-12).all(axis=1)
        assert mitre.sum() == 12 and len(rims) == 12 * (1 + isinstance(start, Flat))


@pytest.mark.parametrize("ends", [(Round(), Taper(0.5)), (Flat(), Round()), (Open(), Round()), (Round(), Open())])
def test_ends_of_all_kinds_go_together(ends):
    mesh = GeneralizedCylinder(Circle(0.2, 12), Helix(), start=ends[0], end=ends[1]).mesh()
    opened = sum(isinstance(end, Open) for end in ends)
    assert_solid(mesh, euler=2 - opened, boundary=12 * opened)


def test_where_the_contour_is_a_point_there_is_nothing_to_round():
    pointed = pill(scale_x="1-t", scale_y="1-t").mesh()
    assert_solid(pointed, euler=2)
    assert pointed.vertices[:, 2].max() == 2


UNDOMED = {
    "L": "'s centroid does not see all of its outline",
    "B": " has holes, which a dome would close",
    "%": " has holes, which a dome would close",
    ":": " has several outlines: sweep each by itself",
}


@pytest.mark.parametrize("glyph", UNDOMED)
@pytest.mark.parametrize("key", ["start", "end"])
def test_outlines_that_have_no_dome_are_refused(glyph, key):
    contours = {":": Outline([box((0, 0), (1, 1)), box((0, 2), (1, 3))])} | {name: GLYPHS[name][0] for name in "LB%"}
    with pytest.raises(ShapeError) as refusal:
        GeneralizedCylinder(contours[glyph], UP, **{key: Round()}).mesh()
    expected = f"{key}: must be flat, open or taper where the contour{UNDOMED[glyph]}, got 'round'"
    assert str(refusal.value) == expected


def test_an_aerofoil_has_a_dome():
    assert_solid(pill(Aerofoil("0012")).mesh(), euler=2)


def test_a_closed_path_has_no_end_to_round_and_says_so():
    ring = GeneralizedCylinder(trajectory=Arc(angle=2 * np.pi), end=Round()).mesh()
    assert_solid(ring, euler=0)
    assert ring.told == ("Ends: a closed trajectory has none, so nothing tapers and nothing is round.",)


def test_too_many_rings_are_refused():
    with pytest.raises(ShapeError, match="samples: must make at most 20,000,000 vertices, got "):
        pill(Circle(1000.0, 4096), Tolerance(1e-8)).mesh()


@pytest.mark.parametrize("samples", [Count(2), Count(5), Count(40), Tolerance(1e-2), Tolerance(1e-4)])
@pytest.mark.parametrize("points", [3, 6, 16])
def test_area_true_is_the_volume_of_a_pill(samples, points):
    """2 pi r^2 + 4 / 3 pi r^3 on two metres, however coarse; of an ellipse pi a b (2 + 4 / 3 c), twisted too."""
    contour = Circle(0.5, points)
    mesh = pill(contour, samples, fit="area-true").mesh()
    assert_solid(mesh, euler=2)
    assert mesh.volume() == pytest.approx(np.pi * (2 * 0.25 + 4 / 3 * 0.125), rel=1e-12)
    stretched = pill(contour, samples, height=2.0, scale_x=3.0, twist="t")
    height = stretched.mesh().vertices[:, 2].max() - 2
    mesh = replace(stretched, fit="area-true").mesh()
    assert mesh.volume() == pytest.approx(np.pi * 0.75 * (2 + 4 / 3 * height), rel=1e-9)


@pytest.mark.thorough
@pytest.mark.parametrize("contour", [Circle(0.5, 8), Ellipse(0.5, 0.2, 12), Rectangle(0.6, 0.3, 0.1)])
@pytest.mark.parametrize("samples", [Count(6), Count(40), Tolerance(1e-2), Tolerance(1e-3)])
def test_no_point_of_the_true_domes_is_outside_a_circumscribed_mesh(contour, samples):
    bent = Arc(3.0, 1.0)
    shape = GeneralizedCylinder(contour, bent, samples, start=Round(), end=Round(1.5), fit="circumscribed")
    mesh = shape.mesh()
    assert_solid(mesh, euler=2)
    finer = {name: 400 for name in ("points", "corner_points") if hasattr(contour, name)}
    fine = replace(contour, **finer)
    true = GeneralizedCylinder(fine, bent, Tolerance(1e-4), start=Round(), end=Round(1.5)).mesh()
    domes = true.vertices[(true.attributes["u"] == bent.domain[0]) | (true.attributes["u"] == bent.domain[1])]
    some = np.random.default_rng(1).permutation(domes)[:2000]
    assert winding(mesh, some, 0).min() > 0.5
    assert (
        winding(GeneralizedCylinder(contour, bent, samples, start=Round(), end=Round(1.5)).mesh(), some, 0).min() < 0.5
    )

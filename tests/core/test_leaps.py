# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a Frenet frame turns at once the contour does, and the sweep is not wrung through its own axis."""

import json
from math import atan, pi, sqrt
from pathlib import Path

import numpy as np
import pytest
from conftest import FULL
from contour_inputs import OUTLINES, drawn
from solids import box

from sweep_addon import classify
from sweep_addon.core.contours import Outline, Rectangle
from sweep_addon.core.meshes.components import components
from sweep_addon.core.meshes.facets import facets
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.solids import Triangles
from sweep_addon.core.stations.frames import Continuation, FixedUp, Frenet, RotationMinimizing
from sweep_addon.core.stations.leaps import leaps
from sweep_addon.core.stations.sampling import Count, Tolerance
from sweep_addon.core.trajectories import Bezier, Formula, Helix, Polyline, Sampled

EXACT = Frenet(Continuation.EXACT)
TURNING = Formula("u", "u^3", "0", start=-1.0, end=1.0)
EIGHT = Formula("sin(u)", "sin(2*u)", "0", start=0.0, end=2 * pi)  # it bends the other way at its start and halfway
PEANUT = Formula("(1 + 0.5*cos(2*u))*cos(u)", "(1 + 0.5*cos(2*u))*sin(u)", "0", start=0.0, end=2 * pi)  # bends in twice
HANDLE = 4 / 3 * (sqrt(2) - 1)  # of a quarter of a circle
TWO_PLANES = Bezier(
    [(1, 0, 0), (1, HANDLE, 0), (HANDLE, 1, 0), (0, 1, 0), (-HANDLE, 1, 0), (-1, 1, 1 - HANDLE), (-1, 1, 1)]
)
PLACES = 300  # of a mesh at most
BESIDE = 0.1 * 0.05 * 2 * 0.9 * pi / 2  # Pappus: two quarters of a turn, the frame 90 degrees forward between them


@pytest.mark.parametrize("samples", [Count(400), Tolerance(1e-4)])
@pytest.mark.parametrize("trajectory", [TURNING, EIGHT])
def test_bar_that_half_a_turn_maps_to_itself_is_as_large_however_its_frame_leaps(trajectory, samples):
    volumes = [
        GeneralizedCylinder(Rectangle(0.1, 0.05), trajectory, samples=samples, frame=frame).mesh().volume()
        for frame in (EXACT, Frenet())
    ]
    assert volumes[0] == pytest.approx(volumes[1], rel=2e-4)


def test_bar_beside_its_path_is_always_on_the_side_of_the_centre_of_curvature():
    """Pappus: area times the way of the centroid, which is shorter by the turns of the tangent times its distance."""
    bar = GeneralizedCylinder(Outline([box((0.0, 0.0), (0.1, 0.05))]), TURNING, Tolerance(1e-5), EXACT)
    turns = 2 * atan(3)  # the tangent's slope is 3 u^2, from 3 to 0 and back to 3
    assert bar.mesh().volume() == pytest.approx(0.1 * 0.05 * (TURNING.length() - 0.05 * turns), rel=2e-4)


@pytest.mark.parametrize("frame", [EXACT, Frenet()])
def test_quarter_turn_between_two_planes_is_made_in_a_thirtythousandth_of_the_length(frame):
    """Both quarters of circles bend in their own plane up to where they meet, where each is half of the length."""
    (leap,) = leaps(frame, TWO_PLANES)
    total = TWO_PLANES.length()
    assert leap[0] - 1e-9 <= total / 2 <= leap[1] + 1e-9 and leap[1] - leap[0] < total / 30_000
    shown = GeneralizedCylinder(Rectangle(0.1, 0.05), TWO_PLANES, Count(21), frame).frames()
    inward = np.where(shown.s[:, None] < total / 2, (0, 0, 0), (0, 1, 1)) - shown.points
    along = np.einsum("ij,ij->i", shown.e2, inward) / np.linalg.norm(inward, axis=1)
    assert np.abs(along).min() > 0.99  # a smooth one takes either side of the second


@pytest.mark.thorough
def test_side_on_which_a_smooth_frame_goes_on_does_not_hang_on_rounding():
    """At a right angle both are as near. Turned and moved it is the same bar, and membership tells of the same one."""
    random, beside = np.random.default_rng(0), Outline([box((0.05, 0.0), (0.15, 0.05))])
    for _ in range(20 if FULL else 8):
        turn = np.linalg.qr(random.normal(size=(3, 3)))[0]
        turn *= np.sign(np.linalg.det(turn))
        path = Bezier(np.asarray(TWO_PLANES.points) @ turn.T + random.normal(size=3))
        bars = [GeneralizedCylinder(beside, path, samples, Frenet()) for samples in (Count(33), Count(200))]
        for bar in bars:
            assert (classify(bars[0], bar.mesh().vertices, tolerance=1e-3) == 0).all()
        assert bars[1].mesh().volume() == pytest.approx(BESIDE, rel=1e-3)


@pytest.mark.thorough
@pytest.mark.parametrize("seed", range(2 if FULL else 1))
@pytest.mark.parametrize("frame", [Frenet(), EXACT, FixedUp()], ids=["smooth", "exact", "up"])
@pytest.mark.parametrize("kind", [Sampled, Polyline])
def test_side_of_a_frame_does_not_hang_on_how_many_contours_there_are(kind, frame, seed):
    """Where it turns fast, between contours too, membership knows of the same side."""
    path = kind(np.cumsum(np.random.default_rng(seed).normal(size=(12, 3)), axis=0))
    beside = Outline([box((0.02, 0.0), (0.06, 0.02))])
    for count in (25, 200):
        bar = GeneralizedCylinder(beside, path, Count(count), frame)
        vertices = bar.mesh().vertices
        some = vertices if FULL else vertices[:: -(-len(vertices) // PLACES)]
        labels = classify(bar, some, tolerance=1e-4)
        assert (labels >= 0).all() and (labels == 0).mean() > 0.9  # a few are in, where the path bends too sharply


@pytest.mark.parametrize("trajectory, bodies", [(TURNING, 2), (PEANUT, 4)])
def test_solid_of_a_bar_beside_its_path_is_in_parts_on_both_sides_of_it(trajectory, bodies):
    """Pappus, for each part: the bar is inwards of every bend, so that all turns of the tangent count alike."""
    pytest.importorskip("manifold3d")
    bar = GeneralizedCylinder(Outline([box((0.02, 0.0), (0.08, 0.05))]), trajectory, Tolerance(1e-5), EXACT)
    tangents = trajectory.tangents(np.linspace(*trajectory.domain, 100_001))
    turns = np.arcsin(np.linalg.norm(np.cross(tangents[1:], tangents[:-1]), axis=1)).sum()
    solid = bar.solid()
    assert solid.volume() == pytest.approx(0.06 * 0.05 * (trajectory.length() - 0.05 * turns), rel=3e-4)
    assert len(solid.boundary_edges()) == len(solid.non_manifold_edges()) == 0
    assert solid.euler_characteristic() == 2 * bodies


def test_solid_of_a_bar_that_crosses_its_path_is_one_where_it_leaps():
    pytest.importorskip("manifold3d")
    bar = GeneralizedCylinder(Outline([box((-0.02, 0.0), (0.08, 0.05))]), TURNING, Count(41), EXACT)
    parts = []
    solid = bar.solid(parts.append)
    assert solid.euler_characteristic() == 2 and len(solid.boundary_edges()) == 0
    assert parts == sorted(parts) and 0 < parts[-1] <= 1


def test_where_no_frame_leaps_there_is_nothing():
    for frame, trajectory in ((Frenet(), TURNING), (EXACT, Helix()), (Frenet(), EIGHT)):
        assert leaps(frame, trajectory).shape == (0, 2)
    assert leaps(EXACT, EIGHT).shape == (2, 2)


@pytest.mark.parametrize("trajectory", [TURNING, EIGHT])
@pytest.mark.parametrize("count", [3, 9, 401])
def test_no_contour_stands_halfway_round_where_a_frame_leaps(trajectory, count):
    """Beside a path in a plane a bar lies in that plane, also where a contour stands at the inflection."""
    beside = Outline([box((0.05, -0.01), (0.1, 0.01))])
    mesh = GeneralizedCylinder(beside, trajectory, Count(count), EXACT).mesh()
    assert np.abs(mesh.vertices[:, 2]).max() == pytest.approx(0.01, rel=1e-6)


CLIMBING = [(0, 0, 0), (2, 0, 0), (2, 2, 1), (0, 2, 3)]


@pytest.mark.parametrize("legs", [2, 3])
@pytest.mark.parametrize("samples", [Count(2), Count(41), Tolerance(1e-3), Tolerance(1e-5)])
@pytest.mark.parametrize("closed", [False, True])
def test_legs_of_a_climbing_handrail_stay_level_up_to_their_mitres(closed, samples, legs):
    """Pappus: each leg is a prism between two mitres, and nothing of it is wrung. Its x axis lies level."""
    path = Polyline(CLIMBING[: legs + 1], closed)
    rail = GeneralizedCylinder(Rectangle(0.3, 0.1), path, samples, FixedUp())
    mesh = rail.mesh()
    assert mesh.volume() == pytest.approx(0.3 * 0.1 * path.length(), rel=3e-5)
    assert not rail.self_intersections()
    sharp = rail.swept().chart.grid.creases
    assert len(sharp) == 2 * len(leaps(FixedUp(), path)) == 2 * len(path.corners())
    pytest.importorskip("manifold3d", reason="a solid across leaps is a union")
    assert rail.solid().volume() == pytest.approx(mesh.volume(), rel=1e-4)


LINES = json.loads((Path(__file__).parents[1] / "data" / "centrelines.json").read_text())["lines"]
BACKBONE = next(np.array(line["points"]) for line in LINES if line["name"] == "1LCD_A_CA")
DIAMOND = Polyline([(21.5, -21.5, -3), (21.5, -8.45, -3), (8.45, -21.5, -3)])  # a machine's, from its G-code


@pytest.mark.parametrize("fit", ["inscribed", "area-true", "circumscribed"])
def test_solid_of_a_level_bar_of_any_fit_has_legs_up_to_their_mitres(fit):
    """Pappus: straight sides leave a fit nothing to make up for."""
    pytest.importorskip("manifold3d", reason="a solid across leaps is a union")
    bar = GeneralizedCylinder(Rectangle(0.6, 0.3), DIAMOND, Tolerance(0.005), FixedUp((0.3, 1, 0.2)), fit=fit)
    for mesh in (bar.mesh(), bar.solid()):
        assert mesh.volume() == pytest.approx(0.6 * 0.3 * DIAMOND.length(), rel=2e-5)


@pytest.mark.parametrize("start", [8, 32])
def test_solid_of_a_level_bar_is_whole_where_curved_legs_meet(start):
    """Handles through the atoms of a protein make a corner: what membership, without a mesh, has inside is inside."""
    pytest.importorskip("manifold3d", reason="a solid across leaps is a union")
    path = Bezier(BACKBONE[start : start + 7])
    bar = GeneralizedCylinder(Rectangle(0.6, 0.3), path, Tolerance(5e-4), FixedUp((0.3, 1, 0.2)))
    solid = bar.solid()
    points = BACKBONE[start + 3] + np.random.default_rng(0).uniform(-1, 1, (10_000, 3))
    points = points[classify(bar, points) > 0]
    body = Triangles(solid.vertices, facets(solid)[0])
    assert len(points) > 400 and (classify(body, points) < 0).mean() < 0.005


@pytest.mark.thorough
def test_solid_across_leaps_has_no_specks():
    """A machine part along the handles of a road: where its parts all but meet, the union had bodies of no volume."""
    pytest.importorskip("manifold3d", reason="a solid across leaps is a union")
    part = drawn(next(outline for outline in OUTLINES if outline["id"] == "prusa3-001"))
    corners = np.array(part.loops[0]) - part.section().centroid
    corners *= 26.6 / np.linalg.norm(part.section().points - part.section().centroid, axis=1).max()
    road = next(line["points"] for line in LINES if line["name"] == "visnjan_road")[27:70]
    solid = GeneralizedCylinder(Outline([corners], part.bulges), Bezier(road), Tolerance(0.266), Frenet()).solid()
    assert len(solid.boundary_edges()) == len(solid.non_manifold_edges()) == 0
    assert len(np.unique(solid.vertices.astype(np.float32), axis=0)) == len(solid.vertices)
    triangles, _ = facets(solid)
    shell = components(len(solid.vertices), np.concatenate((triangles[:, :2], triangles[:, 1:])))[triangles[:, 0]]
    a, b, c = (solid.vertices - solid.vertices.mean(axis=0))[triangles].swapaxes(0, 1)
    assert np.abs(np.bincount(shell, np.einsum("ij,ij->i", np.cross(a, b), c))[np.unique(shell)]).min() > 1e-6


def test_level_frame_leaps_at_no_corner_of_a_level_path():
    assert leaps(FixedUp(), Polyline([(0, 0, 0), (1, 0, 0), (1, 1, 0)])).shape == (0, 2)


BEGUN_AT_AN_INFLECTION = Formula(
    "(1 + 0.5*cos(2*(u + 1.2735449654736897)))*cos(u + 1.2735449654736897)",
    "(1 + 0.5*cos(2*(u + 1.2735449654736897)))*sin(u + 1.2735449654736897)",
    "0",
    start=0.0,
    end=2 * pi,
)


@pytest.mark.parametrize("fit, error", [("area-true", 5e-5), ("inscribed", 3e-3), ("circumscribed", 0.05)])
@pytest.mark.parametrize("trajectory", [PEANUT, BEGUN_AT_AN_INFLECTION])
def test_fits_have_nothing_to_make_up_for_where_a_frame_leaps(trajectory, fit, error):
    """Weyl: area times length. A bar that half a turn maps to itself is as large as with a frame that leaps nowhere."""
    bar = GeneralizedCylinder(Rectangle(0.1, 0.05), trajectory, Tolerance(1e-3), EXACT, fit=fit)
    assert bar.mesh().volume() == pytest.approx(0.1 * 0.05 * trajectory.length(), rel=error)
    assert not bar.self_intersections()


@pytest.mark.parametrize("power", [3, 5, 7, 9])
def test_bar_is_not_wrung_over_a_stretch_that_is_nearly_straight(power):
    """A frame that changes its side does so amid it: with one that turns nowhere the bar is as large."""
    path = Formula("u", f"u^{power}", "0", start=-1.0, end=1.0)
    exact, smooth = (
        GeneralizedCylinder(Rectangle(0.1, 0.05), path, Count(41), frame).mesh().volume()
        for frame in (EXACT, RotationMinimizing())
    )
    assert exact == pytest.approx(smooth, rel=3e-4)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces that move, against what is known of the sets that they visit, and against their meshes."""

from math import pi

import numpy as np
import pytest
from conftest import FULL

import sweep_addon as sw
from sweep_addon.core.membership.sets.bodies import MeshBody

UP = sw.trajectories.Line()
SQUARE = sw.solids.Triangles([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3)])
TRIANGLE = sw.solids.Triangles([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
TOLERANCES = [None, 1e-6, 1e-3, 0.03]


def sheet(rows):
    """The triangles between rows of points, (m, n, 3)."""
    m, n = rows.shape[:2]
    first = (np.arange(m - 1)[:, None] * n + np.arange(n - 1)).ravel()
    faces = [(first, first + 1, first + n + 1), (first, first + n + 1, first + n)]
    return sw.solids.Triangles(rows.reshape(-1, 3), np.concatenate([np.stack(part, axis=1) for part in faces]))


def drawn(outline, depth):
    """An outline (n, 2) in the plane of x and z, drawn along y."""
    x, z = np.array(outline, dtype=float).T
    return sheet(np.stack([np.stack((x, 0 * x + y, z), axis=1) for y in (0.0, depth)]))


ANGLES = np.linspace(0, pi, 33)
SHEETS = {
    "square": SQUARE,
    "an angle": drawn([(0.8, 0), (0, 0), (0, 0.8)], 0.7),
    "a narrow fold": drawn([(0.1, 0.8), (0, 0), (0, 0.8)], 0.7),
    "half a cylinder": drawn(np.stack((0.5 * np.cos(ANGLES), 0.5 * np.sin(ANGLES)), axis=1), 0.7),
    "a wave": sheet(
        np.array(
            [
                [(x, y, 0.2 * np.sin(5 * x) * np.cos(4 * y)) for x in np.linspace(0, 1, 11)]
                for y in np.linspace(0, 1, 11)
            ]
        )
    ),
}


def hit(start, way, corners):
    """Whether segments (n, 3) from some points along ways meet triangles (f, 3, 3): (n,) bool.

    Source: Moeller, Trumbore: Fast, minimum storage ray/triangle intersection, J. Graphics Tools 2, 1997.
    """
    a, u, v = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    way = np.broadcast_to(way, start.shape)[:, None]
    across, away = np.cross(way, v), start[:, None] - a
    normal, scale = np.cross(away, u), (u * np.cross(way, v)).sum(axis=2)
    with np.errstate(divide="ignore", invalid="ignore"):
        p, q, t = (
            (away * across).sum(axis=2) / scale,
            (normal * way).sum(axis=2) / scale,
            (normal * v).sum(axis=2) / scale,
        )
        return ((p >= 0) & (q >= 0) & (p + q <= 1) & (t >= 0) & (t <= 1)).any(axis=1)


@pytest.mark.thorough
@pytest.mark.parametrize("tolerance", TOLERANCES)
def test_a_square_moved_along_its_normal_is_a_block(tolerance):
    points = np.random.default_rng(1).uniform(-0.2, 1.2, (20_000 if FULL else 6_000, 3))
    beyond = np.maximum(-points, points - 1)
    far = np.linalg.norm(np.maximum(beyond, 0), axis=1) + np.minimum(beyond.max(axis=1), 0)
    band = tolerance or 1e-8
    for moved in (sw.GeneralSweep, sw.SweptSolid):
        labels = sw.classify(moved(SQUARE, UP), points, tolerance)
        assert (labels == np.sign(-far))[np.abs(far) > 1.5 * band].all()
        assert (labels[np.abs(far) < 0.5 * band] == 0).all()


def test_of_a_block_that_a_square_leaves_all_faces_edges_and_corners_are_on():
    random = np.random.default_rng(2)
    points = random.uniform(0.1, 0.9, (700, 3))
    many = np.arange(700)
    points[many, many % 3] = many % 2
    points[600:, 0] = many[600:] // 2 % 2
    points[650:, 1] = many[650:] // 4 % 2
    labels = sw.classify(sw.GeneralSweep(SQUARE, UP), points, 1e-7)
    assert (labels == 0).all()
    out = 0.5 + (points - 0.5) * (1 + 1e-5)
    assert (sw.classify(sw.GeneralSweep(SQUARE, UP), out, 1e-7) == -1).all()
    inner = 0.5 + (points - 0.5) * (1 - 1e-5)
    assert (sw.classify(sw.GeneralSweep(SQUARE, UP), inner, 1e-7) == 1).all()


@pytest.mark.thorough
@pytest.mark.parametrize("way", [(0, 0, 1.0), (0.7, 0.2, 0.5), (0.9, 0.4, 0.05), (-0.3, 0.8, -0.6)])
@pytest.mark.parametrize("name", SHEETS)
def test_a_sheet_moved_straight_visits_what_lines_back_from_meet(name, way):
    """A point has been visited if the line from it, as long as the way and against it, meets the sheet."""
    body, way = SHEETS[name], np.array(way)
    vertices = body.vertices.values
    low, high = vertices.min(axis=0) + np.minimum(way, 0), vertices.max(axis=0) + np.maximum(way, 0)
    points = np.random.default_rng(3).uniform(low - 0.1, high + 0.1, (4_000 if FULL else 1_500, 3))
    labels = sw.classify(sw.GeneralSweep(body, sw.trajectories.Line(end=tuple(way))), points)
    visited = hit(points, -way, vertices[body.faces.values.astype(int)])
    assert (labels == np.where(visited, 1, -1)).all()
    assert visited.any() and not visited.all()


def test_a_square_moved_obliquely_is_on_within_the_tolerance():
    """The sides that its edges leave lean: points beside one are on as far as they are from its plane."""
    way, tolerance = np.array((0.6, 0.0, 0.3)), 1e-3
    random = np.random.default_rng(4)
    side = np.array((0.3, 0.0, -0.6)) / np.hypot(0.3, 0.6)  # out of what the edge x = 1 leaves
    off = np.tile([-1.6, -0.4, 0.4, 1.6], 250) * tolerance
    points = (1.0, 0.0, 0.0) + random.uniform(0.2, 0.8, (1000, 1)) * way + off[:, None] * side
    points[:, 1] = random.uniform(0.1, 0.9, 1000)
    labels = sw.classify(sw.GeneralSweep(SQUARE, sw.trajectories.Line(end=tuple(way))), points, tolerance)
    assert (labels == np.tile([1, 0, 0, -1], 250)).all()


@pytest.mark.thorough
@pytest.mark.parametrize("tolerance", TOLERANCES)
def test_a_triangle_turned_about_one_of_its_edges_is_a_part_of_a_cone(tolerance):
    """Carried round by an arc of radius 1, the edge that is in its middle rests: the others leave two cones."""
    arc = sw.trajectories.Arc(1.0, 2.0)
    about = sw.GeneralSweep(SQUARE, arc, frame=sw.frames.FixedUp())
    poses = about.motion.at(np.array([0.0, 1.0, 2.0]))
    rest = np.array([(0.0, 0.0, -0.5), (0.0, 0.0, 0.5)])
    own = np.einsum("ji,kj->ki", poses.matrix[0], np.array([*rest, (1.5, 0.0, 0.0)]) - poses.origin[0])
    assert np.abs(about.motion.posed(own[:2], poses) - rest).max() < 1e-12
    sweep = sw.GeneralSweep(sw.solids.Triangles(own, [(0, 1, 2)]), arc, frame=sw.frames.FixedUp())
    points = np.random.default_rng(5).uniform((-1.6, -1.6, -0.6), (1.6, 1.6, 0.6), (20_000 if FULL else 6_000, 3))
    across, angle = np.hypot(points[:, 0], points[:, 1]), np.arctan2(points[:, 1], points[:, 0])
    cone = (np.abs(points[:, 2]) * 3 + across - 1.5) / np.sqrt(10)
    ends = np.maximum(-across * np.sin(angle), across * np.sin(angle - 2))  # both half planes; the part is convex
    far, band = np.maximum(cone, ends), tolerance or 1e-8
    labels = sw.classify(sweep, points, tolerance)
    inside, outside = far < -1.5 * band, far > 3 * band
    assert (labels[inside] == 1).all()
    assert (labels[outside] == -1).all()
    assert inside.any() and outside.any()


@pytest.mark.thorough
def test_a_square_round_a_circle_is_a_ring_without_ends():
    arc = sw.trajectories.Arc(2.0, 2 * pi)
    square = sw.solids.Triangles(SQUARE.vertices.values - (0.5, 0.5, 0), SQUARE.faces)
    ring = sw.GeneralSweep(square, arc, frame="rotation-minimizing")
    points = np.random.default_rng(6).uniform((-2.7, -2.7, -0.7), (2.7, 2.7, 0.7), (20_000 if FULL else 6_000, 3))
    points[:4000, 1] *= points[:4000, 0] < 0  # in the plane in which it begins
    far = np.maximum(np.abs(np.hypot(points[:, 0], points[:, 1]) - 2), np.abs(points[:, 2])) - 0.5
    labels = sw.classify(ring, points)
    assert (labels == np.sign(-far)).all()
    beside = points[np.abs(far) < 0.2]
    wide = sw.classify(ring, beside, 0.05)
    far = far[np.abs(far) < 0.2]
    assert (wide[far < -0.08] == 1).all() and (wide[np.abs(far) < 0.02] == 0).all() and (wide[far > 0.15] == -1).all()


def test_what_slides_in_itself_leaves_nothing_inside():
    points = np.random.default_rng(7).uniform(-0.5, 2.5, (500, 3)) * (1, 0.8, 0)
    labels = sw.classify(sw.GeneralSweep(SQUARE, sw.trajectories.Line(end=(1, 0, 0))), points, 1e-3)
    x, y, _ = points.T
    beyond = np.maximum(np.abs(x - 1) - 1, np.abs(y - 0.5) - 0.5)
    assert (labels[beyond < 0] == 0).all() and (labels[beyond > 2e-3] == -1).all()
    off = points + (0, 0, 0.01)
    assert (sw.classify(sw.GeneralSweep(SQUARE, sw.trajectories.Line(end=(1, 0, 0))), off, 1e-3) == -1).all()


def test_where_two_stretches_of_the_way_meet_no_membrane_is_left():
    """Up, aside and down again beside where it came from: the last face of one way is a side of the other."""
    way = sw.trajectories.Polyline([(0, 0, 0), (0, 0, 1), (1, 0, 1), (1, 0, 0)])
    points = np.array(
        [(1.0, 0.5, 0.5), (1.0, 0.3, 0.2), (0.5, 0.5, 0.5), (1.5, 0.5, 0.5), (2.0, 0.5, 0.5), (0.5, 0.5, 1.0)]
    )
    labels = sw.classify(sw.GeneralSweep(SQUARE, way), points, 1e-6)
    assert labels.tolist() == [1, 1, 1, 1, 0, 0]


@pytest.mark.thorough
@pytest.mark.parametrize("scale_z", [1.0, 0.2])
def test_a_square_that_grows_leaves_a_frustum(scale_z):
    own = sw.solids.Triangles(SQUARE.vertices.values - (0.5, 0.5, 0), SQUARE.faces)
    scales = {"scale_x": "0.5 + 0.5*t", "scale_y": "0.5 + 0.5*t", "scale_z": scale_z}
    points = np.random.default_rng(8).uniform((-0.6, -0.6, -0.1), (0.6, 0.6, 1.1), (5_000, 3))
    half = 0.25 + 0.25 * points[:, 2]
    far = np.maximum((np.abs(points[:, :2]).max(axis=1) - half) / np.hypot(1, 0.25), np.abs(points[:, 2] - 0.5) - 0.5)
    for tolerance in (None, 1e-3):
        band = tolerance or 1e-8
        labels = sw.classify(sw.GeneralSweep(own, UP, **scales), points, tolerance)
        assert (labels == np.sign(-far))[np.abs(far) > 2 * band].all()
        assert (labels[(np.abs(far) < 0.4 * band)] == 0).all()


CARRIED = {
    "a wave that turns": sw.GeneralSweep(SHEETS["a wave"], sw.trajectories.Arc(1.0, 2.0), turn_x="t", turn_z="2*t"),
    "half a cylinder in a frame": sw.GeneralSweep(
        SHEETS["half a cylinder"], sw.trajectories.Helix(1.0, 1.5, 0.6), frame="frenet"
    ),
    "an angle that is scaled": sw.GeneralSweep(
        SHEETS["an angle"], UP, scale_x="1 - 0.5*t", scale_y="1 + t", turn_y=0.4
    ),
    "a square that is mirrored": sw.GeneralSweep(SQUARE, sw.trajectories.Arc(), scale_x="1 - 2*t", turn_y="1.5*t"),
}


@pytest.mark.thorough
@pytest.mark.parametrize("name", CARRIED)
def test_a_carried_sheet_visits_what_chords_of_the_way_back_meet(name):
    """The ways of points, seen from the sheet, in 251 chords: nearer than 1e-4 to the ways."""
    shape, steps = CARRIED[name], 251
    vertices = shape.generator.vertices.values
    poses = shape.motion.at(np.linspace(0.0, shape.trajectory.length(), steps + 1))
    places = shape.motion.posed(vertices, poses)
    points = np.random.default_rng(9).uniform(places.min(axis=(0, 1)), places.max(axis=(0, 1)), (150, 3))
    back = np.einsum("nij,nkj->nki", np.linalg.inv(poses.matrix), points - poses.origin[:, None])
    corners = vertices[shape.generator.faces.values.astype(int)]
    visited = np.zeros(len(points), dtype=bool)
    for here, there in zip(back[:-1], back[1:], strict=True):
        visited |= hit(here, there - here, corners)
    assert (sw.classify(shape, points) == np.where(visited, 1, -1)).all()
    assert visited.any() and not visited.all()


def test_a_moving_sheet_is_where_its_mesh_is():
    """A wave that turns about the line along which it moves: its mesh meets itself nowhere, and chords are short."""
    shape = sw.GeneralSweep(SHEETS["a wave"], UP, turn_z="t", samples=sw.sampling.Count(200))
    body = MeshBody(shape.mesh())
    points = np.random.default_rng(9).uniform(*body.box, (5_000, 3))
    far = body.distance(points)
    clear = np.abs(far) > 2e-3
    assert (sw.classify(shape, points) == np.sign(-far))[clear].all()


@pytest.mark.thorough
def test_a_tube_without_ends_that_moves_across_is_its_skins_way():
    """An open tube along y moved along x: points of its first and last hollow that no skin meets are out."""
    rod = sw.GeneralizedCylinder(
        sw.contours.Circle(0.3, 128), sw.trajectories.Line(start=(0, -1, 0), end=(0, 1, 0)), start="open", end="open"
    )
    shape = sw.SweptSolid(rod, sw.trajectories.Line(end=(0.4, 0, 0)))
    points = np.random.default_rng(10).uniform((-0.4, -1.1, -0.4), (0.8, 1.1, 0.4), (5_000, 3))
    x, y, z = points.T
    half = np.sqrt(np.maximum(0.3**2 - z**2, 0))
    skins = ((x > half) & (x < half + 0.4)) | ((x > -half) & (x < 0.4 - half))
    inside = skins & (np.abs(y) < 1) & (np.abs(z) < 0.3)
    off = np.minimum.reduce([np.abs(np.hypot(x - a, z) - 0.3) for a in (0, 0.4)])
    clear = (off > 1e-3) & (np.abs(np.abs(z) - 0.3) > 1e-3) & (np.abs(np.abs(y) - 1) > 1e-6)
    assert (sw.classify(shape, points) == np.where(inside, 1, -1))[clear].all()


@pytest.mark.thorough
def test_what_a_sheet_leaves_may_move_once_more_and_be_an_operand():
    """A square moved up and then aside is a block; less another block it is an angle."""
    twice = sw.SweptSolid(sw.SweptSolid(SQUARE, UP), sw.trajectories.Line(end=(1, 0, 0)))
    points = np.random.default_rng(11).uniform((-0.2, -0.2, -0.2), (2.2, 1.2, 1.2), (300 if FULL else 60, 3))
    far = (np.abs(points - (1, 0.5, 0.5)) - (1, 0.5, 0.5)).max(axis=1)
    clear = np.abs(far) > 2e-3
    assert (sw.classify(twice, points, 1e-3) == np.sign(-far))[clear].all()
    less = sw.SweptSolid(SQUARE, UP) - sw.solids.Block(1.0, 3.0, 3.0)
    far = np.maximum((np.abs(points - 0.5) - 0.5).max(axis=1), 0.5 - points[:, 0])
    assert (sw.classify(less, points) == np.sign(-far)).all()


@pytest.mark.parametrize("tolerance", [1e-6, 0.02])
def test_with_open_ends_a_square_leaves_the_sides_of_a_block(tolerance):
    """And where one end is flat, its face there."""
    points = np.random.default_rng(12).uniform(-0.2, 1.2, (3_000, 3))
    points[:600, 0] = 1.0
    points[600:1200, 2] = 0.0
    x, y, z = points.T
    level = np.maximum(np.maximum(-z, z - 1), 0)
    edges = np.maximum(np.abs(x - 0.5), np.abs(y - 0.5)) - 0.5
    out = np.hypot(np.maximum(np.abs(x - 0.5) - 0.5, 0), np.maximum(np.abs(y - 0.5) - 0.5, 0))
    sides = np.hypot(np.where(edges > 0, out, -edges), level)
    floor = np.hypot(out, z)
    for start, far in (("open", sides), ("flat", np.minimum(sides, floor))):
        labels = sw.classify(sw.GeneralSweep(SQUARE, UP, start=start, end="open"), points, tolerance)
        assert (labels[far < 0.5 * tolerance] == 0).all()
        assert (labels[far > 1.5 * tolerance] == -1).all()
        assert (labels == 0).sum() > 300


@pytest.mark.thorough
def test_vertices_of_a_surface_that_an_open_sweep_leaves_are_on():
    scaled = {"scale_x": "1 - 0.5*t", "turn_z": "t", "deform_z": "z + 0.3*t*x*(1 - x)"}
    shape = sw.GeneralSweep(SHEETS["a wave"], sw.trajectories.Arc(1.0, 2.0), start="open", end="open", **scaled)
    vertices = shape.mesh().vertices
    vertices = vertices[:: max(len(vertices) // 200, 1)]
    assert (sw.classify(shape, vertices, 1e-7) == 0).all()
    assert (sw.classify(shape, vertices + (0, 0, 5.0), 1e-7) == -1).all()


def test_triangles_that_share_places_and_no_vertices_are_one_sheet():
    """As a file of loose triangles has them: no rim is left between them."""
    wave = SHEETS["a wave"]
    places = wave.vertices.values[wave.faces.values.astype(int)].reshape(-1, 3)
    loose = sw.solids.Triangles(places, np.arange(len(places)).reshape(-1, 3))
    points = np.random.default_rng(13).uniform(-0.3, 1.3, (2_000, 3))
    points[:100] = places[::6] + (0, 0, 0.5)  # their ways lead through vertices
    visited = hit(points, np.array((0.0, 0.0, -1.0)), wave.vertices.values[wave.faces.values.astype(int)])
    labels = sw.classify(sw.GeneralSweep(loose, UP), points)
    assert (labels == np.where(visited, 1, -1))[100:].all()
    inner = (np.abs(points[:100, :2] - 0.5) < 0.45).all(axis=1)
    assert (labels[:100][inner] == 1).all() and inner.sum() > 30

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Legs end in the planes of their mitres, however they bend and however short they are: formulas of both."""

from math import cos, pi, radians, sin, sqrt

import numpy as np
import pytest

import sweep_addon as sw
from sweep_addon.core.meshes.facets import facets

RADIUS, WIDTH, HEIGHT = 2.0, 0.6, 0.3


def labels(mesh, points):
    """What the mesh of a solid has inside, by itself."""
    return sw.classify(sw.solids.Triangles(mesh.vertices, facets(mesh)[0]), points)


def climbing(turn, climb):
    """Two exact quarters of circles with a corner between, the second rising; its first tangent and normal."""
    away = np.array([sin(turn), cos(turn), 0])
    onward, up = cos(climb) * away + (0, 0, sin(climb)), -sin(climb) * away + (0, 0, cos(climb))
    points = RADIUS * np.array([(-1, -1, 0), (0, -1, 0), (0, 0, 0), onward, onward + up])
    path = sw.trajectories.Nurbs(points, [1, sqrt(0.5), 1, sqrt(0.5), 1], 3, [0, 0, 0, 1, 1, 2, 2, 2])
    return path, onward, up


def beside_an_arc(onward, up):
    """How far points (3,) + ... are above an arc that leaves the origin and bends up, or its tangent backward."""

    def height(points):
        forward, rise = points @ onward, points @ up
        return np.where(forward > 0, RADIUS - np.hypot(forward, RADIUS - rise), rise)

    return height


@pytest.mark.parametrize("frame", ["fixed-up", "frenet"])
@pytest.mark.parametrize("turn, climb", [(90, 0.0), (90, 0.3), (90, 0.8), (150, 0.3), (-60, 1.2)])
def test_bar_is_two_rings_cut_off_in_the_plane_of_their_mitre(turn, climb, frame):
    """Each leg is what a rectangle leaves about the axis of its circle, and goes straight on to the mitre's plane."""
    path, onward, up = climbing(radians(turn), climb)
    bar = sw.GeneralizedCylinder(sw.contours.Rectangle(WIDTH, HEIGHT), path, sw.sampling.Tolerance(2e-4), frame)
    p = np.random.default_rng(0).uniform(-0.7, 0.7, (40_000, 3))
    first = p @ ((0, 1, 0) + onward) < 0
    aside = beside_an_arc(np.array([0, -1.0, 0]), np.array([-1.0, 0, 0]))(p)
    one = first & (np.abs(aside) < WIDTH / 2) & (np.abs(p[:, 2]) < HEIGHT / 2)
    above, across = beside_an_arc(onward, up)(p), p @ np.cross(onward, up)
    tall, wide = (
        (HEIGHT, WIDTH) if frame == "fixed-up" else (WIDTH, HEIGHT)
    )  # Frenet's first axis is towards the centre
    other = ~first & (np.abs(above) < tall / 2) & (np.abs(across) < wide / 2)
    assert ((sw.classify(bar, p) > 0) == (one | other)).all() and (one | other).sum() > 3000
    pytest.importorskip("manifold3d", reason="legs are cut off by a boolean")
    solid = bar.solid()
    assert ((labels(solid, p) > 0) != (one | other)).mean() < 4e-4
    assert len(solid.boundary_edges()) == len(solid.non_manifold_edges()) == 0


SHORT = {
    "a needle": [(0, 0, 0), (1, 0, 0), (0.9, 0.02, 0)],
    "a long needle": [(0, 0, 0), (1, 0, 0), (0, 0.1, 0)],
    "a short leg amid": [(0, 0, 0), (1, 0, 0), (0.9, 0.02, 0), (0.95, 0.3, 0)],
    "a step": [(0, 0, 0), (1, 0, 0), (0.97, 0.01, 0), (1.2, 0.3, 0.1)],
    "two short legs": [(0, 0, 0), (1, 0, 0), (1.05, 0.02, 0), (1, 0.04, 0), (0, 0.04, 0.3)],
}


def cut_prisms(points, radius, p):
    """Which of some places are between the mitres of a leg, or its flat end, and no farther from its line."""
    points, found = np.array(points), np.full(len(p), False)
    ways = np.diff(points, axis=0)
    ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    normals = np.concatenate((ways[:1], ways[1:] + ways[:-1], ways[-1:]))
    for start, end, way, low, high in zip(points[:-1], points[1:], ways, normals[:-1], normals[1:], strict=True):
        away = p - start
        on = np.linalg.norm(away - (away @ way)[:, None] * way, axis=1) < radius
        found |= on & (away @ low > 0) & ((p - end) @ high < 0)
    return found


@pytest.mark.thorough
@pytest.mark.parametrize("points", SHORT.values(), ids=SHORT)
def test_legs_shorter_than_their_mitres_are_what_both_mitres_leave(points):
    rod = sw.GeneralizedCylinder(sw.contours.Circle(0.1, points=128), sw.trajectories.Polyline(points))
    corners = rod.mesh().vertices
    p = np.random.default_rng(0).uniform(corners.min(axis=0), corners.max(axis=0), (40_000, 3))
    true = cut_prisms(points, 0.1, p)
    assert ((sw.classify(rod, p) > 0) == true).all() and true.sum() > 2000
    pytest.importorskip("manifold3d", reason="legs are cut off by a boolean")
    inside = labels(rod.solid(), p) > 0
    chords = 1 - sin(2 * pi / 128) / (2 * pi / 128)  # of the area: what 128 points leave out
    assert (inside & ~true).sum() <= 2 and (true & ~inside).sum() < 3 * chords * true.sum()

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""No point of the true sweep is outside a circumscribed mesh, however coarse, whichever way its faces are split."""

import numpy as np
import pytest
from solids import assert_solid

from sweep_addon.core.contours import Circle, Ellipse, Fit, Outline, Rectangle
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.stations.frames import FixedUp, Frenet, RotationMinimizing
from sweep_addon.core.stations.sampling import Count, Tolerance
from sweep_addon.core.trajectories import Arc, Bezier, Formula, Helix, Line, Polyline, TorusKnot

RING, KNOT = Arc(2.0, 2 * np.pi), TorusKnot(2, 3, 2.0, 0.8)
ANGLE = Outline([[(0, 0), (0.4, 0), (0.4, 0.1), (0.1, 0.1), (0.1, 0.3), (0, 0.3)]])
PIPE = Outline([[(-0.3, 0), (0.3, 0)], [(-0.2, 0), (0.2, 0)]], [[1, 1], [-1, -1]], tolerance=0.01)
BELLY = "1 + 0.3*sin(2*pi*t)"
INFLECTED = Formula("u", "u^3", "u^4", -1, 1)
HOOK = Bezier([(0, 0, 0), (1, 2, 0), (2, 2, 1), (3, 0, 0), (3.5, 2, 0), (4, 2, -1), (6, 0, 0)])
LEGS = Polyline([(0, 0, 0), (5, 0, 0), (5, 5, 1), (0, 3, 0)])
CASES = {
    "coarse ring": (Circle(0.5, 16), RING, Count(7), {}),
    "ring": (Circle(0.5, 9), RING, Count(30), {}),
    "tube near its radius of curvature": (Circle(0.9, 12), Arc(1.0, 2 * np.pi), Count(24), {}),
    "knot": (Circle(0.3, 16), KNOT, Count(48), {}),
    "adaptive knot": (Circle(0.3, 5), KNOT, Tolerance(0.02), {}),
    "twisted": (Rectangle(0.3, 0.5), KNOT, Count(72), {"twist": "4*pi*t"}),
    "two laws": (Circle(0.3, 8), Helix(2.0, 2.0, 1.0), Count(12), {"scale_x": BELLY, "scale_y": "exp(-t)"}),
    "inflected": (Circle(0.1, 16), INFLECTED, Count(11), {}),
    "angle": (ANGLE, RING, Count(14), {}),
    "mirrored angle": (ANGLE, RING, Count(14), {"scale_x": -1.0}),
    "beside": (Ellipse(0.2, 0.1, 12), Helix(1.0, 2.0, 1.0), Count(24), {"offset_x": "0.3", "twist": "2*pi*t"}),
    "level": (Rectangle(0.3, 0.1, 0.02, corner_points=3), Helix(1.0, 2.0, 1.0), Count(24), {"frame": FixedUp()}),
    "frenet": (Rectangle(0.3, 0.1), Helix(1.0, 2.0, 1.0), Count(24), {"frame": Frenet()}),
    "corner between bends": (Circle(0.1, 8), HOOK, Count(24), {}),
    "corners": (Ellipse(0.3, 0.1, 12), LEGS, Tolerance(0.01), {}),
    "band of one side": (Rectangle(0.4, 0.1), RING, Count(24), {"frame": RotationMinimizing(extra_sectors=1)}),
    "square and a quarter": (Rectangle(0.2, 0.2), KNOT, Count(72), {"frame": RotationMinimizing(0, -3)}),
    "mirrored quarter": (Rectangle(0.2, 0.2), RING, Count(24), {"scale_x": -1.0, "twist": "pi/2*t"}),
    "pipe": (PIPE, Arc(3.0, 2.0), Count(13), {}),
}


def true_points(contour, trajectory, count, others):
    """Points of the true surface between its ends: the curve as very many points, at very many stations."""
    finer = {"points": 60, "corner_points": 12, "tolerance": 1e-6}
    known = {name: many for name, many in finer.items() if hasattr(contour, name)}
    fine = GeneralizedCylinder(type(contour)(**vars(contour) | known), trajectory, Count(count), **others).mesh()
    rings = fine.vertices.reshape(-1, fine.rings, 3)
    points = (rings if trajectory.closed else rings[:, 1:-1]).reshape(-1, 3)
    return np.random.default_rng(5).permutation(points)[:3000]


def winding(mesh, points, first):
    """How often a mesh winds round points, its faces split from one corner or the next: van Oosterom, Strackee 1983."""
    faces = [np.roll(mesh.corners[i:j], -first) for i, j in zip(mesh.offsets[:-1], mesh.offsets[1:], strict=True)]
    triangles = np.array([(face[0], *face[i : i + 2]) for face in faces for i in range(1, len(face) - 1)])
    a, b, c = mesh.vertices[triangles.T]
    volume, normal = (a * np.cross(b, c)).sum(1), np.cross(b - a, c - a)  # products of differences, multiplied out
    turns = []
    for part in np.array_split(points, len(points) * len(triangles) // 100_000 + 1):
        la, lb, lc = np.linalg.norm(part[:, None] - mesh.vertices, axis=2)[:, triangles.T].swapaxes(0, 1)
        ab, bc, ca = (
            (p * q).sum(1) - part @ (p + q).T + (part**2).sum(1)[:, None] for p, q in ((a, b), (b, c), (c, a))
        )
        cosine = la * lb * lc + ab * lc + bc * la + ca * lb
        turns.append(np.arctan2(volume - part @ normal.T, cosine).sum(axis=1) / (2 * np.pi))
    return np.concatenate(turns)


@pytest.mark.thorough
@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("first", [0, 1])
def test_the_true_surface_lies_within_the_mesh(name, first):
    contour, trajectory, samples, others = CASES[name]
    mesh = GeneralizedCylinder(contour, trajectory, samples, **others, fit=Fit.CIRCUMSCRIBED).mesh()
    points = true_points(contour, trajectory, 7 * mesh.rings, others)
    assert winding(mesh, points, first).min() > 0.5
    inscribed = GeneralizedCylinder(contour, trajectory, samples, **others).mesh()
    assert winding(inscribed, points, first).min() < 0.5 or trajectory is LEGS


@pytest.mark.parametrize("trajectory", [RING, KNOT, Helix(2.0, 2.0, 1.0), INFLECTED], ids=lambda t: type(t).__name__)
def test_what_it_holds_beyond_the_true_sweep_falls_by_the_square_of_the_steps(trajectory):
    contour = Circle(0.2, 500)

    def beyond(steps):
        count = Count(steps + (not trajectory.closed))
        mesh = GeneralizedCylinder(contour, trajectory, count, fit=Fit.CIRCUMSCRIBED).mesh()
        return mesh.volume() / (contour.area * trajectory.length()) - 1

    assert 3.5 < beyond(64) / beyond(128) < 4.6 and 3.5 < beyond(128) / beyond(256) < 4.6


@pytest.mark.parametrize("contour", [Circle(0.2, 7), Rectangle(0.3, 0.2, 0.05), PIPE])
def test_straight_legs_are_no_thicker_than_the_contour_that_holds_the_curve(contour):
    """Mitres included: area of the circumscribed polygon times length."""
    mesh = GeneralizedCylinder(contour, LEGS, Count(40), fit=Fit.CIRCUMSCRIBED).mesh()
    straight = GeneralizedCylinder(contour, Line(end=(0, 0, 1)), Count(2), fit=Fit.CIRCUMSCRIBED).mesh()
    assert mesh.volume() == pytest.approx(straight.volume() * LEGS.length(), rel=1e-9)
    assert straight.volume() > contour.area


def test_a_bend_does_not_thicken_a_leg_a_step_away():
    pole = Bezier([(-9, 0, 0), (-6, 0, 0), (-3, 0, 0), (0, 0, 0), (1, 0, 0), (1, 0, 0), (1, 1, 0)])
    mesh = GeneralizedCylinder(Circle(0.2, 8), pole, Count(60), fit=Fit.CIRCUMSCRIBED).mesh()
    ring = mesh.vertices.reshape(8, 60, 3)[:, 0]
    assert np.linalg.norm(ring - (-9, 0, 0), axis=1) == pytest.approx(0.2 / np.cos(np.pi / 8), abs=1e-12)


@pytest.mark.parametrize("law", ["sin(pi*t)", "abs(1 - 2*t)", "1 - t"])
def test_tips_stay_tips(law):
    mesh = GeneralizedCylinder(
        Circle(0.2, 8), Helix(2.0, 2.0, 1.0), Count(21), scale_x=law, scale_y=law, fit=Fit.CIRCUMSCRIBED
    ).mesh()
    assert_solid(mesh, euler=2 if law != "abs(1 - 2*t)" else 3)


@pytest.mark.parametrize("fit", Fit)
def test_round_ends_close_every_fit(fit):
    mesh = GeneralizedCylinder(
        Circle(0.2, 8), Helix(2.0, 2.0, 1.0), Count(21), start="round", end="round", fit=fit
    ).mesh()
    assert_solid(mesh, euler=2)


def test_a_hole_without_room_is_refused():
    narrow = Outline([[(-0.3, 0), (0.3, 0)], [(-0.02, 0), (0.02, 0)]], [[1, 1], [-1, -1]], tolerance=0.001)
    sentence = "^fit: must not be circumscribed where a hole or a gap has no room for clearances of 0.0"
    with pytest.raises(ShapeError, match=sentence):
        GeneralizedCylinder(narrow, RING, Count(16), fit=Fit.CIRCUMSCRIBED).mesh()
    assert_solid(GeneralizedCylinder(narrow, RING, Count(128), fit=Fit.CIRCUMSCRIBED).mesh(), euler=0)


def test_a_gap_without_room_is_refused():
    horseshoe = [(0, 0), (0.4, 0), (0.4, 0.2), (0.21, 0.2), (0.21, 0.1), (0.19, 0.1), (0.19, 0.2), (0, 0.2)]
    with pytest.raises(ShapeError, match="^fit: must not be circumscribed where a hole or a gap has no room"):
        GeneralizedCylinder(Outline([horseshoe]), RING, Count(12), fit=Fit.CIRCUMSCRIBED).mesh()

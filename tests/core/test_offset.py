# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The offset laws carry the reference point beside the trajectory: as closed forms say, and still a solid."""

from math import sin, tau

import numpy as np
import pytest
from solids import assert_solid, box

from sweep_addon.core.contours import Circle, Outline, Rectangle
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.rings.ends import Taper
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.stations.frames import FixedUp, Frenet, RotationMinimizing
from sweep_addon.core.stations.sampling import Count, Tolerance
from sweep_addon.core.trajectories import Arc, Helix, Line, Polyline, TorusKnot

RING = Arc(2.0, tau)  # its first normal points outwards, its first binormal down
FRAMES = [RotationMinimizing(), Frenet(), FixedUp()]


def columns(mesh, count):
    return mesh.vertices.reshape(count, -1, 3)


@pytest.mark.parametrize("turns", [1, -3])
def test_a_constant_offset_with_an_even_twist_is_a_helix(turns):
    """Along a vertical line e2 begins as x and e3 as y: every point is where a rotation about the line puts it."""
    contour = Circle(0.2, points=12)
    shape = GeneralizedCylinder(
        contour, Line(end=(0, 0, 3)), Count(61), twist=f"{turns}*2*pi*t", offset_x=0.9, offset_y=-0.4
    )
    mesh = shape.mesh()
    t = np.linspace(0, 1, 61)
    start = contour.section().points @ (1, 1j) + (0.9 - 0.4j)
    place = start[:, None] * np.exp(1j * tau * turns * t)
    expected = np.stack((place.real, place.imag, np.broadcast_to(3 * t, place.shape)), axis=-1)
    assert np.abs(columns(mesh, 12) - expected).max() < 1e-12
    assert_solid(mesh, euler=2)


@pytest.mark.parametrize("contour", [Circle(0.3, points=9), Rectangle(0.3, 0.5)])
@pytest.mark.parametrize("offset", [0.0, 0.75, -0.75, 1.5, -3.5])
def test_a_ring_has_the_volume_of_pappus(contour, offset):
    """Area times the way of the centroid, 2 pi (R + d); of n contours, n sin(2 pi / n) takes the place of 2 pi.

    Beyond the axis the contour runs backward, and the ring still looks outwards."""
    for samples in (5, 64, 1000):
        mesh = GeneralizedCylinder(contour, RING, Count(samples), offset_x=offset).mesh()
        expected = contour.section().area * samples * sin(tau / samples) * abs(2 + offset)
        assert mesh.volume() == pytest.approx(expected, rel=1e-11)
        assert_solid(mesh, euler=0)
        assert mesh.told == ()


@pytest.mark.parametrize("centre", [-5.0, -1.0, 1.0])
@pytest.mark.parametrize("laws", [{}, {"scale_x": -1.0}, {"offset_x": 0.5}])
def test_a_contour_drawn_beyond_the_axis_looks_outwards_as_well(centre, laws):
    contour = Outline([box((centre - 0.2, -0.1), (centre + 0.2, 0.5))])
    mesh = GeneralizedCylinder(contour, RING, Count(64), **laws).mesh()
    middle = 2 + laws.get("scale_x", 1) * centre + laws.get("offset_x", 0)
    assert mesh.volume() == pytest.approx(0.24 * 64 * sin(tau / 64) * abs(middle), rel=1e-11)
    assert_solid(mesh, euler=0)
    assert mesh.told == ()


def test_an_offset_on_both_sides_of_the_axis_is_told():
    mesh = GeneralizedCylinder(Circle(0.1), RING, Count(64), offset_x="-2 + 1.5*cos(2*pi*t)").mesh()
    folds = ("u = 1.504 to 1.638", "u = 4.646 to 4.779")  # where 1.5 cos(u) is 0.1 or less in size
    said = [
        f"Self-intersection: from {u} the contour reaches the centre of curvature, and the sweep folds." for u in folds
    ]
    assert list(mesh.told) == said


def test_an_offset_moves_along_the_axes_and_is_not_scaled():
    shape = GeneralizedCylinder(
        Circle(0.1, points=8), Line(end=(0, 0, 2)), Count(50), scale_x="1 + t", scale_y="-1 - t",
        offset_x="sin(3*t)", offset_y=[(0, 0), (1, 2)],
    )  # fmt: skip
    middles = columns(shape.mesh(), 8).mean(axis=0)
    t = np.linspace(0, 1, 50)
    assert np.abs(middles - np.stack((np.sin(3 * t), 2 * t, 2 * t), axis=1)).max() < 1e-12


def test_a_tip_moves_with_the_offset():
    mesh = GeneralizedCylinder(Circle(0.1), Line(), end=Taper(0.5), offset_x="t", offset_y=0.25).mesh()
    assert mesh.vertices[-1] == pytest.approx((1.0, 0.25, 1.0), abs=1e-12)
    assert_solid(mesh, euler=2)


def test_an_offset_is_that_of_the_contour_where_nothing_scales_it():
    """Beside mitred corners too, so that every column still runs along its legs."""
    corners = np.random.default_rng(8).normal(size=(30, 3)).cumsum(axis=0)
    moved = Outline([box((0.03, -0.02), (0.06, 0.01))])
    for trajectory in (Polyline(corners), Polyline(corners, closed=True), TorusKnot(), Helix()):
        aside = GeneralizedCylinder(
            Outline([box((0, 0), (0.03, 0.03))]), trajectory, offset_x=0.03, offset_y=-0.02, twist=0.3
        ).mesh()
        expected = GeneralizedCylinder(moved, trajectory, twist=0.3).mesh()
        assert np.abs(aside.vertices - expected.vertices).max() < 1e-12
        assert aside.topology is expected.topology


@pytest.mark.parametrize("frame", FRAMES)
@pytest.mark.parametrize("offset", ["0.2", "0.1*sin(2*pi*t)", "0.2*cos(6*pi*t)"])
def test_an_offset_sweep_is_a_solid(frame, offset):
    """Offsets that stay within the radius of curvature turn nothing inside out."""
    laws = {"twist": "4*pi*t", "offset_x": offset, "offset_y": "-" + offset}
    assert_solid(GeneralizedCylinder(Circle(0.05), TorusKnot(2, 3, 2.0, 0.8), frame=frame, **laws).mesh(), euler=0)
    assert_solid(GeneralizedCylinder(Circle(0.05), Helix(2.0, 1.0, 1.5), frame=frame, **laws).mesh(), euler=2)


@pytest.mark.parametrize("tolerance", [1e-3, 1e-4])
@pytest.mark.parametrize(
    ("laws", "place"),
    [
        ({"offset_x": "0.5*sin(9*t)"}, lambda t: 0.5 * np.sin(9 * t)),
        ({"offset_x": 2.0, "twist": "7*t^2"}, lambda t: 2 * np.exp(7j * t**2)),
        ({"offset_x": "3*t", "offset_y": "t^2", "twist": "4*t"}, lambda t: (3 * t + 1j * t**2) * np.exp(4j * t)),
    ],
)
def test_the_reference_point_keeps_within_the_tolerance(laws, place, tolerance):
    mesh = GeneralizedCylinder(Circle(0.001, points=3), Line(), Tolerance(tolerance), **laws).mesh()
    corners = columns(mesh, 3).mean(axis=0)
    t = np.linspace(0, 1, 100_001)
    points = np.stack((place(t).real, place(t).imag, t), axis=1)
    steps = np.diff(corners, axis=0)
    within = np.clip(np.searchsorted(corners[:, 2], t) - 1 + np.array([[-1], [0], [1]]), 0, len(steps) - 1)
    away = points - corners[within]
    share = np.einsum("aij,aij->ai", away, steps[within]) / np.einsum("ij,ij->i", steps, steps)[within]
    apart = np.linalg.norm(away - share.clip(0, 1)[..., None] * steps[within], axis=2).min(axis=0)
    assert 0.5 * tolerance < apart.max() <= 2 / 3**0.5 * tolerance


def test_no_offset_is_the_same_to_the_last_bit():
    for shape in (GeneralizedCylinder(), GeneralizedCylinder(Rectangle(0.1, 0.2), TorusKnot(), twist="2*pi*t")):
        laws = {"offset_x": "0*t", "offset_y": [(0, 0), (1, 0)]}
        same = GeneralizedCylinder(shape.contour, shape.trajectory, twist=shape.twist, **laws)
        assert np.array_equal(shape.mesh().vertices, same.mesh().vertices)


@pytest.mark.parametrize("far", [1e3, 1e6])
def test_texture_and_attributes_are_those_of_the_trajectory(far):
    plain, aside = (GeneralizedCylinder(trajectory=Line(), offset_y=y).mesh() for y in (0.0, far))
    assert np.array_equal(plain.uv, aside.uv)
    assert all(np.array_equal(plain.attributes[name], aside.attributes[name]) for name in plain.attributes)


REFUSED = {
    "offset_x: must be a number of metres, got nan": {"offset_x": float("nan")},
    "offset_y: must be a number of metres, got inf": {"offset_y": float("inf")},
    "offset_x: must be at most 1e+12 in size, got 1e+13": {"offset_x": 1e13},
    "offset_x: must be at most 1e+12 in size, got 1e+300": {"offset_x": "1e300*t"},
    "offset_x: must be finite everywhere, got nan at u = 0, t = 0, s = 0": {"offset_x": "log(-t - 1)"},
    "offset_y: must be finite everywhere, got inf at u = 1, t = 1, s = 1": {"offset_y": "1/(1 - t)"},
    "offset_x: must be the same at both ends of a closed trajectory, 0, got 1": {
        "offset_x": "t", "trajectory": TorusKnot()
    },
    "offset_y: must be the same at both ends of a closed trajectory, 0, got 1e-06": {
        "offset_x": "sin(2*pi*t)", "offset_y": "1e-6*t", "trajectory": TorusKnot()
    },
    "contour: must reach 1 m or more on this trajectory, got 0.1": {"offset_x": 1e12},
}  # fmt: skip


@pytest.mark.parametrize("sentence", REFUSED)
def test_an_offset_that_will_not_do_is_refused(sentence):
    with pytest.raises(ShapeError) as caught:
        GeneralizedCylinder(**{"trajectory": Line()} | REFUSED[sentence]).mesh()
    assert str(caught.value) == sentence


def test_rounding_of_an_offset_that_comes_back_is_no_difference():
    mesh = GeneralizedCylinder(Circle(0.05), TorusKnot(), offset_x=f"sin({tau}*t)/5", offset_y="cos(2*pi*t)/5").mesh()
    assert_solid(mesh, euler=0)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a curve itself carries: at each of its points a radius, which scales the contour, and a tilt, which turns it."""

import numpy as np
import pytest

from sweep_addon import GeneralizedCylinder, dump, load
from sweep_addon.core.contours import Circle, Rectangle
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.shapes.canal_surface import CanalSurface
from sweep_addon.core.stations.sampling import Tolerance
from sweep_addon.core.trajectories import Bezier, Nurbs, Polyline, Sampled

LINE = [(0, 0, 0), (0, 0, 1), (0, 0, 2), (0, 0, 3)]  # of one cubic, evenly spaced: u is the height over 3
RING = [(1, 0, 0), (1, 1.3, 0), (-1, 1.3, 0), (-1, 0, 0), (-1, -1.3, 0), (1, -1.3, 0)]  # two knots


def frustum(area, height, ratio):
    """The volume of a cone's frustum whose base has this area."""
    return area * height * (1 + ratio + ratio**2) / 3


@pytest.mark.parametrize(
    "trajectory",
    [
        Polyline([(0, 0, 0), (0, 0, 3)], radii=[1, 0.4]),
        Bezier(LINE, radii=[1, 0.4]),
        Nurbs(LINE, radii=[1, 0.8, 0.6, 0.4]),  # blended as the heights are
        Sampled(LINE, radii=[1, 0.8, 0.6, 0.4]),
    ],
)
def test_radii_make_a_cone(trajectory):
    mesh = GeneralizedCylinder(Circle(0.5, points=24), trajectory).mesh()
    area = Circle(0.5, points=24).section().area
    assert mesh.volume() == pytest.approx(frustum(area, 3, 0.4), rel=1e-9)
    assert len(mesh.boundary_edges()) == len(mesh.non_manifold_edges()) == 0


def test_radii_have_a_contour_at_each_knot_and_multiply_the_scale():
    """Two frustums and no cone between them: the radius bends at once."""
    trajectory = Polyline([(0, 0, 0), (0, 0, 1), (0, 0, 3)], radii=[1, 0.25, 0.5])
    area = Circle(0.5, points=24).section().area
    wanted = frustum(area, 1, 0.25) + frustum(area * 0.25**2, 2, 2.0)
    for scale in (1.0, 3.0):
        mesh = GeneralizedCylinder(Circle(0.5, points=24), trajectory, scale_x=scale, scale_y=scale).mesh()
        assert mesh.volume() == pytest.approx(scale**2 * wanted, rel=1e-9)


def test_a_radius_of_zero_closes_the_end_in_one_vertex():
    mesh = GeneralizedCylinder(Circle(0.5, points=24), Bezier(LINE, radii=[1, 0])).mesh()
    assert mesh.volume() == pytest.approx(frustum(Circle(0.5, points=24).section().area, 3, 0), rel=1e-9)
    assert mesh.euler_characteristic() == 2 and np.isclose(mesh.vertices, (0, 0, 3)).all(axis=1).sum() == 1


def test_tilts_turn_as_an_equal_twist_does():
    shape = GeneralizedCylinder(Rectangle(1, 0.2), Polyline([(0, 0, 0), (0, 0, 3)]), twist="0.3 + 1.2*t")
    tilted = Polyline([(0, 0, 0), (0, 0, 3)], tilts=[0.3, 1.5])
    assert np.allclose(GeneralizedCylinder(Rectangle(1, 0.2), tilted).mesh().vertices, shape.mesh().vertices)


def test_radii_of_a_spline_are_blended_as_its_points_are():
    """A spline whose radii are the heights of its control points carries its height."""
    random = np.random.default_rng(4)
    points, weights = random.uniform(0.5, 2, (7, 3)), random.uniform(1, 2, 7)
    for closed in (False, True):
        spline = Nurbs(points, weights, 4, closed=closed, radii=points[:, 2])
        u = np.linspace(*spline.domain, 50)
        assert spline.carried(u)[0] == pytest.approx(spline.evaluate(u)[:, 2], abs=1e-12)


def test_a_closed_curve_comes_back_to_its_first_radius_and_tilt():
    trajectory = Bezier(RING, closed=True, radii=[1, 2], tilts=[0, 1])
    assert np.allclose(trajectory.carried([0, 0.5, 1, 1.5, 2]), [[1, 1.5, 2, 1.5, 1], [0, 0.5, 1, 0.5, 0]])
    mesh = GeneralizedCylinder(Rectangle(0.2, 0.1), trajectory, Tolerance(0.01)).mesh()
    assert mesh.euler_characteristic() == 0 and len(mesh.boundary_edges()) == 0


@pytest.mark.parametrize("closed", [False, True])
def test_radii_of_a_measured_path_run_smoothly_and_never_beyond_its_points(closed):
    random = np.random.default_rng(7)
    points, radii = random.normal(size=(12, 3)), random.uniform(0, 2, 12).round(1)
    path = Sampled(points, closed, radii)
    first = np.append(radii, radii[0]) if closed else radii
    knots = np.arange(len(first), dtype=float)
    assert np.allclose(path.carried(knots)[0], first, atol=1e-14)
    between = path.carried((knots[:-1, None] + np.linspace(0, 1, 65)).ravel())[0].reshape(-1, 65)
    low, high = np.minimum(first[1:], first[:-1])[:, None], np.maximum(first[1:], first[:-1])[:, None]
    assert ((low - 1e-14 <= between) & (between <= high + 1e-14)).all()
    inner, step = knots[1:-1], 1e-6
    slopes = [(path.carried(inner + step * k)[0] - path.carried(inner)[0]) / (step * k) for k in (-1, 1)]
    assert np.abs(slopes[1] - slopes[0]).max() < 30 * step  # the second derivatives, of up to 6 times the rise


def test_radii_of_points_that_repeat_one_do_not_count():
    path = Sampled([*LINE[:2], *LINE[1:]], radii=[1, 0.8, 5, 0.6, 0.4])
    assert path.carried([0, 1, 2, 3])[0] == pytest.approx([1, 0.8, 0.6, 0.4])
    ring = Sampled([*RING[:1], *RING[2:], RING[0]], closed=True, radii=[1, 2, 3, 4, 5, 9])
    assert ring.carried([0, 4, 5])[0] == pytest.approx([1, 5, 1])


def test_a_ball_follows_the_radii_of_a_measured_path_without_a_kink():
    angle = np.linspace(0, 5, 40)
    path = Sampled(np.stack((np.cos(angle), np.sin(angle), 0 * angle), axis=1), radii=1 + 0.3 * np.sin(2 * angle))
    hose = CanalSurface(path, 0.1)
    assert hose.mesh().told == () and len(hose.self_intersections()) == 0


def test_nothing_carried_moves_nothing():
    plain = GeneralizedCylinder(trajectory=Bezier(LINE[:3] + [(0, 2, 3)])).mesh()
    carried = Bezier(LINE[:3] + [(0, 2, 3)], radii=[1, 1], tilts=[0, 0])
    assert not Bezier().carries and carried.carries
    mesh = GeneralizedCylinder(trajectory=carried).mesh()
    assert np.array_equal(mesh.vertices, plain.vertices)


@pytest.mark.parametrize(
    ("make", "refusal"),
    [
        (lambda: Bezier(LINE, radii=[1]), "radii: must be 2 numbers, one a point, got 1"),
        (lambda: Nurbs(LINE, tilts=[0, 0]), "tilts: must be 4 numbers, one a point, got 2"),
        (lambda: Polyline(LINE, radii=[1, 1, -2, 1]), "radii: must all be at least 0, got -2"),
        (lambda: Sampled(LINE, radii=[1, 1, 1]), "radii: must be 4 numbers, one a point, got 3"),
    ],
)
def test_what_does_not_fit_the_points_is_refused(make, refusal):
    with pytest.raises(ShapeError, match=refusal):
        make()


def test_a_job_holds_what_is_carried():
    shape = GeneralizedCylinder(trajectory=Bezier(LINE, radii=[1, 0.5], tilts=[0, 3]))
    assert load(dump(shape)) == shape

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Inverse sweeping of contours that are deformed: the images that go to a point, and when they do.

Expected are the roots of formulas, and the images of the same motion where another shape makes it without deforming.
"""

import numpy as np
import pytest

import sweep_addon as sw

UP = sw.trajectories.Line(end=(0, 0, 2))
DISC = sw.contours.Circle(0.3)
CURVED = sw.trajectories.Bezier([(0, 0, 0), (0, 0, 0.6), (0, 0.5, 0.8), (0.3, 1, 0.8)])
TAPERED = sw.GeneralSweep(sw.contours.Circle(1.0), UP, deform_x="x*(1 - t/2)", deform_y="y*(1 - t/2)")
FOLDED = sw.GeneralSweep(DISC, UP, deform_z="-3*t^2*(1 + x)")
BOWL = sw.GeneralSweep(sw.contours.Circle(1.0), UP, deform_z="(x^2 + y^2)/2")


def asked(low, high, count=20_000, seed=0):
    return np.random.default_rng(seed).uniform(low, high, (count, 3))


@pytest.mark.thorough
def test_a_taper_that_is_a_formula_has_one_image_for_each_point():
    p = asked((-1, -1, -0.1), (1, 1, 2.1))
    found = sw.inverse_sweep(TAPERED, p)
    images = p[:, :2] / (1 - p[:, 2:] / 4)
    some = np.flatnonzero((np.abs(images) < 1).all(axis=1) & (p[:, 2] > 0) & (p[:, 2] < 2))
    assert np.array_equal(found.point, some) and len(some) > 5000
    np.testing.assert_allclose(found.u, p[some, 2] / 2, atol=1e-12)
    np.testing.assert_allclose(found.images, images[some], atol=1e-12)


@pytest.mark.thorough
def test_images_beside_a_contour_are_told_within_the_box_around_it():
    """Of a thin angle iron most of the box is empty."""
    iron = sw.contours.Outline([[(0, 0), (1, 0), (1, 0.02), (0.02, 0.02), (0.02, 1), (0, 1)]])
    p = asked((0, 0, -0.5), (1, 1, 2.5), 8000)
    found = sw.inverse_sweep(sw.GeneralSweep(iron, UP, deform_z="0.2*sin(12*x)*sin(12*y)"), p)
    t = (p[:, 2] - 0.2 * np.sin(12 * p[:, 0]) * np.sin(12 * p[:, 1])) / 2
    some = np.flatnonzero((t > 0) & (t < 1))
    assert np.array_equal(found.point, some) and len(some) > 4000
    np.testing.assert_allclose(found.u, t[some], atol=1e-12)
    np.testing.assert_allclose(found.images, p[some, :2], atol=1e-12)


@pytest.mark.thorough
def test_where_a_sweep_folds_a_point_has_two_images():
    """A place rises as 2 t - 3 t^2 (1 + x), so that t are the roots of a square equation."""
    p = asked((-0.3, -0.3, -1), (0.3, 0.3, 1))
    x, _, z = p.T
    found = sw.inverse_sweep(FOLDED, p)
    root = np.sqrt(np.maximum(4 - 12 * (1 + x) * z, 0))
    times = np.stack([(2 + side * root) / (6 * (1 + x)) for side in (-1, 1)], axis=1)
    fits = (root > 0)[:, None] & (times >= 0) & (times <= 1)
    assert (fits.sum(axis=1) == 2).sum() > 2000
    assert np.array_equal(found.point, np.nonzero(fits)[0])
    steep = (root[:, None] + 0 * times)[fits]  # a slope to divide rounding by
    assert (np.abs(found.u - times[fits]) < 1e-12 + 1e-12 / steep).all()
    np.testing.assert_allclose(found.images, p[found.point, :2], atol=1e-12)


@pytest.mark.thorough
@pytest.mark.parametrize("shape, low, high, places", [
    (TAPERED, (-1, -1, 0), (1, 1, 2), lambda x, y, t: (x * (1 - t / 2), y * (1 - t / 2), 2 * t)),
    (FOLDED, (-0.3, -0.3, -1), (0.3, 0.3, 1), lambda x, y, t: (x, y, 2 * t - 3 * t**2 * (1 + x))),
    (BOWL, (-1, -1, -0.5), (1, 1, 3), lambda x, y, t: (x, y, 2 * t + (x**2 + y**2) / 2)),
])  # fmt: skip
def test_the_motion_takes_images_back_to_their_points(shape, low, high, places):
    p = asked(low, high, seed=1)
    found = sw.inverse_sweep(shape, p)
    there = np.stack(places(*found.images.T, found.u), axis=1)
    assert len(found.u) > 5000
    np.testing.assert_allclose(there, p[found.point], atol=1e-11)


@pytest.mark.thorough
@pytest.mark.parametrize("shape, low, high", [
    (TAPERED, (-1.2, -1.2, -0.2), (1.2, 1.2, 2.2)),
    (FOLDED, (-0.4, -0.4, -1.2), (0.4, 0.4, 1.2)),
    (BOWL, (-1.2, -1.2, -0.2), (1.2, 1.2, 3.2)),
])  # fmt: skip
def test_labels_are_those_of_the_images(shape, low, high):
    """In is a point with an image in the circle; none of so many is on."""
    p = asked(low, high, seed=2)
    found = sw.inverse_sweep(shape, p)
    inside = np.zeros(len(p), dtype=bool)
    inside[found.point[np.hypot(*found.images.T) < shape.generator.radius]] = True
    assert np.array_equal(sw.classify(shape, p), np.where(inside, 1, -1))
    assert 1000 < inside.sum() < 19_000


def test_a_turn_that_is_a_formula_has_the_images_of_the_same_turn_as_a_motion():
    """Of that all images in the plane are known: those in the box around the contour are the same."""
    common = {"frame": "rotation-minimizing", "samples": sw.sampling.Count(50)}
    bar = sw.contours.Rectangle(0.3, 0.2)
    plain = sw.GeneralSweep(bar, CURVED, turn_z="2*t", **common)
    turned = sw.GeneralSweep(
        bar, CURVED, deform_x="x*cos(2*t) - y*sin(2*t)", deform_y="x*sin(2*t) + y*cos(2*t)", **common
    )
    p = asked((-0.3, -0.3, -0.2), (0.5, 1.2, 1.0), seed=3)
    found, expected = sw.inverse_sweep(turned, p), sw.inverse_sweep(plain, p)
    near = (np.abs(expected.images) < (0.15, 0.1)).all(axis=1)
    assert np.array_equal(found.point, expected.point[near]) and near.sum() > 300
    np.testing.assert_allclose(found.u, expected.u[near], atol=1e-10)
    np.testing.assert_allclose(found.images, expected.images[near], atol=1e-10)


def test_the_seam_of_a_closed_way_has_one_image_that_begins():
    """Places of the plane in which it begins: what ends there is what begins."""
    ring = sw.GeneralSweep(DISC, sw.trajectories.Arc(2.0, 2 * np.pi), frame="rotation-minimizing",
                           deform_x="x*(1 + 0.3*sin(2*pi*t))")  # fmt: skip
    aside = asked(-0.2, 0.2, 200, seed=4)[:, :2]
    seam = np.column_stack((2 + aside[:, 0], np.zeros(200), aside[:, 1]))
    found = sw.inverse_sweep(ring, seam)
    assert np.array_equal(found.point, np.arange(200))
    assert (np.abs(found.u) < 1e-9).all()
    np.testing.assert_allclose(np.sort(np.abs(found.images)), np.sort(np.abs(aside)), atol=1e-9)


def test_no_points_have_no_images():
    found = sw.inverse_sweep(FOLDED, np.empty((0, 3)))
    assert len(found.u) == len(found.point) == len(found.images) == 0

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids that are scaled as they move, against what is known of the sets that they visit, and against many poses."""

from math import pi

import numpy as np
import pytest

import sweep_addon as sw

UP = sw.trajectories.Line(end=(0, 0, 2))
WHOLE = {f"scale_{axis}": "1 + t/0.6" for axis in "xyz"}


def in_box(low, high, count, seed=0):
    return np.random.default_rng(seed).uniform(low, high, (count, 3))


def cone(points):
    """How far points are from balls of radius 0.3 + 0.25 s about (0, 0, s), s from 0 to 2: a cone between two balls."""
    across, z = np.hypot(points[:, 0], points[:, 1]), points[:, 2]
    s = np.clip(z + 0.25 * across / np.sqrt(1 - 0.25**2), 0, 2)
    return np.hypot(across, z - s) - 0.3 - 0.25 * s


@pytest.mark.parametrize("tolerance", [None, 1e-6, 1e-3, 0.05])
def test_a_ball_that_grows_leaves_a_cone(tolerance):
    """Errors are within the tolerance: what is on is so by half of it, more or less."""
    sweep = sw.GeneralSweep(sw.solids.Ball(0.3), UP, **WHOLE)
    points = in_box((-1, -1, -0.5), (1, 1, 3), 20_000, 14)
    far, band = cone(points), tolerance or 1e-8
    labels = sw.classify(sweep, points, tolerance)
    assert (labels == np.sign(-far))[np.abs(far) > 1.5 * band].all()
    assert (labels[np.abs(far) < 0.5 * band] == 0).all()


def test_beside_a_ball_that_grows_points_are_on_within_the_tolerance_alone():
    """Points as far from the cone as they are put there: along its normal, whose slope is 0.25."""
    random = np.random.default_rng(3)
    sine, cosine = 0.25, np.sqrt(1 - 0.25**2)
    s, angle = random.uniform(0.2, 1.8, 500), random.uniform(0, 2 * pi, 500)
    off = np.tile([-2e-6, -0.9e-6, 0.0, 0.9e-6, 2e-6], 100)
    radius = 0.3 + 0.25 * s + off
    points = np.stack((radius * cosine * np.cos(angle), radius * cosine * np.sin(angle), s - radius * sine), axis=1)
    labels = sw.classify(sw.GeneralSweep(sw.solids.Ball(0.3), UP, **WHOLE), points, tolerance=1e-6)
    assert (labels == np.tile([1, 0, 0, 0, -1], 100)).all()


def test_a_ball_that_shrinks_to_nothing_leaves_a_cone_with_a_tip():
    """The balls of radius 0.5 (1 - t) about (0, 0, 2 t): the sine of half the angle at the tip is a quarter."""
    sweep = sw.GeneralSweep(sw.solids.Ball(0.5), UP, **{f"scale_{axis}": "1 - t" for axis in "xyz"})
    points = in_box((-0.6, -0.6, -0.6), (0.6, 0.6, 2.4), 20_000, 5)
    points[:2000] = points[:2000] * (0.02, 0.02, 0.02) + (0, 0, 2)
    across, z = np.hypot(points[:, 0], points[:, 1]), points[:, 2]
    s = np.clip(z + 0.25 * across / np.sqrt(1 - 0.25**2), 0, 2)
    far = np.hypot(across, z - s) - 0.5 + 0.25 * s
    s = np.clip(z - 0.25 * across / np.sqrt(1 - 0.25**2), 0, 2)
    far = np.minimum(far, np.hypot(across, z - s) - 0.5 + 0.25 * s)
    clear = np.abs(far) > 1e-8
    assert (sw.classify(sweep, points) == np.sign(-far))[clear].all()
    assert sw.classify(sweep, [(0, 0, 2.0), (0, 0, 2.001), (0, 0, 1.999)]).tolist() == [0, -1, 1]


def test_a_block_that_grows_leaves_a_frustum():
    """A block that grows from a half to all of its width, its height kept, visits a hull with slanted sides."""
    wide = {"scale_x": "0.5 + 0.5*t", "scale_y": "0.5 + 0.5*t"}
    sweep = sw.GeneralSweep(sw.solids.Block(1.0, 1.0, 0.5), UP, **wide)
    points = in_box((-0.6, -0.6, -0.4), (0.6, 0.6, 2.4), 20_000, 6)
    half = 0.25 + 0.125 * np.clip(points[:, 2] + 0.25, 0, 2)  # of the highest block that reaches so far down
    slope = 1 / np.hypot(1, 0.125)
    across = (np.abs(points[:, :2]).max(axis=1) - half) * slope
    inside = np.maximum(across, np.abs(points[:, 2] - 1) - 1.25)
    for tolerance in (None, 1e-3):
        clear = np.abs(inside) > 2 * (tolerance or 1e-8)
        assert (sw.classify(sweep, points, tolerance) == np.sign(-inside))[clear].all()


def test_on_the_sides_of_a_block_that_grows_is_what_is_within_the_tolerance():
    """The lower edges of its sides leave them; inside, a point is told to be 8/9 as deep as it is, as in one pose."""
    random, tolerance = np.random.default_rng(9), 1e-4
    off = np.tile([-1.8, -0.4, 0.4, 1.6], 500) * tolerance
    z, y = random.uniform(0, 1.5, 2_000), random.uniform(-0.2, 0.2, 2_000)
    normal = np.array((1, 0, -0.125)) / np.hypot(1, 0.125)
    points = np.stack((0.25 + 0.125 * (z + 0.25), y, z), axis=1) + off[:, None] * normal
    sweep = sw.GeneralSweep(sw.solids.Block(1.0, 1.0, 0.5), UP, scale_x="0.5 + 0.5*t", scale_y="0.5 + 0.5*t")
    assert (sw.classify(sweep, points, tolerance) == np.tile([1, 0, 0, -1], 500)).all()


ELLIPSOID = {"scale_x": 1.0, "scale_y": 0.4, "scale_z": 2.0}


@pytest.mark.parametrize("tolerance", [1e-6, 1e-3])
def test_a_ball_scaled_along_its_axes_moves_as_an_ellipsoid(tolerance):
    """Moved along x it is in the middle an elliptic cylinder, whose points and normals are known."""
    sweep = sw.GeneralSweep(sw.solids.Ball(0.5), sw.trajectories.Line(end=(1, 0, 0)), **ELLIPSOID)
    axes = 0.5 * np.array((1.0, 0.4, 2.0))
    angle = np.random.default_rng(1).uniform(0, 2 * pi, 400)
    x = np.random.default_rng(2).uniform(0.2, 0.8, 400)
    normal = np.stack((0 * angle, np.cos(angle) / axes[1], np.sin(angle) / axes[2]), axis=1)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    off = np.tile([-1.5, -0.9, 0.9, 1.5], 100) * tolerance
    points = np.stack((x, axes[1] * np.cos(angle), axes[2] * np.sin(angle)), axis=1) + off[:, None] * normal
    assert (sw.classify(sweep, points, tolerance) == np.tile([1, 0, 0, -1], 100)).all()
    points = in_box((-0.7, -0.4, -1.2), (1.7, 0.4, 1.2), 5_000, 7)
    nearest = points - np.clip(points[:, :1], 0, 1) * (1, 0, 0)
    level = ((nearest / axes) ** 2).sum(axis=1) - 1
    clear = np.abs(level) > 20 * tolerance
    assert (sw.classify(sweep, points, tolerance) == np.sign(-level))[clear].all()


LAWS = {
    "turning and flattened": ({"turn_z": "2*t", "turn_x": "t", "scale_x": "1 + t", "scale_z": "0.5 - t"}, 1.5),
    "by points": ({"scale_x": [(0, 1), (0.5, 0.4), (1, 1.2)], "turn_y": "t"}, 1.0),
    "as a root": ({"scale_x": "sqrt(abs(1 - t))", "scale_y": "sqrt(abs(1 - t))", "scale_z": "sqrt(abs(1 - t))"}, 1.0),
    "mirrored": ({"scale_x": "1 - 2*t"}, 1.0),
}


@pytest.mark.thorough
@pytest.mark.parametrize("name", LAWS)
@pytest.mark.parametrize("tolerance", [1e-3, 1e-5])
def test_a_scaled_drilled_mesh_is_where_many_poses_of_it_are(name, tolerance):
    """What 4,001 poses visit is visited; what is far from all of them by more than it moves between two is not."""
    pytest.importorskip("manifold3d", reason="the mesh of a tree is asked of manifold3d")
    laws, largest = LAWS[name]
    block = sw.solids.Triangles.of((sw.solids.Block(0.6, 0.3, 0.4) - sw.solids.Cylinder(0.1, 1.0)).mesh())
    path = sw.trajectories.Arc(0.7, 2.0)
    sweep = sw.GeneralSweep(block, path, **laws)
    points = in_box((-0.9, -0.5, -0.6), (1.4, 1.4, 0.6), 2_000, 8)
    count = 2001
    poses = sweep.motion.at(np.linspace(0, 1.4, count))
    half = np.array((0.3, 0.15, 0.2))
    least = np.full(len(points), np.inf)
    for origin, matrix in zip(poses.origin, poses.matrix, strict=True):
        scales = np.linalg.norm(matrix, axis=0)
        if scales.min() < 1e-6:
            continue
        places = (points - origin) @ np.linalg.inv(matrix).T
        depth = np.maximum((np.abs(places) - half).max(axis=1), 0.098 - np.hypot(places[:, 0], places[:, 1]))
        least = np.minimum(least, depth * np.where(depth > 0, scales.min(), scales.max()))
    labels = sw.classify(sweep, points, tolerance)
    assert (labels[least < -1.1 * tolerance * largest - 2e-3 * largest] == 1).all()
    assert (labels[least > tolerance + 4e-3 * largest] == -1).all()
    assert (labels == 1).any() and (labels == -1).any()


def test_a_solid_that_is_nothing_all_the_way_is_refused():
    nothing = sw.GeneralSweep(sw.solids.Ball(0.3), UP, scale_x=0.0)
    with pytest.raises(sw.ShapeError, match="scale_x: must not be 0 everywhere"):
        sw.classify(nothing, [(0, 0, 0)])


def test_what_is_scaled_may_be_an_operand_and_move_once_more():
    grown = sw.GeneralSweep(sw.solids.Ball(0.3), UP, **WHOLE)
    points = in_box((-1, -1, -0.5), (1, 1, 3), 2_000, 4)
    far = cone(points)
    expected = np.where(np.abs(points).max(axis=1) < 0.5, -1, np.sign(-far))
    assert (sw.classify(grown - sw.solids.Block(1.0, 1.0, 1.0), points) == expected).all()
    moved = sw.SweptSolid(grown, sw.trajectories.Line(end=(0, 0, 1e-3)))
    clear = np.abs(far) > 5e-3
    assert (sw.classify(moved, points[:300], 1e-3) == np.sign(-far[:300]))[clear[:300]].all()


@pytest.mark.thorough
@pytest.mark.parametrize("tolerance", [None, 1e-12, 1e-4, 1e-2])
@pytest.mark.parametrize("laws", [{"scale_z": "max(0, 2*t - 1)"}, {"deform_z": "z*max(0, 2*t - 1)"}])
def test_a_solid_that_is_flat_has_no_inside_and_leaves_nothing(laws, tolerance):
    """A ball that is flat on the first half of its way, up to x = 1, and then grows: as its mesh has it."""
    sweep = sw.GeneralSweep(sw.solids.Ball(0.3), sw.trajectories.Line(end=(2, 0, 0)), **laws)
    points = np.zeros((12, 3))
    points[:, 0] = np.append(np.linspace(-0.2, 0.6, 9), (1.6, 2.0, 2.4))
    points[1, 1], points[2, 1] = 0.1, -0.2
    assert sw.classify(sweep, points, tolerance).tolist() == [-1] * 9 + [1, 1, -1]


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("body", "scale", "half", "tolerance"),
    [(sw.solids.Ball(0.3), 0.5, 0.15, 0.1515), (sw.solids.Block(1.0, 1.0, 1.0), 0.1, 0.05, 0.0505)],
)
@pytest.mark.parametrize("law", ["scale_z", "deform_z"])
def test_a_pose_that_is_thinner_than_the_tolerance_has_no_inside(law, body, scale, half, tolerance):
    """No point is farther from the boundary of its pose than half as much as that is thick, which is less."""
    changed = {law: scale if law == "scale_z" else f"z*{scale}"}
    sweep = sw.GeneralSweep(body, sw.trajectories.Line(end=(1, 0, 0)), **changed)
    points = in_box((-0.3, -0.3, -half), (1.3, 0.3, half), 1_000, 5)
    across = (points - np.clip(points[:, :1], 0, 1) * (1, 0, 0)) / (1, 1, scale)
    inside = points[np.linalg.norm(across, axis=1) < 0.3]
    assert len(inside) > 300
    assert (sw.classify(sweep, inside, tolerance) == 0).all()


@pytest.mark.parametrize("tolerance", [0.01, 0.03])
def test_deep_in_an_ellipsoid_points_are_on_within_a_large_tolerance(tolerance):
    """Along its normal a point is as deep as it is put, up to the least radius of curvature, 0.04 here."""
    sweep = sw.GeneralSweep(sw.solids.Ball(0.5), sw.trajectories.Line(end=(1, 0, 0)), **ELLIPSOID)
    angle = np.random.default_rng(1).uniform(0, 2 * pi, 400)
    x = np.random.default_rng(2).uniform(0.4, 0.6, 400)
    normal = np.stack((0 * angle, np.cos(angle) / 0.2, np.sin(angle)), axis=1)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    off = np.tile([-1.02, -0.98], 200) * tolerance
    points = np.stack((x, 0.2 * np.cos(angle), np.sin(angle)), axis=1) + off[:, None] * normal
    assert (sw.classify(sweep, points, tolerance) == np.tile([1, 0], 200)).all()

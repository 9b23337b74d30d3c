# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How round tubes of 16 points turn about their paths, read off their meshes, whoever made them."""

import numpy as np
from peers import Bevel, CurveToMesh, curve, places, ring

from bl_ext.user_default import sweep_addon as sw

SIDES, RADIUS = 16, 0.05
SECTOR = 2 * np.pi / SIDES
UNTWISTED = 360 - 238.657637051473  # degrees: what the (2, 3) knot, major to minor as 5 to 2, turns a frame by
LARGEST = "largest turn between two rings, degrees: {}"


def rows(swept):
    """Of each path what this project, the node, the bevel and trimesh make of it."""
    for count in (101, 1001):
        yield [f"frame, degrees from the true one: 5-turn helix known by {count} points", 0, *helix(swept, count), "-"]
    for name, path in (("a vertical loop", loop()), ("a cubic through its inflection", cubic())):
        found = [np.degrees(np.abs(spin(rings)).max()) for rings in tubes(swept, path)]
        yield [LARGEST.format(f"{name}, {len(path)} points"), 0, *told(swept, found, "{:.1e}"), "-"]
    found = [np.degrees(np.abs(spin(rings, True)).max()) for rings in tubes(swept, knot(0.0), True)]
    named = LARGEST.format("closed (2, 3) knot, 400 points")
    yield [named, f"{UNTWISTED / 400:.3f}", *told(swept, found, "{:.3f}"), "-"]
    found = [unevenness(rings) for rings in tubes(swept, knot(0.3), True)]
    named = "twist per length, closed (2, 3) knot, uneven points: largest to smallest"
    yield [named, 1, *told(swept, found, "{:.4f}"), "-"]


def told(swept, found, form):
    """Numbers of this project and its peers, and that trimesh is not there where it is not."""
    return [*map(form.format, found), *["not installed"] * (not swept)]


def loop():
    """In along x, once round a circle that stands upright, and on."""
    u, way = np.linspace(0, 2 * np.pi, 61), np.linspace(2, 0, 20, endpoint=False)
    legs = np.stack((way, 0 * way, 0 * way), axis=1)
    return np.concatenate((-legs, np.stack((np.sin(u), 0 * u, 1 - np.cos(u)), axis=1), legs[::-1]))


def cubic():
    x = np.linspace(-1, 1, 101)
    return np.stack((x, x**3, 0 * x), axis=1)


def knot(crowding):
    """400 points of a closed (2, 3) torus knot, which crowd on one side."""
    u = np.linspace(0, 2 * np.pi, 400, endpoint=False)
    return sw.trajectories.TorusKnot().evaluate(u + crowding * np.sin(u))


def tubes(swept, path, closed=False):
    """The rings (n, 16, 3) of this project's tube through points, and of those that peers make of them."""
    trajectory, samples = sw.trajectories.Sampled(path, closed), sw.sampling.Count(len(path))
    ours = sw.GeneralizedCylinder(sw.contours.Circle(RADIUS, SIDES), trajectory, samples).mesh()
    yield ours.vertices.reshape(SIDES, -1, 3).swapaxes(0, 1)
    for mesh in (
        CurveToMesh(curve(path, closed=closed), SIDES, RADIUS).mesh(),
        Bevel(path, SIDES, RADIUS, closed).mesh(),
    ):
        yield places(mesh)[-SIDES * len(path) :].reshape(-1, SIDES, 3)
    if swept:
        course = np.concatenate((path, path[:1])) if closed else path
        yield np.array(swept(ring(RADIUS, SIDES), course).vertices)[: SIDES * len(path)].reshape(-1, SIDES, 3)


def helix(swept, count):
    """How far a frame has turned from the one without spin, at worst: Bishop's theorem says where that is."""
    trajectory, rise = sw.trajectories.Helix(1.0, 0.5, 5.0), 0.5 / (2 * np.pi)
    u = np.linspace(0, 10 * np.pi, count)
    points = trajectory.evaluate(u)
    principal = np.stack((-np.cos(u), -np.sin(u), 0 * u), axis=1)
    binormal = np.cross(trajectory.tangents(u), principal)
    found = []
    for rings in tubes(swept, points):
        spoke = rings[:, 0] - points
        angle = np.arctan2(np.einsum("ij,ij->i", spoke, binormal), np.einsum("ij,ij->i", spoke, principal))
        lag = angle - angle[0] + rise / np.hypot(1.0, rise) * u
        found.append(np.degrees(np.abs((lag + np.pi) % (2 * np.pi) - np.pi).max()))
    return told(swept, found, "{:.1e}")


def unevenness(rings):
    """Twist per length round a closed path: largest to smallest."""
    middles = rings.mean(axis=1)
    twist = np.abs(spin(rings, True)) / np.linalg.norm(np.roll(middles, -1, axis=0) - middles, axis=1)
    return twist.max() / twist.min()


def spin(rings, closed=False):
    """The turn from each ring (n, 16, 3) to the next in radians, of a closed path from the last to the first too.

    What turns beyond a normal carried by double reflection is spin, but in the last step of a closed path for what
    leads one point to another.
    """
    middle, spoke = rings.mean(axis=1), rings[:, 0] - rings.mean(axis=1)
    plane = np.cross(spoke, rings[:, SIDES // 4] - middle)
    e1, e2 = (part / np.linalg.norm(part, axis=1, keepdims=True) for part in (plane, spoke))
    chord = np.roll(middle, -1, axis=0) - middle
    ahead, arrived = np.roll(e1, -1, axis=0), mirrored(e1, chord)
    carried = mirrored(mirrored(e2, chord), ahead - arrived)
    reached = np.roll(e2, -1, axis=0)
    sine = np.einsum("ij,ij->i", np.cross(carried, reached), ahead)
    turn = np.arctan2(sine, np.einsum("ij,ij->i", carried, reached))
    turn[-1] = (turn[-1] + SECTOR / 2) % SECTOR - SECTOR / 2
    return turn if closed else turn[:-1]


def mirrored(vectors, normals):
    squared = np.einsum("ij,ij->i", normals, normals)
    share = np.einsum("ij,ij->i", vectors, normals) / np.where(squared, squared, 1.0)
    return vectors - 2 * share[:, None] * normals

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random trees of poses: one from where the part stands, one from outside, which grow until they meet."""

import numpy as np

from ..grammars.deriving.draws import GOLDEN, mixed
from .directions import own_axes
from .legs import START, Leg, Pose, crossing, poses
from .stops import SHORTEST

STEP = 0.2  # of the part's size is a step of a tree
ROOM = 0.5  # of the part's size around all, in which poses are drawn
RANDOM = 0.3  # of the draws are of all poses
ATTEMPTS = 400  # to shorten a path
TURNED = 0.25  # of the part's size for a radian: how far a turn counts


class Draws:
    """Random numbers by their count, the same on every machine: even ones, and normal ones by Box and Muller.

    Parameters
    ----------
    seed : int
    """

    def __init__(self, seed):
        self.count = np.uint64((seed * GOLDEN) % 2**64)

    def even(self, size):
        """(size,) float array, from 0 to before 1."""
        with np.errstate(over="ignore"):
            numbers = mixed(self.count + np.arange(1, size + 1, dtype=np.uint64))
            self.count = self.count + np.uint64(size)
        return (numbers >> np.uint64(11)) * 2.0**-53

    def direction(self, size):
        """A unit vector: (size,) float array."""
        radius, angle = self.even(size), self.even(size)
        normal = np.sqrt(-2 * np.log(1 - radius)) * np.cos(2 * np.pi * angle)
        return normal / np.linalg.norm(normal)


class Tree:
    """Poses, each but the first ones reached from another one.

    Parameters
    ----------
    roots : list of Pose
    unit : float
        How far a turn of a radian counts, in metres.
    """

    def __init__(self, roots, unit):
        self.poses, self.parents, self.unit = list(roots), [-1] * len(roots), unit
        self.rows = np.array([row(pose) for pose in roots])

    def nearest(self, pose):
        """The number of the pose that is nearest."""
        away = self.rows[: len(self.poses)] - row(pose)
        # of two rotations the squared difference is 8 sin^2 of half the angle, for small ones twice its square
        squares = (away[:, 9:] ** 2).sum(axis=1) + self.unit**2 / 2 * (away[:, :9] ** 2).sum(axis=1)
        return int(squares.argmin())

    def add(self, pose, parent):
        if len(self.poses) == len(self.rows):
            self.rows = np.concatenate((self.rows, np.zeros_like(self.rows)))
        self.rows[len(self.poses)] = row(pose)
        self.poses.append(pose)
        self.parents.append(parent)
        return len(self.poses) - 1

    def way(self, number):
        """The poses that lead to one, from the root on."""
        found = []
        while number >= 0:
            found.append(self.poses[number])
            number = self.parents[number]
        return found[::-1]


def grown(scene, directions, seed, budget, progress):
    """Legs on which the part seems to get out, by two trees that grow in turns, or none.

    Parameters
    ----------
    scene : Scene
    directions : (n, 3) float array
        In which the part is out if it is far enough.
    seed, budget : int
        Of the random numbers, and of the poses that are tried.
    progress : callable
        Is told which part of the budget is used.

    Source
    ------
    Kuffner, LaValle: RRT-Connect: an efficient approach to single-query path planning, ICRA 2000.
    """
    size, draws = scene.part.size, Draws(seed)
    outside = [Leg(way * far).pose(1.0) for way, far in zip(directions, scene.travels(directions, START), strict=True)]
    trees = [Tree(roots, TURNED * size) for roots in ([START], [pose for pose in outside if not scene.blocked(pose)])]
    axes = own_axes(scene.part)
    seen = scene.everything @ axes
    low, high = seen.min(axis=0) - ROOM * size, seen.max(axis=0) + ROOM * size
    first = scene.asked
    for turn in range(budget):
        used = (scene.asked - first) / budget
        if used >= 1.0:
            return None
        progress(used)
        one, other = trees[turn % 2], trees[1 - turn % 2]
        reached = enlarged(scene, draws, one, axes, low, high)
        if reached is None:
            continue
        goal = one.poses[reached]
        number, met = connected(scene, other, goal, STEP * size)
        if met:
            ways = one.way(reached), other.way(number)
            inner, outer = ways if turn % 2 == 0 else ways[::-1]
            return legs_of([*inner, *outer[::-1][1:]])
    return None


def enlarged(scene, draws, tree, axes, low, high):
    """A new pose of a tree, its number or None: a step towards a random pose, or a simple motion as far as it is free.

    Where parts fit, hardly any pose is free but by simple motions: turns and ways about and along the part's axes.
    """
    share, which, along, far, place = draws.even(5)
    if share < RANDOM:
        target = Pose(rotation(draws.direction(4)), axes @ (low + draws.even(3) * (high - low)))
        return extended(scene, tree, tree.nearest(target), target, STEP * scene.part.size)[0]
    number = int(which * len(tree.poses))
    pose = tree.poses[number]
    axis = pose.matrix @ axes[:, int(3 * along)]
    if share < (1 + RANDOM) / 2:
        leg = Leg((2 * far - 1) * scene.part.size * axis)
    else:
        pivot = pose.of(scene.part.vertices[int(place * len(scene.part.vertices))])
        leg = Leg(np.zeros(3), pivot, axis, (far - 0.5) * np.pi)
    part, speed = scene.free_part(leg, pose), leg.speed(pose.of(scene.core.vertices))
    part -= scene.tolerance / 4 / speed
    return tree.add(leg.pose(part).after(pose), number) if part * speed > SHORTEST * scene.part.size else None


def extended(scene, tree, number, target, step):
    """A step from a pose of a tree to a target: the number of the new pose or None, and whether that is the target."""
    pose = tree.poses[number]
    leg = between(pose, target)
    length = float(np.linalg.norm(leg.way)) + tree.unit * leg.angle
    if length > step:
        leg = leg.until(step / length)
    if length == 0 or not scene.is_free(leg, pose):
        return None, False
    return tree.add(leg.pose(1.0).after(pose), number), length <= step


def connected(scene, tree, target, step):
    """Steps from the nearest pose of a tree to a target until something is in the way: the last, and if it arrived."""
    number = tree.nearest(target)
    while True:
        following, arrived = extended(scene, tree, number, target, step)
        if following is None:
            return number, False
        if arrived:
            return following, True
        number = following


def shortened(scene, legs, seed):
    """Fewer legs that are free by samples too: pieces of the path are replaced by one leg where that is free."""
    draws = Draws(seed)
    way = poses(legs)
    for _ in range(ATTEMPTS):
        if len(way) <= 2:
            break
        first, last = sorted((draws.even(2) * len(way)).astype(int))
        if last - first >= 2 and scene.is_free(between(way[first], way[last]), way[first]):
            way = [*way[: first + 1], *way[last:]]
    return legs_of(way)


def legs_of(way):
    """The legs between poses."""
    return tuple(between(one, other) for one, other in zip(way[:-1], way[1:], strict=True))


def between(one, other):
    """The leg from a pose to another one, that turns by the least angle about the part's own origin."""
    matrix = other.matrix @ one.matrix.T
    sine = np.array([matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1]]) / 2
    angle = float(np.arctan2(np.linalg.norm(sine), (np.trace(matrix) - 1) / 2))
    if angle < 1e-9:
        return Leg(other.origin - one.origin)
    if np.linalg.norm(sine) > 1e-6:
        axis = sine / np.linalg.norm(sine)
    else:  # half a turn
        columns = matrix + np.eye(3)
        column = columns[:, np.abs(columns).sum(axis=0).argmax()]
        axis = column / np.linalg.norm(column)
    return Leg(other.origin - one.origin, one.origin, axis, angle)


def rotation(quaternion):
    """The rotation of a unit quaternion (w, x, y, z): (3, 3) float array."""
    across = crossing(quaternion[1:])
    return np.eye(3) + 2 * quaternion[0] * across + 2 * across @ across


def row(pose):
    """A pose as (12,) floats."""
    return np.concatenate((pose.matrix.ravel(), pose.origin))

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids that move as sets of points: a point is in if on the inverse trajectory it comes to be in the solid.

The point, seen from the solid, moves at a bounded speed. As far as it is from the solid, so long nothing can happen:
time goes on by that distance over the speed, and no pose is missed between two that are looked at.

Source
------
Sourin, Pasko: Function representation for sweeping by a moving solid, IEEE TVCG 2(1), 1996, the least over all times;
Erdim, Ilies: Classifying points for sweeping solids, Computer-Aided Design 40(9), 2008, the inverted trajectory.
"""

import numpy as np

from ..trajectories.arc_length import arc_length
from ..vectors import norms
from .labels import IN, ON, OUT
from .panels import NODES, derivative, panels, powers
from .ways import PARTS, apart

CHUNK = 1 << 14
SHORTEST = 1e-3  # of the way: no step is shorter, and what is least in between is searched
STEPS = 24  # of that search
LOOKED = 65
ROOM = 1.05  # of a speed, for what is faster between places that were looked at
GOLDEN = (np.sqrt(5) - 1) / 2


class MovingSolid:
    """All points that a solid visits.

    Parameters
    ----------
    solid : member
        With a ``distance``.
    motion : Motion
        A rigid one.
    """

    def __init__(self, solid, motion):
        self.solid = solid
        measure = arc_length(motion.trajectory)
        self.total = measure.total

        def channels(s):
            poses = motion.at(np.append(0.0, s))
            return np.concatenate((poses.origin[1:], poses.matrix[1:].reshape(-1, 9)), axis=1)

        looked = channels(np.linspace(0.0, self.total, LOOKED))
        size = float(np.abs(solid.box).max())
        extent = np.append(np.full(3, np.abs(looked[:, :3]).max() + size), np.ones(9))
        breaks = apart(measure.at(motion.trajectory.joints()), self.total)
        self.panels = panels(channels, breaks, PARTS, extent)
        rates = np.einsum("kcj,ij->kic", derivative(self.panels.series), powers(NODES))
        rates /= ((self.panels.end - self.panels.start) / 2)[:, None, None]
        self.speed = ROOM * norms(rates[..., :3]).max()  # of the origin, in a metre of the way
        turning = np.sqrt((rates[..., 3:] ** 2).sum(axis=2) / 2)  # of a rotation's rate that is its angular speed
        self.turning = ROOM * turning.max(axis=1)
        poses = motion.at(np.linspace(0.0, self.total, LOOKED))
        low, high = solid.box
        corners = np.stack(np.meshgrid(*np.stack((low, high)).T, indexing="ij"), axis=-1).reshape(-1, 3)
        swept = motion.posed(corners, poses)
        bulge = size * (np.abs(self.turning).max() * self.total / LOOKED) ** 2 + self.total / LOOKED
        self.box = np.stack((swept.min(axis=(0, 1)) - bulge, swept.max(axis=(0, 1)) + bulge))

    def labels(self, points, tolerance):
        """IN, ON or OUT for points (n, 3): (n,) int8."""
        distance = self.distance(points, tolerance)
        return np.where(np.abs(distance) <= tolerance, ON, np.where(distance < 0, IN, OUT)).astype(np.int8)

    def distance(self, points, tolerance=0.0):
        """How far points (n, 3) are from the nearest pose, or less, negative where they have been visited: (n,).

        Of those that are visited it is as deep as they were found to be first, beyond the tolerance.
        """
        found = np.empty(len(points))
        for start in range(0, len(points), CHUNK):
            some = slice(start, start + CHUNK)
            found[some] = self.followed(points[some], tolerance)
        return found

    def followed(self, points, tolerance):
        """The same for so few points that all fit into a processor's cache."""
        s, least, best = np.zeros(len(points)), np.full(len(points), np.inf), np.zeros(len(points))
        active, shortest = np.arange(len(points)), SHORTEST * self.total
        while len(active):
            value, away, turning = self.at(points[active], s[active])
            nearer = value < least[active]
            least[active], best[active] = (
                np.where(nearer, value, least[active]),
                np.where(nearer, s[active], best[active]),
            )
            # within a step h the point moves by no more than (speed + turning (away + speed h)) h
            linear, square = self.speed + turning * away, turning * self.speed
            ahead = np.maximum(value, 0.0)
            step = 2 * ahead / (linear + np.sqrt(linear**2 + 4 * square * ahead))
            step = np.maximum(step, np.maximum(shortest, tolerance / linear))
            going = (least[active] >= -tolerance) & (s[active] < self.total)
            s[active] = np.minimum(s[active] + step, self.total)
            active = active[going]
        within = 2 * shortest * (self.speed + self.turning.max() * (norms(points) + self.total))
        unsure = np.flatnonzero((least >= -tolerance) & (least <= within))
        least[unsure] = np.minimum(least[unsure], self.searched(points[unsure], best[unsure], 2 * shortest))
        return least

    def searched(self, points, s, room):
        """The least distance near some places of the way, by golden sections."""
        low, high = np.maximum(s - room, 0.0), np.minimum(s + room, self.total)
        a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        at_a, at_b = self.at(points, a)[0], self.at(points, b)[0]
        for _ in range(STEPS):
            left = at_a < at_b
            low, high = np.where(left, low, a), np.where(left, b, high)
            a, b = np.where(left, high - GOLDEN * (high - low), b), np.where(left, a, low + GOLDEN * (high - low))
            asked = self.at(points, np.where(left, a, b))[0]
            at_a, at_b = np.where(left, asked, at_b), np.where(left, at_a, asked)
        return np.minimum(at_a, at_b)

    def at(self, points, s):
        """How far points are from the solid when it has come so far, from its origin, and how fast it turns there."""
        panel = np.clip(np.searchsorted(self.panels.start, s, side="right") - 1, 0, len(self.panels.start) - 1)
        start, end = self.panels.start[panel], self.panels.end[panel]
        held = self.panels.at(panel, np.clip((2 * s - start - end) / (end - start), -1.0, 1.0))
        way = points - held[:, :3]
        local = np.einsum("nij,ni->nj", held[:, 3:].reshape(-1, 3, 3), way)
        ahead = np.maximum(self.turning[panel], self.turning[np.minimum(panel + 1, len(self.turning) - 1)])
        return self.solid.distance(local), norms(way), ahead

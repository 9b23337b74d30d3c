# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids that move as sets of points: a point is in if on the inverse trajectory it comes to be in the solid.

The point, seen from the solid, moves at a bounded speed. As far as it is from the solid, so long nothing can happen,
before and after: some poses are looked at for all points, and what they leave open of a point's way is halved.

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

CHUNK = 1 << 14  # points that fit into a processor's cache
LOOKED = 65
POSES = 32  # at least, that are looked at for all points
SHORTEST = 1e-3  # of the way: what is left of it when it is not halved any more, but searched
HALVED = 32.0  # tolerances: what the solid moves in less is halved on
DEEP = 1e-3  # of the size
STEPS = 24  # of that search
ROOM = 1.1  # of what changes, for what changes faster between places that were looked at
SAME = 1e-7  # of the size: motions that differ by more jump or turn at once
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

    is_sheet = False

    def __init__(self, solid, motion):
        self.solid = solid
        measure = arc_length(motion.trajectory)
        self.total = measure.total
        looked = motion.at(np.linspace(0.0, self.total, LOOKED))
        low, high = looked.origin.min(axis=0), looked.origin.max(axis=0)
        self.middle = (low + high) / 2
        self.size = float(np.abs(solid.box).max() + norms(high - low))

        def back(s):
            """The motion of places about the middle into the solid's space: a matrix, and where the middle goes."""
            poses = motion.at(np.append(0.0, s))
            matrix = poses.matrix[1:].swapaxes(1, 2)
            shift = np.einsum("nij,nj->ni", matrix, self.middle - poses.origin[1:])
            return np.concatenate((matrix.reshape(-1, 9), shift), axis=1)

        breaks = apart(measure.at(motion.trajectory.joints()), self.total)
        self.panels = panels(back, breaks, PARTS, np.append(np.ones(9), np.full(3, self.size)))
        self.half = ((self.panels.end - self.panels.start) / 2)[:, None, None]
        self.rates = derivative(self.panels.series) / self.half
        self.changes = derivative(self.rates) / self.half
        bend = np.einsum("kcj,ij->kic", self.changes, powers(NODES))
        self.bend = ROOM * np.sqrt((bend[..., :9] ** 2).sum(axis=2)).max(), ROOM * norms(bend[..., 9:]).max()
        self.poses = list(self.looked())
        corners = np.stack(np.meshgrid(*solid.box.T, indexing="ij"), axis=-1).reshape(-1, 3)
        swept = motion.posed(corners, looked)
        turning = np.sqrt((np.einsum("kcj,ij->kic", self.rates, powers(NODES))[..., :9] ** 2).sum(axis=2)).max()
        between = self.total / LOOKED
        bulge = float(np.abs(solid.box).max()) * (turning * between) ** 2 + between
        self.box = np.stack((swept.min(axis=(0, 1)) - bulge, swept.max(axis=(0, 1)) + bulge))

    def looked(self):
        """Poses to look at all points in: the arc length, whether a smooth piece begins, the motion and its rate."""
        start, end = self.panels.start, self.panels.end
        sides = np.stack((self.panels.series, self.rates))
        begun, ended = (sides @ side ** np.arange(sides.shape[-1]) for side in (-1.0, 1.0))
        sizes = np.append(np.ones(9), np.full(3, self.size))
        jumps = (np.abs(begun[:, 1:] - ended[:, :-1]) > SAME * sizes * [[[1.0]], [[1e3]]]).any(axis=(0, 2))
        first = np.append(0, np.flatnonzero(jumps) + 1)
        for a, b in zip(first, np.append(first[1:], len(start)), strict=True):
            count = max(int(np.ceil(POSES * (end[b - 1] - start[a]) / self.total)), 1)
            for number, s in enumerate(np.linspace(start[a], end[b - 1], count + 1)):
                panel = min(max(int(np.searchsorted(start, s, side="right")) - 1, a), b - 1)
                x = np.clip((2 * s - start[panel] - end[panel]) / (end[panel] - start[panel]), -1.0, 1.0)
                basis = powers(np.array([x]))[0]
                yield s, number == 0, self.panels.series[panel] @ basis, self.rates[panel] @ basis

    def labels(self, points, tolerance):
        """IN, ON or OUT for points (n, 3): (n,) int8."""
        distance = self.least(points, tolerance, 1.0, tolerance)
        return np.where(np.abs(distance) <= tolerance, ON, np.where(distance < 0, IN, OUT)).astype(np.int8)

    def distance(self, points):
        """How far points (n, 3) are from all poses, or less, negative where they have been visited, or less deep: (n,).

        Twice the speed is assumed, so that no pose between those looked at is nearer than half as far. What is found
        to be deep is not searched for what is deeper.
        """
        least = self.least(points, 0.0, 2.0, DEEP * self.size)
        return np.where(least > 0, least / 2, least)

    def least(self, points, tolerance, caution, enough):
        """The least distance of points (n, 3) from the poses looked at, found to a tolerance where it is 0: (n,).

        Deeper than enough none is searched for.
        """
        found = np.empty(len(points))
        for start in range(0, len(points), CHUNK):
            some = slice(start, start + CHUNK)
            found[some] = self.followed(points[some] - self.middle, tolerance, caution, enough)
        return found

    def followed(self, places, tolerance, caution, enough):
        """The same for so few places about the middle that all fit into a processor's cache."""
        least = np.full(len(places), np.inf)
        gaps = self.left_open(places, caution, enough, least)
        while len(gaps[0]):
            point, low, high, speed = (part[least[gaps[0]] >= -enough] for part in gaps)
            length, middle = high - low, (low + high) / 2
            short = length <= SHORTEST * self.total
            short &= speed * length > HALVED * tolerance
            if short.any():
                np.minimum.at(least, point[short], self.searched(places[point[short]], low[short], high[short]))
            point, low, high, speed, middle, length = (
                part[~short] for part in (point, low, high, speed, middle, length)
            )
            distance = self.at(places[point], middle)
            np.minimum.at(least, point, distance)
            clear = np.maximum(distance, 0.0) / speed
            open_ = (2 * clear < length) & (speed * length > tolerance)
            parts = ((low, middle - clear), (middle + clear, high))
            gaps = [np.concatenate([part[open_] for part in side]) for side in zip(*parts, strict=True)]
            gaps = [np.tile(point[open_], 2), *gaps, np.tile(speed[open_], 2)]
        return least

    def left_open(self, places, caution, enough, least):
        """What the poses leave open of the ways of places: their numbers, from where, to where, and how fast they move.

        At a pose a place moves at a known speed v, which changes by no more than its bend b: within a step h it goes
        no farther than v h + b h^2 / 2.
        """
        until, gaps = np.zeros(len(places)), []
        bend = caution * (self.bend[0] * norms(places) + self.bend[1])
        for s, first, motion, rate in self.poses:
            if first:
                until[:] = s
                asked = np.flatnonzero(least >= -enough)
            else:
                asked = np.flatnonzero((until < s) & (least >= -enough))
            matrix, change = motion[:9].reshape(3, 3), rate[:9].reshape(3, 3)
            some = places[asked]
            distance = self.solid.distance(some @ matrix.T + motion[9:])
            speed = caution * norms(some @ change.T + rate[9:])
            least[asked] = np.minimum(least[asked], distance)
            ahead, bent = np.maximum(distance, 0.0), bend[asked]
            root = speed + np.sqrt(speed**2 + 2 * bent * ahead)
            clear = 2 * ahead / np.where(root > 0, root, 1.0)
            clear[root == 0] = self.total
            open_ = np.flatnonzero(s - clear > until[asked])
            point, low = asked[open_], until[asked[open_]]
            gaps.append((point, low, s - clear[open_], speed[open_] + bent[open_] * (s - low)))
            until[asked] = s + clear
        return [np.concatenate(part) for part in zip(*gaps, strict=True)]

    def searched(self, places, low, high):
        """The least distance between two places of the way, by golden sections: (n,)."""
        a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        at_a, at_b = self.at(places, a), self.at(places, b)
        for _ in range(STEPS):
            left = at_a < at_b
            low, high = np.where(left, low, a), np.where(left, b, high)
            a, b = np.where(left, high - GOLDEN * (high - low), b), np.where(left, a, low + GOLDEN * (high - low))
            asked = self.at(places, np.where(left, a, b))
            at_a, at_b = np.where(left, asked, at_b), np.where(left, at_a, asked)
        return np.minimum(np.minimum(at_a, at_b), np.minimum(self.at(places, low), self.at(places, high)))

    def at(self, places, s):
        """How far places about the middle, (n, 3), are from the solid when it has come so far: (n,)."""
        panel = np.clip(np.searchsorted(self.panels.start, s, side="right") - 1, 0, len(self.panels.start) - 1)
        start, end = self.panels.start[panel], self.panels.end[panel]
        held = self.panels.at(panel, np.clip((2 * s - start - end) / (end - start), -1.0, 1.0))
        local = np.einsum("nij,nj->ni", held[:, :9].reshape(-1, 3, 3), places)
        return self.solid.distance(local + held[:, 9:])

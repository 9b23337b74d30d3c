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

from ...trajectories.arc_length import arc_length
from ...vectors import norms
from ..labels import IN, ON, OUT, decided
from ..motion.boxes import corners
from ..motion.changes import BEYOND
from ..motion.golden import least_between
from ..motion.panels import NODES, derivative, panels, powers
from ..motion.ways import PARTS, apart

CHUNK = 1 << 14  # points that fit into a processor's cache
LOOKED = 65
POSES = 32  # at least, that are looked at for all points
SHORTEST = 1e-3  # of the way: what is left of it when it is not halved any more, but searched
HALVED = 32.0  # tolerances: what the solid moves in less is halved on
DEEP = 1e-3  # of the size
ROOM = 1.1  # of what changes, for what changes faster between places that were looked at
SAME = 1e-7  # of the size: motions that differ by more jump or turn at once


class MovingSolid:
    """All points that a solid visits.

    Parameters
    ----------
    solid : member
        With a ``distance``.
    motion : Motion
        What it makes of the solid itself is told by the change.
    change : Change, optional
    """

    is_sheet = False

    def __init__(self, solid, motion, change=None):
        self.solid, self.change, self.overlaps = solid, change, solid.overlaps
        motion, whole = motion.rigid, motion
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
        half = ((self.panels.end - self.panels.start) / 2)[:, None, None]
        self.rates = derivative(self.panels.series) / half
        bent = derivative(self.rates) / half
        bend = np.einsum("kcj,ij->kic", bent, powers(NODES))
        self.bend = ROOM * np.sqrt((bend[..., :9] ** 2).sum(axis=2)).max(), ROOM * norms(bend[..., 9:]).max()
        self.poses = list(self.looked())
        turning = np.sqrt((np.einsum("kcj,ij->kic", self.rates, powers(NODES))[..., :9] ** 2).sum(axis=2)).max()
        self.box = self.around(whole, turning)

    def around(self, motion, turning):
        """The box of all poses: that of some, and what may be beyond it between them."""
        s = np.linspace(0.0, self.total, LOOKED)
        poses = motion.at(s)
        places = motion.posed(self.change.places if self.change else corners(self.solid.box), poses)
        far = norms(places - poses.origin[:, None]).max()
        beyond = far * (turning * s[1]) ** 2 + s[1] + (self.change.most(s) if self.change else 0.0)
        return np.stack((places.min(axis=(0, 1)) - beyond, places.max(axis=(0, 1)) + beyond))

    def looked(self):
        """Poses to look at all points in.

        Of each the arc length, whether a smooth piece begins, the motion and its rate, how fast the solid changes about
        it, and how far on it does so.
        """
        start, end = self.panels.start, self.panels.end
        sides = np.stack((self.panels.series, self.rates))
        begun, ended = (sides @ side ** np.arange(sides.shape[-1]) for side in (-1.0, 1.0))
        sizes = np.append(np.ones(9), np.full(3, self.size))
        jumps = (np.abs(begun[:, 1:] - ended[:, :-1]) > SAME * sizes * [[[1.0]], [[1e3]]]).any(axis=(0, 2))
        first = np.append(0, np.flatnonzero(jumps) + 1)
        for a, b in zip(first, np.append(first[1:], len(start)), strict=True):
            count = max(int(np.ceil(POSES * (end[b - 1] - start[a]) / self.total)), 1)
            places = np.linspace(start[a], end[b - 1], count + 1)
            places = self.change.spread(places) if self.change else places
            for number, s in enumerate(places):
                panel = min(max(int(np.searchsorted(start, s, side="right")) - 1, a), b - 1)
                x = np.clip((2 * s - start[panel] - end[panel]) / (end[panel] - start[panel]), -1.0, 1.0)
                basis = powers(np.array([x]))[0]
                beside = places[max(number - 1, 0)], places[min(number + 1, len(places) - 1)]
                change = self.change.around(*beside) if self.change else (0.0, np.inf)
                yield s, number == 0, self.panels.series[panel] @ basis, self.rates[panel] @ basis, *change

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
        gaps = self.left_open(places, tolerance, caution, enough, least)
        while len(gaps[0]):
            point, low, high, speed = (part[least[gaps[0]] >= -enough] for part in gaps)
            length, middle = high - low, (low + high) / 2
            short = length <= SHORTEST * self.total
            short &= speed * length > HALVED * tolerance
            if short.any():
                found = self.searched(places[point[short]], low[short], high[short], tolerance, enough)
                np.minimum.at(least, point[short], found)
            point, low, high, speed, middle, length = (
                part[~short] for part in (point, low, high, speed, middle, length)
            )
            distance = self.at(places[point], middle, tolerance)
            np.minimum.at(least, point, distance)
            clear = np.maximum(distance, 0.0) / speed
            open_ = (2 * clear < length) & (speed * length > tolerance)
            parts = ((low, middle - clear), (middle + clear, high))
            gaps = [np.concatenate([part[open_] for part in side]) for side in zip(*parts, strict=True)]
            gaps = [np.tile(point[open_], 2), *gaps, np.tile(speed[open_], 2)]
        return least

    def left_open(self, places, tolerance, caution, enough, least):
        """What the poses leave open of the ways of places: their numbers, from where, to where, and how fast they move.

        At a pose a place moves at a known speed v, which changes by no more than its bend b: within a step h it goes
        no farther than v h + b h^2 / 2.
        """
        until, gaps = np.zeros(len(places)), []
        bend = caution * (self.bend[0] * norms(places) + self.bend[1])
        for s, first, motion, rate, growth, horizon in self.poses:
            if first:
                until[:] = s
                asked = np.flatnonzero(least >= -enough)
            else:
                asked = np.flatnonzero((until < s) & (least >= -enough))
            matrix, change = motion[:9].reshape(3, 3), rate[:9].reshape(3, 3)
            some = places[asked]
            distance = self.from_solid(some @ matrix.T + motion[9:], s, tolerance)
            speed = caution * (norms(some @ change.T + rate[9:]) + growth)
            least[asked] = np.minimum(least[asked], distance)
            ahead, bent = np.maximum(distance, 0.0), bend[asked]
            root = speed + np.sqrt(speed**2 + 2 * bent * ahead)
            clear = 2 * ahead / np.where(root > 0, root, 1.0)
            clear[root == 0] = self.total
            open_ = np.flatnonzero(s - clear > until[asked])
            point, low = asked[open_], until[asked[open_]]
            gaps.append((point, low, s - clear[open_], speed[open_] + bent[open_] * (s - low)))
            until[asked] = np.minimum(s + clear, horizon)
        return [np.concatenate(part) for part in zip(*gaps, strict=True)]

    def searched(self, places, low, high, tolerance, enough):
        """The least distance between two places of the way, as far as it decides something: (n,)."""

        exact = 0.0 if self.change else tolerance  # a bound that is exact in places alone leads astray

        def far(which, s):
            return self.at(places[which], s, exact)

        least, s = least_between(far, low, high, tolerance, enough)
        return self.at(places, s, tolerance) if self.change else least

    def at(self, places, s, tolerance):
        """How far places about the middle, (n, 3), are from the solid when it has come so far: (n,)."""
        return self.from_solid(self.seen(places, s), s, tolerance)

    def seen(self, places, s):
        """Places about the middle, (n, 3), as seen by the rigid motion when it has come so far: (n, 3)."""
        held = self.panels.held(s)
        return np.einsum("nij,nj->ni", held[:, :9].reshape(-1, 3, 3), places) + held[:, 9:]

    def from_solid(self, places, s, tolerance):
        """How far places (n, 3), as seen by the rigid motion, are from the solid, or less: (n,).

        Within a tolerance it is no less. Where the solid may be told to be too near, labels tell what is so.
        """
        change = self.change
        found = change.distance(self.solid, places, s, tolerance) if change else self.solid.distance(places)
        near = np.flatnonzero(np.abs(found) <= tolerance) if self.overlaps and tolerance else ()
        if len(near):
            own = places[near]
            labels = decided(self.solid.labels(own, tolerance), own, tolerance, self.solid)
            found[near] = np.where(labels == ON, found[near], -BEYOND * tolerance * labels)
        return found

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sheets that move as sets of points: a point is in if the sheet passes over it, from one side to the other.

Seen from the sheet the point moves. Where its way leads through the sheet, from more than a tolerance on one side to
more than that on the other, and no nearer to the rim than that, the ways of all points within the tolerance do so too,
so it is in. Where its way comes near the sheet otherwise it is on: at the rim, which leaves the sides, at the poses in
which the sheet begins and ends, and where it turns back.

A short way between two places on different sides crosses the sheet for sure where their nearest places are in one
triangle, or in two that share an edge, and the rim is farther from them than all these are from each other: then ways
with the same ends cross it as often, but for pairs of crossings.
"""

from typing import NamedTuple

import numpy as np

from ..labels import IN, ON, OUT, TOUCHED
from ..motion.golden import least_between
from ..motion.panels import at_both
from .moving_solid import CHUNK, SAME, SHORTEST, MovingSolid
from .sides import Seen

ROUNDS = 40  # of halving, where a way crosses the sheet
DOUBLINGS = 64  # of steps away from a contact
SIDES = 9  # places of a contact where the rim is looked for
SURE = 1e-9  # of the size: what it has passed over by so much is inside
WIDER = 2.0  # times as far as at its ends a way may be seen to lead, of a sheet that is scaled


class State(NamedTuple):
    """The sheet as points see it at places of the way."""

    value: np.ndarray  # how far it is, or less, negative behind it: (n,)
    depth: np.ndarray  # the same in its own space: (n,)
    face: np.ndarray
    part: np.ndarray
    foot: np.ndarray
    place: np.ndarray  # the points as the sheet has them: (n, 3)
    least: np.ndarray  # what a length of the sheet's own space is at least: (n,)

    def only(self, which):
        return State(*(part[which] for part in self))


class Ways(NamedTuple):
    """Pieces of the ways of points."""

    point: np.ndarray
    low: np.ndarray
    high: np.ndarray
    speed: np.ndarray
    before: State
    after: State

    def only(self, which):
        parts = (part[which] for part in self[:4])
        return Ways(*parts, self.before.only(which), self.after.only(which))


class MovingSheet(MovingSolid):
    """All points that a sheet visits.

    Parameters
    ----------
    sheet : Sided
    motion : Motion
    back : bool
        Whether it comes back to where it began.
    change : Change, optional
    """

    def __init__(self, sheet, motion, back, change=None):
        super().__init__(sheet, motion, change)
        begun, ended = at_both(self.panels.series)
        sizes = np.append(np.ones(9), np.full(3, self.size))
        jumps = np.flatnonzero((np.abs(begun[1:] - ended[:-1]) > SAME * sizes).any(axis=1))
        self.jumps = np.concatenate(([0.0], self.panels.start[jumps + 1], [self.total]))
        self.back, self.overlaps = back and len(self.jumps) == 2, True

    def from_solid(self, places, s, tolerance):
        """Half of how much farther than a tolerance places are from the sheet: so much is left on both of its sides."""
        return (np.abs(self.state(places, s, tolerance).value) - tolerance) / 2

    def state(self, seen, s, tolerance):
        """The sheet as places (n, 3) see it that are seen by the rigid motion."""
        if not self.change:
            found = self.solid.seen(seen)
            return State(found.depth, *found, seen, np.broadcast_to(1.0, len(seen)))
        own = self.change.back(seen, s)
        found = self.solid.seen(own.places)
        value, beyond = own.least * found.depth, own.away > 0
        value = np.where(beyond, own.away + np.abs(value), value)
        near = np.flatnonzero((np.abs(value) <= tolerance) & (found.face >= 0))
        maps = self.change.maps(own.places[near], s if np.ndim(s) == 0 else s[near])
        far = self.solid.mapped(own.places[near], Seen(*(part[near] for part in found)), maps)
        value[near] = np.copysign(np.where(beyond[near], np.hypot(far, own.missed[near]), far), value[near])
        face = np.where(beyond, -1, found.face)
        return State(value, found.depth, face, found.part, found.foot, own.places, own.least)

    def at_times(self, places, s, tolerance):
        """The sheet as places about the middle, (n, 3), see it when it has come so far."""
        return self.state(self.seen(places, s), s, tolerance)

    def labels(self, points, tolerance):
        """IN, ON, OUT, or TOUCHED where a neighbourhood decides, for points (n, 3): (n,) int8."""
        labels = np.empty(len(points), dtype=np.int8)
        for start in range(0, len(points), CHUNK):
            some = slice(start, start + CHUNK)
            labels[some] = self.passed(points[some] - self.middle, tolerance)
        return labels

    def distance(self, points):
        """How far points (n, 3) are from all poses, or less, and 0 where the sheet has passed over them: (n,)."""
        inside = self.labels(points, SURE * self.size) == IN
        return np.where(inside, 0.0, super().distance(points))

    def passed(self, places, tolerance):
        """The labels of so few places about the middle that all fit into memory."""
        gaps = self.left_open(places, tolerance, 1.0, np.inf, np.full(len(places), np.inf))
        point, low, high, speed = gaps
        ends = (self.at_times(places[point], end, tolerance) for end in (low, high))
        ways, inside, short = Ways(point, low, high, speed, *ends), np.zeros(len(places), dtype=bool), []
        while len(ways.point):
            inside[ways.point[self.through(ways, tolerance)]] = True
            far = np.abs(ways.before.value) + np.abs(ways.after.value)
            length = ways.high - ways.low
            ways = ways.only(~inside[ways.point] & (far <= ways.speed * length + 2 * tolerance))
            length = ways.high - ways.low
            done = (length <= SHORTEST * self.total) | (ways.speed * length <= tolerance)
            short.append(ways.only(done))
            ways = ways.only(~done)
            middle = (ways.low + ways.high) / 2
            there = self.at_times(places[ways.point], middle, tolerance)
            ways = joined([ways._replace(high=middle, after=there), ways._replace(low=middle, before=there)])
        return self.labelled(places, inside, joined(short) if short else ways, tolerance)

    def through(self, ways, tolerance):
        """Which pieces of ways lead through the sheet for sure: (k,) bool."""
        before, after = ways.before, ways.after
        found = (np.minimum(np.abs(before.value), np.abs(after.value)) > tolerance) & (
            np.sign(before.value) != np.sign(after.value)
        )
        found &= (before.face >= 0) & (after.face >= 0)
        which = np.flatnonzero(found)
        before, after = before.only(which), after.only(which)
        least = np.minimum(before.least, after.least) / (WIDER if self.change else 1.0)
        way = (ways.speed * (ways.high - ways.low))[which] / least
        far = np.maximum(np.abs(before.depth) + way, self.solid.between(before, after)) + tolerance / least
        known = np.flatnonzero(np.isfinite(far))
        found[which] = False
        clear = self.solid.from_rim(before.foot[known]) > far[known]
        found[which[known[clear]]] = True
        return found

    def labelled(self, places, inside, short, tolerance):
        """The labels, of points of which some are known to be inside, from short ways of the others."""
        short = short.only(~inside[short.point])
        short = short.only(np.lexsort((short.low, short.point)))
        s, near = self.contacts(places, short, tolerance)
        held = near & (np.abs(short.before.value) <= tolerance)
        again = np.append(False, (np.diff(short.point) == 0) & (short.low[1:] == short.high[:-1]))[: len(near)]
        again[1:] &= near[:-1]
        which = np.flatnonzero(near & ~(held & again))  # of one contact its first piece
        point, s, speed = short.point[which], s[which], short.speed[which]
        low, high, sides, rim = self.contact(places[point], s, speed, tolerance)
        crosses = sides[0] * sides[1] < 0
        inside[point[crosses & ~rim]] = True
        counted = np.bincount(point, apart(point, low, high), len(places))
        return np.where(inside, IN, np.choose(np.minimum(counted, 2).astype(int), (OUT, ON, TOUCHED))).astype(np.int8)

    def contacts(self, places, short, tolerance):
        """Where short pieces of ways are nearest to the sheet, and whether that is within the tolerance: two (k,)."""
        before, after = (np.abs(side.value) for side in (short.before, short.after))
        s = np.where(before <= after, short.low, short.high)
        near = np.minimum(before, after) <= tolerance
        flips = np.flatnonzero(~near & (np.sign(short.before.value) != np.sign(short.after.value)))
        s[flips], near[flips] = self.crossing(places, short.only(flips), tolerance)
        others = np.flatnonzero(~near)
        s[others], near[others] = self.nearest(places, short.only(others), tolerance)
        return s, near

    def crossing(self, places, ways, tolerance):
        """Where pieces of ways change sides, and whether they cross the sheet there: two (k,)."""
        low, high, side = ways.low.copy(), ways.high.copy(), np.sign(ways.before.value)
        middle, value, left = (low + high) / 2, np.full(len(low), np.inf), np.arange(len(low))
        for _ in range(ROUNDS):
            middle[left] = (low + high)[left] / 2
            value[left] = self.at_times(places[ways.point[left]], middle[left], tolerance).value
            same = np.sign(value[left]) == side[left]
            low[left[same]], high[left[~same]] = middle[left[same]], middle[left[~same]]
            left = left[np.abs(value[left]) > tolerance]
        return middle, np.abs(value) <= tolerance

    def nearest(self, places, ways, tolerance):
        """Where pieces of ways are nearest, and whether that is within the tolerance: two (k,)."""
        places = places[ways.point]

        exact = 0.0 if self.change else tolerance  # a bound that is exact in places alone leads astray

        def beyond(which, s):
            return np.abs(self.at_times(places[which], s, exact).value) - exact

        least, s = least_between(beyond, ways.low, ways.high, tolerance - exact, 0.0)
        if self.change:
            least = np.abs(self.at_times(places, s, tolerance).value) - tolerance
        return s, least <= 0

    def contact(self, places, s, speed, tolerance):
        """How long ways stay near the sheet about a contact, on which side they come and go, and if the rim is near.

        Parameters
        ----------
        places : (k, 3) float array
        s, speed : (k,) float array
        tolerance : float

        Returns
        -------
        low, high : (k,) float array
        sides : two (k,) float arrays
            -1 or 1, or 0 where the way of the sheet begins or ends.
        rim : (k,) bool array
        """
        piece = np.clip(np.searchsorted(self.jumps, s, side="right"), 1, len(self.jumps) - 1)
        limits = [self.jumps[piece - 1], self.jumps[piece]]
        if self.back:
            limits = [s - self.total / 2, s + self.total / 2]
        ends, sides = [], []
        for limit, way in zip(limits, (-1.0, 1.0), strict=True):
            end, side, left = s.copy(), np.zeros(len(s)), np.arange(len(s))
            step = tolerance / np.maximum(speed, 1e-300)
            for _ in range(DOUBLINGS):
                end[left] = way * np.minimum(way * (s + way * step)[left], way * limit[left])
                value = self.at_times(places[left], self.within(end[left]), tolerance).value
                side[left] = np.where(np.abs(value) > tolerance, np.sign(value), 0.0)
                left = left[(side[left] == 0) & (end[left] != limit[left])]
                if not len(left):
                    break
                step[left] *= 2
            ends.append(end)
            sides.append(side)
        rim = np.zeros(len(s), dtype=bool)
        for part in np.linspace(0.0, 1.0, SIDES):
            at = self.within(ends[0] + part * (ends[1] - ends[0]))
            there = self.at_times(places, at, tolerance)
            maps = self.change.maps(there.place, at) if self.change else None
            rim |= self.solid.from_rim(there.place, maps) <= tolerance
        return *ends, sides, rim

    def within(self, s):
        """Places of a way that comes back."""
        return s % self.total if self.back else s


def apart(point, low, high):
    """Which of some stretches of points' ways begin where no other of the same point is: (k,) int."""
    order = np.lexsort((low, point))
    wide = 2 * (high.max(initial=0.0) - low.min(initial=0.0) + 1.0)
    begins, ends = ((side + wide * point)[order] for side in (low, high))
    found = np.ones(len(point), dtype=int)
    found[order[1:]] = begins[1:] > np.maximum.accumulate(ends)[:-1]
    return found


def joined(several):
    """Several pieces of ways as one."""
    parts = [np.concatenate([ways[number] for ways in several]) for number in range(4)]
    states = [State(*map(np.concatenate, zip(*(ways[number] for ways in several), strict=True))) for number in (4, 5)]
    return Ways(*parts, *states)

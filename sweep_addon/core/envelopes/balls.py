# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Balls along a trajectory: how fast their radius grows, and where one ball swallows the next.

A ball touches the envelope of all balls in a circle that leans back by asin(dr/ds), its lean: where the radius grows,
the circle is behind the middle. Where dr/ds comes to 1 the circle is a point, and beyond that there is none: each ball
lies within the next. So the lean, between minus and plus a quarter of a turn, says all about a place.
"""

from functools import cached_property, lru_cache

import numpy as np

from ..declared.parameters import LARGEST, ShapeError, at, require
from ..formulas.jets import Jet, composed
from ..stations.cells import cut
from ..stations.search import highest
from ..trajectories.arc_length import arc_length
from ..variation.laws import Formula
from ..vectors import dot, norms

UPRIGHT = np.pi / 2
NOTHING = 1e-7  # of the largest radius: single precision cannot tell a ball this small from a point
NEARLY = 0.01  # of the largest radius: between places so close it may come to 0
SHARPLY = 68  # narrowings: 1e-14 of an interval is left
BENT = 0.02  # radians: a lean that changes so much at once has a circle before and one after
SAME = 1e-6  # radians
JUMP = 1e-6  # of the largest radius
HALVINGS, MOST_CELLS = 40, 1 << 14
BISECTIONS = 60
ASIDE = 1e-9  # of the domain: how far beside a place the slope is asked for where it has none there
PARABOLA = 1e-4  # of the way between joints: the step of differences


class Balls:
    """The balls that a trajectory carries, their radius a law times that of the curve itself, times a factor.

    Attributes
    ----------
    largest : float
        The largest radius in metres.
    u, s : (n,) float array
        Parameters and arc lengths all along the trajectory where it is looked at them.
    kinks : (k, 2) float array
        The ends of the smallest pieces of the domain in which the lean changes at once within the law.

    What is asked of places is asked of parameters u, (n,), and of arc lengths s where they are known.
    """

    def __init__(self, trajectory, law, factor=1.0):
        self.trajectory, self.law, self.factor = trajectory, law, factor
        self.measure = arc_length(trajectory)
        self.u = cut(self.measure)
        self.s = self.measure.at(self.u)
        self.largest, self.kinks = 0.0, np.zeros((0, 2))
        sizes = self.size(self.u, self.s)
        least, most = sizes.argmin(), float(sizes.max())
        if sizes[least] < -NOTHING * max(most, 0.0):
            place = f"got {sizes[least]:.6g} at u = {self.u[least]:.6g}"
            raise ShapeError(f"must nowhere be less than 0, {place}", "radius")
        require(most > 0, "must somewhere be more than 0", most, "radius")
        require(most <= LARGEST, f"must be at most {LARGEST:g} in size", most, "radius")
        self.largest = most
        if isinstance(law, Formula) and not law.is_constant:
            self.kinks = self.found_kinks()

    @property
    def is_constant(self):
        """Whether all balls are of one size."""
        return self.law.is_constant and not self.trajectory.carries

    def radius(self, u, s=None):
        """The radius in metres, (n,); 0 where it is next to nothing."""
        found = self.size(u, s)
        return np.where(np.abs(found) <= NOTHING * self.largest, 0.0, found)

    def size(self, u, s=None):
        """The radius as it is evaluated."""
        s = self.measure.at(u) if s is None else s
        with at("radius"):
            found = self.factor * self.law.evaluate(u, s / self.measure.total, s)
        return found * self.trajectory.carried(u)[0] if self.trajectory.carries else found

    def slopes(self, u, s=None, before=False):
        """The first and the second derivative of the radius by arc length, (n,) twice, before or after a kink."""
        u, s = np.array(u, dtype=float), np.array(self.measure.at(u) if s is None else s)
        if len(self.kinks):
            near = np.clip(np.searchsorted(self.kinks[:, 0], u, side="right") - 1, 0, len(self.kinks) - 1)
            low, high = self.kinks[near].T
            inside = (low <= u) & (u <= high)
            u[inside] = (low if before else high)[inside]
            s[inside] = self.measure.at(u[inside])
        first, second = self.jet(u, s, before).series[1:]
        lost = np.isnan(first)
        if lost.any():  # as where a root of 0 is divided by itself
            beside = u[lost] + ASIDE * (sum(self.trajectory.domain) / 2 - u[lost])
            first[lost], second[lost] = self.jet(beside, self.measure.at(beside), before).series[1:]
        return np.nan_to_num(first, nan=0.0, posinf=np.inf, neginf=-np.inf), 2 * np.nan_to_num(second)

    def jet(self, u, s, before):
        """The radius as a jet by arc length."""
        if self.is_constant:
            return Jet(np.stack((np.full(len(u), self.largest), 0 * u, 0 * u)))
        first, second = self.trajectory.first_two(u, before)
        speed, one = norms(first), np.ones(len(u))
        with np.errstate(all="ignore"):
            place = Jet(np.stack((u, 1 / speed, -dot(first, second) / speed**4 / 2)))
            length, share = (Jet(np.stack((s, one, 0 * one))) * part for part in (1.0, 1 / self.measure.total))
            found = self.factor * self.law.jet(place, share, length)
            return found * composed(place, lambda u: self.carried(u, before)) if self.trajectory.carries else found

    def carried(self, u, before):
        """The radius of the curve itself and its derivatives by u, exact where it is a parabola between joints.

        Of a cubic the slope is wrong by a third of the square of the step at most, by 3e-9.
        """
        joints = self.trajectory.joints()
        side = "left" if before else "right"
        i = np.clip(np.searchsorted(joints, u, side=side) - 1, 0, len(joints) - 2)
        step = PARABOLA * (joints[i + 1] - joints[i])
        middle = np.clip(u, joints[i] + step, joints[i + 1] - step)
        low, here, high = (self.trajectory.carried(middle + k * step)[0] for k in (-1, 0, 1))
        bend = (low - 2 * here + high) / step**2
        bend[np.abs(low - 2 * here + high) <= 1e-12 * np.abs(here)] = 0.0
        return [self.trajectory.carried(u)[0], (high - low) / (2 * step) + bend * (u - middle), bend, 0 * u]

    def lean(self, u, s=None, before=False):
        """The lean of the circles in radians, (n,): a quarter of a turn where there is none."""
        return np.arcsin(np.clip(self.slopes(u, s, before)[0], -1.0, 1.0))

    def folding(self, u, s, curvature):
        """How far the surface folds where the trajectory bends so much: (n,), not negative where it does.

        A point x of the circle is where f = |x - t|^2 - r^2 is level along the trajectory. The surface goes forward
        there while f is least: while f''/2 = 1 - r'^2 - r r'' - (x - t) . k is more than 0, with the curvature vector
        k. Towards the centre of curvature (x - t) . k is r cos(lean) |k|.
        """
        radius, (slope, change) = self.radius(u, s), self.slopes(u, s)
        with np.errstate(all="ignore"):
            found = slope**2 + radius * change + radius * np.sqrt(1 - slope**2) * curvature - 1
        return np.where(np.abs(slope) < 1, np.clip(found, -2.0, 2.0), -1.0)  # beyond there are no circles

    def swallowing(self, u, s=None, before=False):
        """Whether balls lie within a neighbour: (n,) bool."""
        return np.abs(self.slopes(u, s, before)[0]) >= 1

    def found_kinks(self):
        """The ends of the smallest pieces of the domain in which the lean changes at once: (k, 2)."""
        low, high, ends = self.u[:-1], self.u[1:], (self.s[:-1], self.s[1:])
        narrow = 8 * np.finfo(float).eps * np.abs(self.trajectory.domain).max()
        for _ in range(HALVINGS):
            slopes = [
                self.slopes(u, s, before)[0] for u, s, before in zip((low, high), ends, (False, True), strict=True)
            ]
            bent = np.abs(np.diff(np.arcsin(np.clip(slopes, -1.0, 1.0)), axis=0)[0]) > BENT
            jump = np.abs(self.size(high, ends[1]) - self.size(low, ends[0])) - JUMP * self.largest
            jumps = jump > 2 * np.abs(slopes).max(axis=0) * (ends[1] - ends[0])
            broken = bent | jumps
            low, high, jumps = low[broken], high[broken], jumps[broken]
            if not len(low) or (high - low).max() <= narrow:
                break
            if len(low) > MOST_CELLS:
                return np.zeros((0, 2))  # it only changes very quickly
            middle = (low + high) / 2
            low, high = np.append(low, middle), np.append(middle, high)
            ends = [self.measure.at(u) for u in (low, high)]
        if jumps.any():
            raise ShapeError(f"must not jump, got a jump near u = {low[jumps][0]:.6g}", "radius")
        order = np.argsort(low)
        low, high = low[order], high[order]
        apart = low[1:] > high[:-1]  # pieces side by side have the kink between them
        first, last = (np.append(True, apart), np.append(apart, True)) if len(low) else ([], [])
        return np.stack((low[first], high[last]), axis=1)

    @cached_property
    def breaks(self):
        """Parameters within the domain where the lean changes at once: (k,)."""
        inner = self.trajectory.joints()[1:-1]
        inner = inner[np.abs(self.lean(inner, before=True) - self.lean(inner)) > SAME]
        found = np.sort(np.concatenate((inner, self.kinks.mean(axis=1))))
        first, last = self.trajectory.domain
        margin = ASIDE * (last - first)
        return found[(found > first + margin) & (found < last - margin)]

    @cached_property
    def limits(self):
        """Parameters where a ball begins to swallow the next, or ends to, other than at once: (k,)."""
        if self.is_constant:
            return self.u[:0]
        nodes = np.unique(np.concatenate((self.u, self.kinks.ravel())))
        s = self.measure.at(nodes) if len(self.kinks) else self.s
        low, high = nodes[:-1], nodes[1:]
        first, last = self.swallowing(low, s[:-1]), self.swallowing(high, s[1:], before=True)
        change = np.flatnonzero((first != last) & ~np.isin(low, self.kinks[:, 0]))
        low, high, first = low[change], high[change], first[change]
        for _ in range(BISECTIONS if len(change) else 0):
            middle = (low + high) / 2
            same = self.swallowing(middle) == first
            low, high = np.where(same, middle, low), np.where(same, high, middle)
        return (low + high) / 2

    @cached_property
    def points(self):
        """Parameters within the domain where the radius comes to 0: (k,)."""
        u, size = self.u, self.size(self.u, self.s)
        least = (size[1:-1] <= size[:-2]) & (size[1:-1] <= size[2:]) & (size[1:-1] < NEARLY * self.largest)
        if not least.any():
            return u[:0]
        place, _ = highest(lambda u: -self.size(u), u[:-2][least], u[2:][least], SHARPLY)
        place = place[self.radius(place) == 0]
        apart = np.abs(place[:, None] - self.breaks).min(axis=1, initial=np.inf)
        return np.unique(place[apart > ASIDE * (u[-1] - u[0])])

    @cached_property
    def swallowed(self):
        """From which parameters to which each ball lies within a neighbour: (k, 2)."""
        ends = np.unique(np.concatenate((self.trajectory.domain, self.limits, self.breaks)))
        slope = self.slopes((ends[1:] + ends[:-1]) / 2)[0]
        side = np.where(np.abs(slope) >= 1, np.sign(slope), 0.0)
        first = np.flatnonzero(np.diff(side, prepend=0.0) != 0)
        stretches = np.split(np.arange(len(side)), first[first > 0])
        return np.array([(ends[i[0]], ends[i[-1] + 1]) for i in stretches if side[i[0]]]).reshape(-1, 2)


@lru_cache(maxsize=16)
def balls(trajectory, law, factor=1.0):
    """The balls along a trajectory, so many times as large as the law says, looked at once for equal ones."""
    return Balls(trajectory, law, factor)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arc length: how far along a trajectory each parameter is, and the way back."""

from functools import cached_property, lru_cache

import numpy as np

from ..declared.parameters import require
from ..stations.chebyshev import angles, fitting, summed

# Gauss-Legendre quadrature with five nodes; numpy.polynomial, which knows them too, takes 3 ms to import.
INNER, OUTER = np.sqrt(5 - 2 * np.sqrt(10 / 7)) / 3, np.sqrt(5 + 2 * np.sqrt(10 / 7)) / 3
NODES = np.array([-OUTER, -INNER, 0, INNER, OUTER])
WEIGHTS = (np.array([322, 322, 512, 322, 322]) + 13 * np.sqrt(70) * np.array([-1, 1, 0, 1, -1])) / 900
PANELS = 128  # at least
CONVERGED = 1e-12  # of the whole length: the change of all panels when they are halved
NOISE = 1e-9  # of the whole length: rounding is always less
STILL = 1e-14  # of the whole length: a panel of less is a place where the trajectory stands still
SHORTEST = 1e-12  # metres
EXACT = 1e-14  # of the whole length: how near a parameter is to its arc length
FEW_STEPS, MOST_STEPS = 8, 60  # of Newton's method: more than a few only where the speed vanishes, or for rounding
MOST_PANELS = 1 << 15  # more are taken as they are
STEADY = 1e-15  # of the speed: it is the same everywhere, but for rounding
TERMS = 11  # of a polynomial for the way back in a panel
MANY = 2  # arc lengths for each of these terms; for fewer the polynomials are not worth making


class ArcLength:
    """The arc length s(u) of a trajectory by Gauss-Legendre quadrature, and its inverse u(s).

    Attributes
    ----------
    nodes, lengths : (k,) float array
        Parameters between which quadrature is exact to rounding, and the arc length at each.
    total : float
        The length of the whole trajectory in metres.
    steady : bool
        Whether there is one speed alone, as on lines, arcs and helices. Both ways are proportions then.
    """

    def __init__(self, trajectory):
        self.trajectory = trajectory
        joints = trajectory.joints()
        parts = max(4, -(-PANELS // (len(joints) - 1)))
        if trajectory.pace:
            self.nodes = subdivided(joints, 2 * parts)
            self.lengths, self.steady = trajectory.pace * (self.nodes - joints[0]), True
        else:
            self.add_up(subdivided(joints, parts))
        self.total = float(self.lengths[-1])
        require(self.total >= SHORTEST, f"must be at least {SHORTEST:g} m long", self.total)

    def add_up(self, nodes):
        """Find the lengths of the pieces between nodes, halved until that changes them no more."""
        start, end = nodes[:-1], nodes[1:]
        speeds = self.met(start, end)
        pieces = (end - start) / 2 * (speeds @ WEIGHTS)
        kept, total, before = [], pieces.sum(), np.inf
        while len(start) <= MOST_PANELS:
            # panel by panel: the errors of a closed curve's panels cancel in the sum long before they are small
            middle = (start + end) / 2
            halves = np.stack((self.measure(start, middle), self.measure(middle, end)))
            change = np.abs(halves.sum(axis=0) - pieces)
            rough = change > CONVERGED * total / PANELS
            start, pieces = np.stack((start, middle)), halves
            kept.append((start[:, ~rough].ravel(), pieces[:, ~rough].ravel()))
            start, pieces, end = start[:, rough].ravel(), pieces[:, rough].ravel(), np.append(middle[rough], end[rough])
            noise = before / 2 < change.sum() < NOISE * total  # it does not shrink: it is rounding
            before = change.sum()
            if noise or not len(start):
                break
        start, pieces = (np.concatenate(part) for part in zip(*kept, (start, pieces), strict=True))
        pieces[pieces <= STILL * pieces.sum()] = 0.0
        order = np.argsort(start)
        self.nodes = np.append(start[order], nodes[-1])
        self.lengths = np.concatenate(([0.0], np.cumsum(pieces[order])))
        self.steady = len(kept) == 1 and np.ptp(speeds) <= STEADY * speeds.max()

    def measure(self, start, end):
        """The arc length between pairs of parameters with no joint between them: two (n,) to (n,)."""
        return (end - start) / 2 * (self.met(start, end) @ WEIGHTS)

    def met(self, start, end):
        """The speeds that quadrature meets between pairs of parameters: two (n,) to (n, 5)."""
        u = (start + end)[:, None] / 2 + (end - start)[:, None] / 2 * NODES
        return self.trajectory.speeds(u.ravel()).reshape(u.shape)

    def at(self, u):
        """Arc lengths at parameters: (n,) to (n,)."""
        if self.steady:
            return np.interp(u, self.nodes[[0, -1]], self.lengths[[0, -1]])
        panel = np.clip(np.searchsorted(self.nodes, u, side="right") - 1, 0, len(self.nodes) - 2)
        return self.lengths[panel] + self.measure(self.nodes[panel], u)

    def parameter(self, s):
        """Parameters at arc lengths: (n,) to (n,).

        Of many in one panel they are the values of a polynomial, where there is one that is exact to rounding.
        """
        s = np.asarray(s, dtype=float)
        if self.steady:
            return np.interp(s, self.lengths[[0, -1]], self.nodes[[0, -1]])
        panel = np.clip(np.searchsorted(self.lengths, s, side="right") - 1, 0, len(self.nodes) - 2)
        if len(s) < MANY * TERMS * (len(self.nodes) - 1):
            return self.searched(s, panel)
        terms, exact = self.way_back
        low, span = self.lengths[panel], self.lengths[panel + 1] - self.lengths[panel]
        x = np.clip(2 * (s - low) / np.where(span, span, 1.0) - 1, -1.0, 1.0)
        start, end = self.nodes[panel], self.nodes[panel + 1]
        u = np.where(s > low, summed(terms[:, panel], x).clip(start, end), start)
        others = np.flatnonzero(~exact[panel])
        u[others] = self.searched(s[others], panel[others])
        return u

    @cached_property
    def way_back(self):
        """The parameters of each panel as a sum of Chebyshev polynomials of its arc lengths.

        Returns
        -------
        terms : (TERMS, k) float array
        exact : (k,) bool array
            Whether the last two are no more than rounding; the next are a hundredth of them.
        """
        span, width = np.diff(self.lengths), np.diff(self.nodes)
        s = self.lengths[:-1] + span * (1 + np.cos(angles(TERMS)))[:, None] / 2
        u = self.searched(s.ravel(), np.tile(np.arange(len(span)), TERMS)).reshape(TERMS, -1)
        terms = fitting(TERMS) @ u
        missed = np.abs(terms[-2:]).sum(axis=0) * span / width
        return terms, missed <= EXACT * self.total

    def searched(self, s, panel):
        """Parameters at arc lengths in panels, by Newton's method, and bisection where that leaves the panel.

        It begins with the cubic through the ends of each panel.
        """
        low, high = self.nodes[panel], self.nodes[panel + 1]
        start, reached = low.copy(), self.lengths[panel]
        span = self.lengths[panel + 1] - reached
        part = (s - reached) / np.where(span, span, 1.0)
        mean = span / (high - low)
        speeds = self.trajectory.speeds(low), self.trajectory.speeds(high, before=True)
        first, last = (rising(mean / np.where(speed, speed, np.inf)) for speed in speeds)
        u = low + (high - low) * part * (part * (3 - 2 * part) + (1 - part) * (first * (1 - part) - last * part))
        todo = np.arange(len(s))
        for step in range(MOST_STEPS):
            beyond = reached[todo] + self.measure(start[todo], u[todo]) - s[todo]
            missed = np.abs(beyond) > (EXACT if step < FEW_STEPS else CONVERGED) * self.total
            if not missed.any():
                break
            todo, beyond = todo[missed], beyond[missed]
            before = u[todo]
            low[todo] = np.where(beyond < 0, before, low[todo])
            high[todo] = np.where(beyond > 0, before, high[todo])
            speed = self.trajectory.speeds(before)
            after = before - beyond / np.where(speed, speed, np.inf)
            inside = (low[todo] < after) & (after < high[todo])
            u[todo] = np.where(inside, after, (low[todo] + high[todo]) / 2)
        return u

    def entered(self, u):
        """Parameters where the trajectory came to where it is at u: lower ones where it has stood still, (n,)."""
        moved = np.concatenate(([True], np.diff(self.lengths) > 0))
        if moved.all():
            return u
        came = np.maximum.accumulate(np.where(moved, np.arange(len(moved)), 0))
        node = np.searchsorted(self.nodes, u).clip(0, len(self.nodes) - 1)
        return np.where(self.nodes[node] == u, self.nodes[came[node]], u)


def rising(slopes):
    """Slopes at an end of a cubic from 0 to 1, and 1 where it might not rise everywhere, as beside a cusp."""
    return np.where((slopes > 0) & (slopes < 3), slopes, 1.0)


def subdivided(nodes, parts):
    """Each interval between nodes cut into equal parts."""
    steps = np.arange(parts) / parts
    inner = nodes[:-1, None] + np.diff(nodes)[:, None] * steps
    return np.append(inner.ravel(), nodes[-1])


@lru_cache(maxsize=32)
def arc_length(trajectory):
    """The arc length of a trajectory, computed once per value."""
    return ArcLength(trajectory)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The local test of a shape whose contours stand across a trajectory: its folds at any arc length, to rounding."""

import numpy as np

from ..stations import sampling
from ..stations.cells import bend
from ..stations.search import highest
from ..trajectories.arc_length import arc_length
from ..vectors import norms
from .folds import folding, in_order, intervals, safe_factor, sentence
from .places import Place

NEAR = 0.7  # of the radius of curvature: no contour that reaches less may reach it between two places
LOWEST = 8  # places where the factor at which a contour folds is looked at closely


class Local:
    """The folds of a shape.

    Parameters
    ----------
    stations : Stations
        Of its mesh: the test looks at these, and at the trajectory's own nodes.
    carried : callable
        From any stations, the first of all among them, to what `folding` asks: four (n, 3).
    support : callable
        Of the contour.
    farthest : float
        How far a contour gets from the trajectory, in metres.
    """

    def __init__(self, stations, carried, support, farthest):
        self.trajectory, self.measure = stations.trajectory, arc_length(stations.trajectory)
        self.stations, self.carried, self.support, self.farthest = stations, carried, support, farthest
        grid = np.unique(np.concatenate((stations.s, self.measure.lengths)))
        self.grid = grid[np.append(True, np.diff(grid) > 1e-12 * self.measure.total)]

    @property
    def curved(self):
        """Whether a contour comes anywhere near a centre of curvature."""
        u = np.concatenate((self.stations.u, self.measure.nodes))
        return norms(bend(self.trajectory, u)).max() * self.farthest > NEAR

    def at(self, s):
        """What `folding` asks, at rising arc lengths: four (n, 3)."""
        first = int(s[0] > 0)  # frames are measured from that at the start
        s = np.concatenate((np.zeros(first), s))
        again = int(self.trajectory.closed and s[-1] >= self.measure.total)
        parts = self.carried(sampling.stations(self.trajectory, s[:-1] if again else s))
        return tuple(np.concatenate((part[first:], part[:again])) for part in parts)

    def folds(self):
        """From which parameters to which the sweep folds: a list of pairs, over a closed start from the larger one."""
        if not self.curved:
            return []
        found = intervals(self.folding, self.grid)
        ends = self.measure.parameter(found.ravel()).reshape(-1, 2).tolist()
        if self.trajectory.closed and len(ends) > 1 and found[0, 0] == 0 and found[-1, 1] == self.grid[-1]:
            ends[0][0] = ends.pop()[0]
        return [tuple(pair) for pair in ends]

    def place(self, ends):
        """The place of a fold."""
        a, b = ends
        middle = self.measure.at(np.array([a, b])).sum() / 2
        if a > b:
            middle = (middle + self.measure.total / 2) % self.measure.total
        point = self.trajectory.evaluate(self.measure.parameter(np.array([middle])))[0]
        return folded(a, b, point, self.trajectory.domain)

    def folding(self, s):
        """How far the contours fold at rising arc lengths: (n,), not negative where they do."""
        return folding(*self.at(s), self.support)

    def safe_factors(self, s):
        """By what factor each contour may be scaled before it folds: (n,)."""
        return safe_factor(*self.at(s), self.support)

    def factor(self):
        """By what factor all contours may be scaled until one of them folds."""
        if self.trajectory.straight:
            return np.inf
        return self.least_factor()

    def least_factor(self):
        """The least of these factors, at any arc length."""

        def factors(s):
            return -self.safe_factors(s)

        values = factors(self.grid)
        top = np.argsort(-values, kind="stable")[:LOWEST]
        low, high = (self.grid[(top + step).clip(0, len(self.grid) - 1)] for step in (-1, 1))
        return -float(max(values.max(), highest(in_order(factors), low, high)[1].max()))


def folded(a, b, point, domain):
    """The place of a fold from one parameter of a domain to another, at a point (3,)."""
    return Place("local", ((float(a), float(b)),), tuple(point.tolist()), sentence(a, b, domain))

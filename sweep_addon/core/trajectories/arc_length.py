# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arc length: how far along a trajectory each parameter is, and the way back."""

from functools import lru_cache

import numpy as np

from ..parameters import require

NODES, WEIGHTS = np.polynomial.legendre.leggauss(5)
CONVERGED = 1e-12  # of the whole length: the change of all panels when they are halved
SHORTEST = 1e-12  # metres
MOST_STEPS = 60  # of Newton's method: many only where the speed vanishes, and each of them nears by a third
MOST_PANELS = 1 << 15  # a curve that has not converged by then has a cusp, which more panels do not mend


class ArcLength:
    """The arc length s(u) of a trajectory by Gauss-Legendre quadrature, and its inverse u(s).

    Attributes
    ----------
    nodes, lengths : (k,) float array
        Parameters between which quadrature is exact to rounding, and the arc length at each.
    total : float
        The length of the whole trajectory in metres.
    """

    def __init__(self, trajectory):
        self.trajectory = trajectory
        joints = trajectory.joints()
        panels = max(4, -(-128 // (len(joints) - 1)))
        nodes = subdivided(joints, panels)
        pieces = self.measure(nodes[:-1], nodes[1:])
        while len(nodes) <= MOST_PANELS:
            coarse, nodes = pieces, subdivided(nodes, 2)
            pieces = self.measure(nodes[:-1], nodes[1:])
            # panel by panel: the errors of a closed curve's panels cancel in the sum long before they are small
            if np.abs(pieces[::2] + pieces[1::2] - coarse).sum() <= CONVERGED * pieces.sum():
                break
        self.nodes, self.lengths = nodes, np.concatenate(([0.0], np.cumsum(pieces)))
        self.total = float(self.lengths[-1])
        require(self.total >= SHORTEST, f"must be at least {SHORTEST:g} m long", self.total)

    def measure(self, start, end):
        """The arc length between pairs of parameters with no joint between them: two (n,) to (n,)."""
        half = (end - start) / 2
        u = (start + end)[:, None] / 2 + half[:, None] * NODES
        speed = np.linalg.norm(self.trajectory.derivative(u.ravel()), axis=1).reshape(u.shape)
        return half * (speed @ WEIGHTS)

    def at(self, u):
        """Arc lengths at parameters: (n,) to (n,)."""
        panel = np.clip(np.searchsorted(self.nodes, u, side="right") - 1, 0, len(self.nodes) - 2)
        return self.lengths[panel] + self.measure(self.nodes[panel], u)

    def parameter(self, s):
        """Parameters at arc lengths: (n,) to (n,), by Newton's method from a linear guess."""
        panel = np.clip(np.searchsorted(self.lengths, s, side="right") - 1, 0, len(self.nodes) - 2)
        low, high = self.nodes[panel], self.nodes[panel + 1]
        span = self.lengths[panel + 1] - self.lengths[panel]
        u = low + (high - low) * (s - self.lengths[panel]) / np.where(span, span, 1.0)
        for _ in range(MOST_STEPS):
            beyond = self.lengths[panel] + self.measure(low, u) - s
            if np.abs(beyond).max(initial=0.0) <= 1e-14 * self.total:
                break
            speed = np.linalg.norm(self.trajectory.derivative(u), axis=1)
            u = np.clip(u - beyond / np.where(speed, speed, np.inf), low, high)
        return u

    def entered(self, u):
        """Parameters where the trajectory came to where it is at u: lower ones where it has stood still, (n,)."""
        moved = np.concatenate(([True], np.diff(self.lengths) > CONVERGED * self.total))
        if moved.all():
            return u
        came = np.maximum.accumulate(np.where(moved, np.arange(len(moved)), 0))
        node = np.searchsorted(self.nodes, u).clip(0, len(self.nodes) - 1)
        return np.where(self.nodes[node] == u, self.nodes[came[node]], u)


def subdivided(nodes, parts):
    """Each interval between nodes cut into equal parts."""
    steps = np.arange(parts) / parts
    inner = nodes[:-1, None] + np.diff(nodes)[:, None] * steps
    return np.append(inner.ravel(), nodes[-1])


@lru_cache(maxsize=32)
def arc_length(trajectory):
    """The arc length of a trajectory, computed once per value."""
    return ArcLength(trajectory)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Transport: the normal that a whole trajectory carries along without spin, exact at every parameter.

In a panel, a short piece of the trajectory, an axis a that the tangent t never meets gives a smooth normal, t x a. The
normal without spin turns against it by the integral of one scalar,

    phi' = -(t . a) (a . (t x t')) / (1 - (t . a)^2),

the integral of a polynomial through Chebyshev's nodes. So nothing depends on where the contours stand. From panel to
panel, and so round a corner, it takes the least rotation from one tangent to the next. All turns are about the tangent:
they add up.
"""

from functools import lru_cache

import numpy as np

from ..trajectories.arc_length import arc_length, subdivided
from ..vectors import cross, dot, norms, unit
from .chebyshev import angles, counted, summed
from .rotations import any_normal, rotated, signed_angle, turned

ORDER = 13  # nodes in a panel; odd, so that one is in the middle
ANGLES = angles(ORDER)
NODES = np.cos(ANGLES)
EXACT = 1e-14  # radians: the last two terms of a panel's integral; the next are a hundredth of them
STRAIGHT = 1e-6  # radians in half a panel
NEAR = 0.5  # at least: the cosine between the tangents at nodes that are neighbours
ACROSS = 0.7  # at most: the cosine between a tangent and the axis
PANELS, MOST_PANELS = 32, 1 << 18
MOST_HALVINGS = 24  # more only where the speed vanishes and rounding is all there is


class Transport:
    """The rotation-minimizing normal along a trajectory.

    Attributes
    ----------
    holonomy : float
        The angle in radians by which a closed trajectory brings the normal back turned; 0 for an open one.

    Source
    ------
    Bishop: There is more than one way to frame a curve, Amer. Math. Monthly 82, 1975: a normal without spin turns
    against any other by the integral of that one's spin.
    """

    def __init__(self, trajectory):
        self.start, self.end, self.axis, self.turning = panels(trajectory)
        turn = self.met(trajectory) if trajectory.closed or len(self.start) > 1 else np.zeros(1)
        self.turning = counted(self.turning, EXACT)
        self.before = np.concatenate(([0.0], np.cumsum(turn[:-1])))
        self.holonomy = float(turn.sum()) if trajectory.closed else 0.0

    def met(self, trajectory):
        """The angles from the first normal of each next panel to the one that is carried there, (k,)."""
        leave, arrive = trajectory.tangents(self.start), trajectory.tangents(self.end, before=True)
        carried = rotated(unit(cross(arrive, self.axis)), arrive, self.turning.sum(axis=0))  # every T(1) is 1
        onward = np.roll(np.arange(len(leave)), -1)
        carried = turned(carried, arrive, leave[onward])
        return signed_angle(unit(cross(leave, self.axis))[onward], carried, leave[onward])

    def at(self, u, tangents):
        """A normal across each tangent at parameters u, (n, 3), and the angle from it to that without spin, (n,)."""
        panel = np.zeros(1, int)  # of which all arrays are made as long as those of u
        if len(self.start) > 1:
            panel = np.clip(np.searchsorted(self.start, u, side="right") - 1, 0, len(self.start) - 1)
        start, end = self.start[panel], self.end[panel]
        x = np.clip((2 * u - start - end) / (end - start), -1.0, 1.0)
        return unit(cross(tangents, self.axis[panel])), self.before[panel] + summed(self.turning[:, panel], x)


class EvenTransport:
    """The same along a trajectory whose tangents turn evenly about one axis: phi' is -(t . a) for each radian."""

    holonomy = 0.0  # one that closes lies across its axis

    def __init__(self, trajectory):
        self.axis = np.array([trajectory.axis])

    def at(self, u, tangents):
        """As `Transport.at`."""
        across = cross(tangents, self.axis)
        return across / norms(across[:1]), -dot(tangents[:1], self.axis) * u


def panels(trajectory):
    """Pieces short enough for a polynomial: their ends (k,) and (k,), axes (k, 3), and coefficients (ORDER + 1, k)."""
    joints = trajectory.joints()
    moving = np.diff(arc_length(trajectory).at(joints)) > 0
    nodes = subdivided(joints, 1 if trajectory.straight else -(-PANELS // len(moving)))
    start, end = (part.reshape(len(moving), -1)[moving].ravel() for part in (nodes[:-1], nodes[1:]))
    allowed = EXACT * max(1.0, len(start) / PANELS)  # as much as rounding adds up to
    kept, total = [], 0
    for halvings in range(MOST_HALVINGS + 1):
        axis, turning, near = integrals(trajectory, start, end)
        total += len(start)
        exact = near & (np.abs(turning[-2:]).sum(axis=0) <= allowed)
        exact |= halvings == MOST_HALVINGS or total > MOST_PANELS
        kept.append((start[exact], end[exact], axis[exact], turning[:, exact].T))
        if exact.all():
            break
        middle = (start + end)[~exact] / 2
        start, end = np.append(start[~exact], middle), np.append(middle, end[~exact])
    start, end, axis, turning = (np.concatenate(parts) for parts in zip(*kept, strict=True))
    order = np.argsort(start)
    return start[order], end[order], axis[order], turning[order].T


def integrals(trajectory, start, end):
    """The axes of panels, (k, 3), the integrals of phi', and whether no tangent is far from the next, (k,) bool."""
    half = (end - start) / 2
    if trajectory.straight:
        axis = any_normal(trajectory.tangents(start + half))
        return axis, np.zeros((ORDER + 1, len(half))), np.full(len(half), True)
    u = ((start + end) / 2 + half * NODES[:, None]).ravel()
    first, second = trajectory.first_two(u)
    tangent = unit(first)
    squared = dot(first, first)
    turn = cross(first, second) / np.where(squared > 0, squared, np.inf)[:, None]
    tangent, turn = (part.reshape(ORDER, -1, 3) for part in (tangent, turn))
    middle, binormal = tangent[ORDER // 2], turn[ORDER // 2]  # a plane bend does not turn against its binormal
    bent = np.linalg.norm(binormal, axis=1) * half > STRAIGHT
    axis = np.where(bent[:, None], unit(binormal), any_normal(middle))
    along = np.einsum("mij,ij->mi", tangent, axis)
    rate = -along * np.einsum("mij,ij->mi", turn, axis) / np.maximum(1 - along**2, 1e-300)
    turning = INTEGRAL @ (rate * half)
    near = (np.einsum("mij,mij->mi", tangent[1:], tangent[:-1]) >= NEAR).all(axis=0)
    return axis, turning, near & (np.abs(along) <= ACROSS).all(axis=0)


def integral():
    """From values at the nodes to the coefficients of Chebyshev polynomials of their integral from -1: a matrix."""
    series = 2 / ORDER * np.cos(np.arange(ORDER + 2)[:, None] * ANGLES)
    series[ORDER:] = 0.0
    degree = np.arange(1, ORDER + 1)
    rising = (series[:-2] - series[2:]) / (2 * degree[:, None])  # the first of a series counts half
    return np.vstack((-((-1.0) ** degree) @ rising, rising))


INTEGRAL = integral()


@lru_cache(maxsize=32)
def transport(trajectory):
    """The normal along a trajectory, computed once per value."""
    return EvenTransport(trajectory) if trajectory.axis else Transport(trajectory)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sampling: where along a trajectory the contour is placed, and what the trajectory is like there."""

from dataclasses import replace
from functools import cached_property, lru_cache

import numpy as np

from ..declared.frozen import individual
from ..declared.parameters import Array, ShapeError, count, declared, length, parameter, require
from ..later import later
from ..trajectories.curve import SAME_DIRECTION, SHARPEST
from ..vectors import differing, dot, norms, unit, zeros

distinct, fewest = later("core.stations.spreading", "distinct", "fewest")
spread, spread_evenly = later("core.stations.spreading", "spread", "spread_evenly")
bend = later("core.stations.cells", "bend")
arc_length = later("core.trajectories.arc_length", "arc_length")

__all__ = ["Count", "Sampling", "Tolerance"]

MOST_STATIONS = 200_000
FINEST = 1e-9  # metres
SHORTEST_STEP = 1e-9  # of the length: corners and marks closer than this are one


@declared
class Tolerance:
    """As few contours as keep chords within a distance of the trajectory

    >>> from sweep_addon.core.trajectories import Helix, Line
    >>> [len(place(trajectory, Tolerance(0.01)).s) > 2 for trajectory in (Line(), Helix())]
    [False, True]
    """

    chord: float = length(0.001, "Largest distance of a chord from the trajectory", minimum=FINEST, soft_maximum=0.1)
    render: float = parameter(
        0.0, "Largest distance of a chord in a render; 0: the same", unit="length", minimum=0.0, soft_maximum=0.1
    )

    def check(self):
        """Refuse a render with a distance that is neither 0 nor at least a nanometre."""
        require(self.render == 0 or self.render >= FINEST, f"must be 0 or at least {FINEST:g}", self.render, "render")

    def rendered(self):
        """The sampling that a render uses."""
        return Tolerance(self.render or self.chord)


@declared
class Count:
    """A number of contours, evenly spaced by arc length; corners are always among them

    >>> from sweep_addon.core.trajectories import Line
    >>> place(Line(end=(0, 0, 3)), Count(4)).s.round(12).tolist()
    [0.0, 1.0, 2.0, 3.0]
    """

    contours: int = count(64, "Contours along the trajectory", minimum=2, maximum=MOST_STATIONS, soft_maximum=1000)
    render: int = count(0, "Contours in a render; 0: the same", minimum=0, maximum=MOST_STATIONS, soft_maximum=1000)

    def check(self):
        """Refuse a render with one contour."""
        require(self.render != 1, "must be 0 or at least 2", self.render, "render")

    def rendered(self):
        """The sampling that a render uses."""
        return Count(self.render or self.contours)


Sampling = Tolerance | Count


def __dir__():
    return __all__  # what a console offers


def rendered(shape):
    """A shape as a render samples it; the shape itself where that is the same.

    >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
    >>> rendered(GeneralizedCylinder(samples=Count(8, render=100))).samples
    Count(contours=100, render=0)
    """
    samples = getattr(shape, "samples", None)
    return replace(shape, samples=samples.rendered()) if samples is not None and samples.render else shape


@individual
class Stations:
    """The places along a trajectory where the contour stands.

    Parameters
    ----------
    trajectory : Trajectory
    u, s : (n,) float array
        The trajectory's own parameter and the arc length in metres.
    points : (n, 3) float array
        The trajectory there; a closed one does not repeat its first point.
    arrive, leave : (n, 3) float array
        Unit tangents before and after each place; they differ at corners.
    bend : (n, 3) float array
        The curvature vector in 1/m, towards the centre of curvature, a corner's turn spread over its step.
    going_on : (k, 3) float array
        The curvature vector with which the trajectory leaves each corner, in 1/m.
    corners : (k,) int array
        The stations where the tangent turns at once.
    total : float
        The length of the whole trajectory in metres.
    """

    trajectory: object
    u: np.ndarray
    s: np.ndarray
    points: np.ndarray
    arrive: np.ndarray
    leave: np.ndarray
    bend: np.ndarray
    going_on: np.ndarray
    corners: np.ndarray
    total: float

    @property
    def closed(self):
        """Whether the last place leads to the first."""
        return bool(self.trajectory.closed)

    @property
    def t(self):
        """From 0 at the start to 1 at the end, by arc length: (n,)."""
        return self.s / self.total

    @cached_property
    def tangent(self):
        """The unit tangent e1: at a corner the bisector, in whose plane the contour is mitred."""
        if not len(self.corners):
            return self.leave
        tangent = self.leave.copy("K")
        tangent[self.corners] = unit(self.arrive[self.corners] + self.leave[self.corners])
        return tangent

    @cached_property
    def onward(self):
        """Index of the station each step leads to: (n - 1,), or (n,) for a closed trajectory."""
        following = np.arange(1, len(self.u) + 1)
        return np.append(following[:-1], 0) if self.closed else following[:-1]

    @property
    def starts(self):
        """The stations that steps start from, as a slice."""
        return slice(len(self.onward))

    @cached_property
    def lengths(self):
        """The arc length of each step: (n - 1,), or (n,) for a closed trajectory."""
        return np.diff(np.append(self.s, self.total) if self.closed else self.s)

    def ended(self, values):
        """Values (n, ...) at the stations, as they are at the end of each step."""
        return np.roll(values, -1, axis=0) if self.closed else values[1:]

    def steps(self, values):
        """By how much values (n, ...) at the stations change in each step."""
        return self.ended(values) - values[self.starts]


def place(trajectory, sampling, marks=(), extra=None, way=None):
    """Choose the stations of a sweep: they stand at `lengths`, which takes the same.

    Parameters
    ----------
    trajectory : Trajectory
    sampling : Tolerance or Count
    marks : sequence of float
        Arc lengths in metres where there must be a station whatever the sampling says.
    extra : callable, optional
        From arc lengths (k,), parameters (k,) and a tolerance to steps per metre (k,): what a twist or a change of
        scale asks for beyond the bends of the trajectory.
    way : (2, n) float array, optional
        Rising arc lengths, and by what measure a number of stations is evenly spaced; by default by arc length.

    Returns
    -------
    Stations
    """
    return standing(trajectory, Array(lengths(trajectory, sampling, marks, extra, way)))


def lengths(trajectory, sampling, marks=(), extra=None, way=None):
    """The arc lengths in metres where `place` puts stations: (n,) rising; a closed trajectory's end is not among them.

    >>> from sweep_addon.core.trajectories import Line
    >>> lengths(Line(end=(0, 0, 3)), Count(3)).round(12).tolist()
    [0.0, 1.5, 3.0]
    """
    measure = arc_length(trajectory)
    ends = measure.at(np.concatenate((trajectory.stops(), trajectory.domain)))
    ends = distinct(np.concatenate((ends, marks)).clip(0.0, measure.total), SHORTEST_STEP * measure.total)
    ends[-1] = measure.total
    if isinstance(sampling, Count):
        s = spread_evenly(ends, max(sampling.contours - (not trajectory.closed), fewest(trajectory)), way)
    else:
        s = spread(trajectory, ends, sampling.chord, extra)
    return s[:-1] if trajectory.closed else s


@lru_cache(maxsize=16)
def standing(trajectory, s):
    """The stations at arc lengths, made once for equal ones: most laws change without moving any."""
    return stations(trajectory, s.values)


def stations(trajectory, s):
    """What the trajectory is like at arc lengths s."""
    measure, joints = arc_length(trajectory), trajectory.joints()
    u = measure.parameter(s)
    if trajectory.axis and not trajectory.closed:  # all joints are its ends
        points, first, second = trajectory.moving(u)
        leave, bends = trajectory.tangents(u, first=first), bend(trajectory, u, False, first, second)
        return Stations(trajectory, u, s, points, leave, leave, bends, bends[:0], np.zeros(0, int), measure.total)
    u = snapped(u, joints)
    points, first, second = trajectory.moving(u)
    leave = trajectory.tangents(u, first=first)
    arrive, reached = leave.copy("K"), np.append(trajectory.domain[1], u[1:]) if trajectory.closed else u
    entered, joint = measure.entered(reached), within(u, joints, joints)
    if entered is not reached:  # somewhere it has stood still
        joint = np.union1d(joint, np.flatnonzero(entered != reached))
    arrive[joint] = trajectory.tangents(entered[joint], before=True)
    if not trajectory.closed:
        arrive[0], leave[-1] = leave[0], arrive[-1]
    both = () if trajectory.pace else ((leave, arrive), (arrive, leave))
    for lost, other in both:  # a direction is lost where rounding outweighs the speed
        gone = zeros(lost)
        lost[gone] = other[gone]
    bends = bend(trajectory, u, False, first, second)
    unlike = joint[differing(arrive[joint], leave[joint])]
    turn = leave[unlike] - arrive[unlike]
    back = dot(arrive[unlike], leave[unlike]) < SHARPEST
    if back.any():
        first = u[unlike[np.argmax(back)]]
        raise ShapeError(f"must not turn back on itself, got a reversal at u = {first:.6g}", "trajectory")
    seen = norms(turn) > SAME_DIRECTION
    corner = unlike[seen]
    # a corner bends by its turn within a step: one by a rounding of the points does not outweigh the curvature
    going_on = bends[corner]
    if len(corner):
        bends[corner] += turn[seen] / np.gradient(s)[corner, None]
    arrive[unlike[~seen]] = leave[unlike[~seen]]
    return Stations(trajectory, u, s, points, arrive, leave, bends, going_on, corner, measure.total)


def snapped(u, joints):
    """Parameters that rounding put beside a joint, put on it: a corner has a tangent on either side."""
    least = 1e-9 * (joints[-1] - joints[0])
    beside = within(u, joints - least, joints + least)
    found, snapped = u[beside], u.copy()
    after = np.searchsorted(joints, found).clip(1, len(joints) - 1)
    near, far = joints[after - 1], joints[after]
    snapped[beside] = np.where(np.abs(found - near) < np.abs(found - far), near, far)
    return snapped


def within(rising, low, high):
    """Which of rising values lie in intervals, whose ends count and are few beside them: (k,) indices.

    >>> within(np.array([0.0, 1.0, 2.0, 3.0]), np.array([0.0, 1.5]), np.array([0.0, 3.0])).tolist()
    [0, 2, 3]
    """
    first, after = np.searchsorted(rising, low), np.searchsorted(rising, high, "right")
    counts = after - first
    return np.repeat(first - np.cumsum(counts) + counts, counts) + np.arange(counts.sum())

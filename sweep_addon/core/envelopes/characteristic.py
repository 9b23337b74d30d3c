# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Characteristic circles: where each ball on a trajectory touches the envelope of all of them.

The ball at t of radius r touches it in the circle about t - r sin(lean) T, of radius r cos(lean), across the tangent T.
Where tangent or lean change at once, as at a corner or a kink of the radius, the circles turn from one to the other on
the same ball, and so they do on the first and on the last one, from pole to pole: a round end.
"""

import numpy as np

from ..declared.frozen import individual
from ..declared.parameters import require
from ..stations.cells import WIDEST_TURN, chord_angle
from ..stations.sampling import MOST_STATIONS, Tolerance
from ..vectors import dot, norms, unit
from .balls import SAME, UPRIGHT

NEAR = 1e-9  # of the trajectory's length: a circle so near to where they end is a point there


@individual
class Circles:
    """Characteristic circles, one after the other along a trajectory.

    Parameters
    ----------
    station : (k,) int array
        The station whose ball each is on.
    u, s : (k,) float array
        The trajectory's parameter and arc length there.
    place, axis : (k, 3) float array
        The middle of the ball, and the unit normal of the circle's plane.
    radius, lean : (k,) float array
        Of the ball, in metres; and how far the circle leans back on it, in radians.
    """

    station: np.ndarray
    u: np.ndarray
    s: np.ndarray
    place: np.ndarray
    axis: np.ndarray
    radius: np.ndarray
    lean: np.ndarray

    @property
    def centres(self):
        """The middles of the circles: (k, 3)."""
        return self.place - (self.radius * np.sin(self.lean))[:, None] * self.axis

    @property
    def sizes(self):
        """The radii of the circles, exactly 0 where one is a point: (k,)."""
        return np.where(np.abs(self.lean) == UPRIGHT, 0.0, self.radius * np.cos(self.lean))

    @property
    def turning_back(self):
        """Parameters where circles turn back on one ball: at corners, and where the radius begins to grow at once."""
        same = self.station[1:] == self.station[:-1]
        back = same & ((np.diff(self.lean) > SAME) | (norms(np.diff(self.axis, axis=0)) > SAME))
        return np.unique(self.u[1:][back]).tolist()

    def way(self, closed, total):
        """How far it is along the surface to each circle, (k,), and on a closed one round to the first.

        On the surface the way is the mean of all round; where the circles stand still it is that on the ball.
        """
        ahead = np.append(np.arange(1, len(self.s)), 0)[: len(self.s) - (not closed)]
        step = np.diff(np.append(self.s, total) if closed else self.s)
        half = np.cos((self.lean[ahead] + self.lean[: len(ahead)]) / 2)
        mean = (self.radius[ahead] + self.radius[: len(ahead)]) / 2
        onward = np.abs(half * step - mean * (self.lean[ahead] - self.lean[: len(ahead)]))
        aside = norms(self.axis[ahead] - self.axis[: len(ahead)]) * (2 / np.pi) * mean * half
        way = np.concatenate(([0.0], np.cumsum(np.where(step > 0, onward, np.hypot(onward, aside)))))
        return (way[:-1], float(way[-1])) if closed else (way, float(way[-1]))

    def some(self, which):
        """Those that indices or bools choose."""
        return Circles(*(getattr(self, name)[which] for name in self.__dataclass_fields__))


def circles(stations, balls, round_ends, samples, points, apart=False):
    """The characteristic circles of a canal surface.

    Parameters
    ----------
    stations : Stations
    balls : Balls
    round_ends : tuple of two bool
        Whether the circles go on to the pole of the first and of the last ball.
    samples : Sampling
        How far on one ball it is from circle to circle.
    points : int
        Round each circle.
    apart : bool
        Whether circles that would turn back on a ball go on to its pole instead, and begin again at its other one.

    Returns
    -------
    Circles
    """
    arrive, leave, bend = leans(stations, balls)
    if not stations.closed:
        arrive[0] = UPRIGHT if round_ends[0] else leave[0]
        leave[-1] = -UPRIGHT if round_ends[1] else arrive[-1]
    radius = balls.radius(stations.u, stations.s)
    station, part, lean = np.arange(len(leave)), np.zeros(len(leave)), np.stack((arrive, leave))
    if apart:
        split = ((leave - arrive > SAME) | (bend > 0)) & (radius > 0)
        station, again = np.repeat(station, 1 + split), np.repeat(split, 1 + split)
        first = np.append(True, np.diff(station) > 0)
        lean = lean[:, station]
        lean[1, again & first], lean[0, again & ~first] = -UPRIGHT, UPRIGHT
        bend, part = np.where(split, 0.0, bend), np.where(again & first, -1.0, part[station])
    radius = radius[station]
    turn = np.maximum(bend[station], np.abs(lean[1] - lean[0]))
    steps = np.ceil(turn / widest(samples, radius, points) - 1e-9)
    steps = np.where((turn > SAME) & (radius > 0), steps, 0).astype(int)
    fine = isinstance(samples, Tolerance)
    most = f"must be {'larger' if fine else 'fewer'}: balls take {steps.sum():,} circles of {MOST_STATIONS:,} at most"
    key, got = ("samples.chord", samples.chord) if fine else ("points", points)
    require(steps.sum() <= MOST_STATIONS, most, got, key)
    turning = np.repeat(np.arange(len(station)), steps + 1)
    share = np.arange(len(turning)) - np.repeat(np.cumsum(steps + 1) - steps - 1, steps + 1)
    share = share / np.maximum(steps, 1)[turning]
    lean = np.where(share == 1, lean[1, turning], lean[0, turning] + share * (lean[1] - lean[0])[turning])
    station, arriving = station[turning], part[turning] < 0
    axis = axes_of(stations, station, share, bend)
    axis[arriving] = stations.arrive[station[arriving]]
    on_path = (values[station] for values in (stations.u, stations.s, stations.points))
    return Circles(station, *on_path, axis, radius[turning], lean)


def leans(stations, balls):
    """The lean before and after each station, and by how many radians the path turns there: three (n,)."""
    u, s = stations.u, stations.s
    leave = balls.lean(u, s)
    if stations.closed:
        u, s = (np.append(last, part[1:]) for last, part in ((balls.u[-1], u), (stations.total, s)))
    arrive = balls.lean(u, s, before=True)
    at_limit = near(stations, balls.measure.at(balls.limits))
    for lean in (arrive, leave):
        lean[at_limit] = np.copysign(UPRIGHT, lean[at_limit])
    bend = np.arccos(np.clip(dot(stations.arrive, stations.leave), -1.0, 1.0))
    bend[(stations.arrive == stations.leave).all(axis=1)] = 0.0
    return arrive, leave, bend


def near(stations, limits):
    """The stations that stand at arc lengths, but for rounding: (n,) bool."""
    found = np.full(len(stations.s), False)
    after = np.searchsorted(stations.s, limits).clip(1, len(found) - 1)
    for station in (after - 1, after):
        found[station] |= np.abs(stations.s[station] - limits) <= NEAR * stations.total
    return found


def widest(samples, radius, points):
    """The angle from circle to circle on balls, (n,): one of a thickness within the tolerance, or as round as they."""
    if isinstance(samples, Tolerance):
        return np.minimum(chord_angle(samples.chord, np.where(radius > 0, radius, 1.0)), WIDEST_TURN)
    return np.full(len(radius), min(max(2 * np.pi / points, np.pi / 2 / samples.contours), WIDEST_TURN))


def axes_of(stations, station, share, bend):
    """The axis of each circle: at a corner a part of the way from one tangent to the other."""
    axis = stations.leave[station]
    at = np.flatnonzero(bend[station] > 0)
    angle, part = bend[station][at], share[at]
    start, end = stations.arrive[station][at], stations.leave[station][at]
    aside = unit(end - dot(start, end)[:, None] * start)
    axis[at] = np.cos(part * angle)[:, None] * start + np.sin(part * angle)[:, None] * aside
    return axis

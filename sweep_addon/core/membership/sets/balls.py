# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The union of all balls that a trajectory carries, or of discs in its plane: a canal surface with round ends."""

from functools import cached_property

import numpy as np

from ...envelopes.balls import Balls
from ...stations.plane import normal_of
from ...vectors import dot, norms
from ..labels import ON, OUT
from ..motion.hash import Boxes
from ..motion.panels import PLACES, at_both, derivative, panels, powers, slopes
from ..motion.ways import PARTS, apart
from .bodies import told
from .least import Along

LOOKED = 65
CHUNK = 1 << 14
STEPS = 9
ROOM = 1.2  # for what is faster between the places


class BallsBody:
    """All points of all balls of a `CanalSurface` with round ends; of discs what their plane has of these, a sheet.

    A point is as deep as it is in the ball of which it is deepest: the least of ``|P - t(s)| - r(s)``.
    """

    overlaps = True

    def __init__(self, shape):
        self.is_sheet = shape.is_plane
        self.normal = normal_of(shape.trajectory) if shape.is_plane else None
        balls = Balls(shape.trajectory, shape.radius)
        measure = balls.measure

        def channels(s):
            u = measure.parameter(s)
            return np.column_stack((shape.trajectory.evaluate(u), balls.radius(u, s), *self.planes(balls, u, s)))

        joints = measure.at(np.concatenate((shape.trajectory.joints(), balls.kinks.ravel())))
        looked = channels(np.linspace(0.0, measure.total, LOOKED))
        sizes = np.append(np.full(3, np.abs(looked[:, :3]).max()), np.abs(looked[:, 3:]).max(axis=0))
        self.middle = looked[0, :3]
        self.panels = panels(channels, apart(joints, measure.total), PARTS, np.maximum(sizes, sizes.max() * 1e-3))
        low, high = self.panels.bounds
        radius = np.maximum(np.abs(low[:, 3]), np.abs(high[:, 3]))[:, None]
        self.low, self.high = low[:, :3] - radius, high[:, :3] + radius
        self.box = np.stack((self.low.min(axis=0), self.high.max(axis=0)))

    def planes(self, balls, u, s):
        """Further channels: none."""
        return ()

    def labels(self, points, tolerance):
        """IN, ON or OUT for points (n, 3): (n,) int8."""
        return self.in_plane(points, self.of_balls(points, tolerance), tolerance)

    def in_plane(self, points, labels, tolerance):
        """What is left of labels where discs move in a plane: it is on, as it has no inside."""
        if self.normal is None:
            return labels
        within = (np.abs(dot(points - self.middle, self.normal)) <= tolerance) & (labels != OUT)
        return np.where(within, ON, OUT).astype(np.int8)

    def of_balls(self, points, tolerance):
        """IN, ON or OUT of all balls."""
        boxes, labels = Boxes.of(self.low - tolerance, self.high + tolerance), np.empty(len(points), dtype=np.int8)
        for start in range(0, len(points), CHUNK):
            some = slice(start, start + CHUNK)
            labels[some] = told(self.near(points[some], boxes, tolerance), tolerance)
        return labels

    def near(self, points, boxes, tolerance):
        """How far points (n, 3) are from the nearest of the balls whose boxes they are in, negative inside."""
        found = np.full(len(points), np.inf)
        point, panel = boxes.pairs(boxes.cells(points))
        if not len(point):
            return found
        series, places = self.panels.series[panel], points[point]
        way = -series[:, :3]
        way[:, :, 0] += places
        depth = self.least(way, series[:, 3], self.gaps[panel] + tolerance)
        first = np.flatnonzero(np.append(True, np.diff(point) > 0))
        found[point[first]] = np.minimum.reduceat(depth, first)
        return found

    @cached_property
    def gaps(self):
        """By how much the depth can change between two places that are looked at, in each panel: (k,)."""
        return np.diff(PLACES).max() * self.speeds

    @cached_property
    def speeds(self):
        """By how much it can change in half of each panel: (k,)."""
        rates = np.einsum("kcj,ij->kic", self.panels.series, slopes(PLACES))
        return ROOM * (norms(rates[..., :3]) + np.abs(rates[..., 3])).max(axis=1)

    def distance(self, points):
        """How far points (n, 3) are from the balls, negative within, or a fair part of that: (n,)."""
        return self.along.least(points, lambda some: BallsLook(self, points[some]))

    @cached_property
    def along(self):
        """The chords of the way, and how far balls get from them."""
        way = self.panels.series[:, :3]
        start, end = at_both(way)
        bent = norms(way[..., 2:].swapaxes(1, 2)).sum(axis=1)
        radius = np.abs(self.panels.series[:, 3]).sum(axis=1)
        return Along(start, end - start, 2 * bent + radius, np.ones(len(way), dtype=bool))

    def least(self, way, radius, gaps):
        """The least of |way| - radius in each panel, both series: (n, 3, ORDER), (n, ORDER) to (n,).

        Some places are looked at, and where they leave the sign open Newton's method goes on from the best of them.
        """
        depth = depths(way, radius)
        best = depth.argmin(axis=1)
        least = depth[np.arange(len(best)), best]
        near = np.flatnonzero(np.abs(least) <= gaps)
        least[near] = self.refined(way[near], radius[near], best[near], least[near])
        return least

    def refined(self, way, radius, best, least):
        """The least near the best of the places, by Newton's method, halving where that leaves the neighbours."""
        x, low, high = (PLACES[np.clip(best + side, 0, len(PLACES) - 1)] for side in (0, -1, 1))
        rates = derivative(way), derivative(radius)
        bends = derivative(rates[0]), derivative(rates[1])
        for _ in range(STEPS):
            basis = powers(x)
            at, rate, bend = (np.einsum("ncj,nj->nc", part, basis) for part in (way, rates[0], bends[0]))
            r, r_rate, r_bend = (np.einsum("nj,nj->n", part, basis) for part in (radius, rates[1], bends[1]))
            far = np.maximum(np.sqrt(dot(at, at)), 1e-300)
            least = np.minimum(least, far - r)
            away = dot(at, rate) / far
            slope, bend = away - r_rate, (dot(rate, rate) + dot(at, bend) - away**2) / far - r_bend
            low, high = np.where(slope < 0, x, low), np.where(slope > 0, x, high)
            after = x - slope / np.where(bend > 0, bend, np.inf)
            x = np.where((bend > 0) & (after > low) & (after < high), after, (low + high) / 2)
        return least


class BallsLook:
    """Points and what may be nearest to them: what `Along.least` asks."""

    def __init__(self, body, points):
        self.body, self.points = body, points

    def middle(self, point, panel):
        """The distances in the middle of panels, and by how much they change in half of one: two (p,)."""
        at = self.body.panels.at(panel, np.zeros(len(panel)))
        return norms(self.points[point] - at[:, :3]) - at[:, 3], self.body.speeds[panel]

    def pairs(self, point, panel):
        """The same at all places."""
        series = self.body.panels.series[panel]
        way = -series[:, :3]
        way[:, :, 0] += self.points[point]
        return BallsPairs(self.body, way, series[:, 3], self.body.speeds[panel])


class BallsPairs:
    """Pairs of points and panels: the ways from the balls' middles, the radii, both series, and the speeds."""

    is_smooth = True

    def __init__(self, body, way, radius, gaps):
        self.body, self.way, self.radius, self.gaps = body, way, radius, gaps

    def kept(self, index):
        """Some of the pairs."""
        return BallsPairs(self.body, self.way[index], self.radius[index], self.gaps[index])

    def grid(self):
        """The distances from the balls at some places: (p, i)."""
        return depths(self.way, self.radius)

    def refined(self, place):
        """The least distances near a place each: (p,)."""
        return self.body.refined(self.way, self.radius, place, np.full(len(place), np.inf))


def depths(way, radius):
    """The lengths of ways less radii, both series, at some places: (n, 3, ORDER), (n, ORDER) to (n, i)."""
    basis = powers(PLACES).T
    return np.sqrt(((way @ basis) ** 2).sum(axis=1)) - radius @ basis

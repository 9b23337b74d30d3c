# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Regions of the plane within one smooth curve that has an equation: discs, ellipses and superellipses.

A region tells of points how far they are from its boundary at least, negative inside: ``depth(points)``, whose sign is
exact. ``exact(points)`` tells the distance, and in which direction it grows, and ``distance(x, y)`` the distance alone.
``support(direction)`` is how far the region gets in a direction, and where; ``box`` the least and the greatest x and y.
"""

from functools import cached_property

import numpy as np

from ...declared.frozen import individual
from ...vectors import dot, unit
from .one_by_one import reached

LEAST = 1e-300  # keeps quotients at a centre finite
LOOKED = 17  # places of a quarter of a curve where it is looked at, and as many evenly by how it turns
STEPS = 80  # of Newton's method within brackets that are halved where it leaves them
SMALL = 1e-6  # of the size: what is nearer to a curve has its normal
ANGLE = 1e-14  # radians: brackets of twice as much are not halved any more
CHUNK = 1 << 14  # points whose pairs with the places fit into a processor's cache


@individual
class Disc:
    """The points within a circle about the origin.

    >>> Disc(2.0).depth(np.array([(0.0, 1.0), (3.0, 4.0)])).tolist()
    [-1.0, 3.0]
    """

    radius: float

    @property
    def box(self):
        """The least and the greatest x and y: (2, 2) float array."""
        return np.array([[-self.radius] * 2, [self.radius] * 2])

    def depth(self, points):
        """How far points (n, 2) are from the circle, negative inside: (n,)."""
        return np.sqrt(points[:, 0] ** 2 + points[:, 1] ** 2) - self.radius

    def distance(self, x, y):
        """The same of places x (n,) and y (n,): (n,)."""
        return np.sqrt(x * x + y * y) - self.radius

    def exact(self, points):
        """The same, and unit vectors away from the boundary: (n,), (n, 2)."""
        return self.depth(points), unit(points)

    def support(self, direction):
        """How far it gets along a unit vector, and where: a float, (2,)."""
        return self.radius, self.radius * direction


@individual
class Superdisc:
    """The points within |x / a|^n + |y / b|^n = 1, n at least 1; an ellipse where it is 2.

    >>> Superdisc((2.0, 1.0), 2.0).depth(np.array([(2.0, 0.0), (0.0, 0.0)])).round(9).tolist()
    [0.0, -0.894427191]
    """

    half: tuple
    exponent: float

    @property
    def box(self):
        """The least and the greatest x and y: (2, 2) float array."""
        return np.array([-np.array(self.half), self.half])

    def depth(self, points):
        """How far points (n, 2) are from the curve, negative inside, or less: (n,)."""
        a, b = self.half
        return (self.levels(points)[0] - 1) * a * b / np.hypot(a, b)  # within it is a rhombus, and the level a norm

    def fair(self, x, y):
        """How far places x (n,) and y (n,) are from the curve, or a fair part of that, negative inside: (n,)."""
        level, slope = self.levels(np.stack((x, y), axis=1))
        return self.bounded(level, np.sqrt(slope[:, 0] ** 2 + slope[:, 1] ** 2))

    def bounded(self, level, steep, narrow=1.0):
        """A distance that is nowhere too large, where the level rises so steeply and all is stretched at least so much.

        The level is convex: outside the distance to first order is that from a tangent, and not too large. It grows by
        one in no less than the radius of a ball inside, on either side. Inside the sum of powers grows as steeply as
        here, and by how much its slope may change faster: n (n - 1) in a radius for each radius, or, where n is less
        than 2 and the slope bends without bound on the axes, n 2^(2 - n) times the power n - 1 of the radii.
        """
        n, ball = self.exponent, narrow * self.ball
        within = np.minimum(level, 1.0)
        missing, slope = 1 - within**n, n * within ** (n - 1) * steep
        if n >= 2:
            inside = reached(missing, slope, n * (n - 1) / ball**2)
        else:
            most = np.minimum(missing / np.maximum(slope * ball, LEAST), (missing / 2 ** (2 - n)) ** (1 / n))
            inside = missing / np.maximum(slope + 2 ** (2 - n) * most ** (n - 1) / ball, LEAST)
        first = (level - 1) / np.maximum(steep, LEAST)
        ball_away = np.abs(level - 1) * ball
        return np.where(level < 1, -np.maximum(inside, ball_away), np.maximum(first, ball_away))

    @cached_property
    def ball(self):
        """The radius of the largest disc inside."""
        small, ratio = min(self.half), min(self.half) / max(self.half)
        if self.exponent >= 2:
            return small
        power = 2 * self.exponent / (2 - self.exponent)
        return small * (1 + ratio**power) ** (-1 / power)

    def exact(self, points):
        """The distance from the curve, negative inside, and unit vectors away from it: (n,), (n, 2)."""
        far, feet = self.feet(points)
        outward = unit(self.levels(feet)[1])
        side = np.where(self.levels(points)[0] < 1, -1.0, 1.0)
        apart = np.flatnonzero(far > SMALL * min(self.half))  # whose way from the curve is not rounding
        outward[apart] = (side[apart] / far[apart])[:, None] * (points[apart] - feet[apart])
        return side * far, outward

    def levels(self, points):
        """By what factor the curve about the origin reaches points, and how that grows along x and y: (n,), (n, 2)."""
        scaled = np.abs(points) / self.half
        most = np.maximum(scaled.max(axis=1), LEAST)
        part = scaled / most[:, None]  # so that no power overflows
        sums = (part**self.exponent).sum(axis=1)
        level = most * sums ** (1 / self.exponent)
        slope = part ** (self.exponent - 1) * (np.maximum(sums, LEAST) ** (1 / self.exponent - 1))[:, None]
        return level, slope * np.sign(points) / self.half

    def support(self, direction):
        """How far it gets along a unit vector, and where: a float, (2,). It is the dual norm of the level."""
        half, power = np.array(self.half), self.exponent - 1
        scaled = np.abs(half * direction)
        if power == 0:  # a rhombus: one of its corners
            share = np.eye(2)[scaled.argmax()]
        else:
            part = (scaled / scaled.max()) ** (1 / power)
            share = part / (part**self.exponent).sum() ** (1 / self.exponent)
        return float(share @ scaled), share * half * np.sign(direction)

    def distance(self, x, y):
        """How far places x (n,) and y (n,) are from the curve, negative inside, to rounding: (n,)."""
        places = np.stack((x, y), axis=1)
        return np.where(self.levels(places)[0] < 1, -1.0, 1.0) * self.feet(places)[0]

    def feet(self, points):
        """How far points (n, 2) are from the curve, and its nearest places: (n,), (n, 2)."""
        far, angle = np.empty((2, len(points)))
        for start in range(0, len(points), CHUNK):
            some = slice(start, start + CHUNK)
            far[some], angle[some] = self.nearest(np.abs(points[some]))
        return far, np.copysign(self.at(angle)[0], points)

    def nearest(self, places):
        """How far places of the first quarter (n, 2) are from the curve, and the angle where it is nearest: two (n,).

        The best of some places of the curve has the nearest point between its neighbours. Outside there is one such
        place; inside there may be several, and the least is that of all of them.
        """
        off = places[:, None] - self.at(self.angles)[0]
        squares = np.pad(dot(off, off), ((0, 0), (1, 1)), constant_values=np.inf)
        best = (squares[:, 1:-1] <= squares[:, :-2]) & (squares[:, 1:-1] <= squares[:, 2:])
        point, node = np.nonzero(best)
        last = len(self.angles) - 1
        x, low, high = (self.angles[np.clip(node + side, 0, last)] for side in (0, -1, 1))
        least, angle = self.refined(places[point], x, low, high)
        order = np.lexsort((least, point))
        first = order[np.append(True, np.diff(point[order]) > 0)[: len(order)]]
        return np.sqrt(least[first]), angle[first]

    def refined(self, places, x, low, high):
        """The least square of the distance of places (n, 2) from the curve between two angles each, and where: (n,)."""
        least, best = np.full(len(x), np.inf), x.copy()
        active, near = np.arange(len(x)), np.zeros(len(x), dtype=bool)
        for _ in range(STEPS):
            if not len(active):
                break
            at, ahead, speed, turn = self.at(x)
            off = at - places[active]
            square = dot(off, off)
            better = square < least[active]
            least[active[better]], best[active[better]] = square[better], x[better]
            slope, bend = dot(off, ahead), speed * dot(ahead, ahead) + dot(off, turn)
            low, high = np.where(slope <= 0, x, low), np.where(slope > 0, x, high)
            step = slope / np.where(np.isfinite(bend) & (bend > 0), bend, np.inf)
            after = x - np.where(np.abs(step) < ANGLE, np.copysign(ANGLE, slope), step)  # over the root, or not yet
            halved = near | (after <= low) | (after >= high)
            near, x = np.abs(step) < ANGLE, np.where(halved, (low + high) / 2, after)
            going = high - low > 2 * ANGLE
            active, x, low, high, near = (part[going] for part in (active, x, low, high, near))
        return least, best

    @cached_property
    def angles(self):
        """Some angles from 0 to a right one, rising: spread evenly, and where the curve has turned evenly: (k,)."""
        even, (a, b) = np.linspace(0.0, np.pi / 2, LOOKED), self.half
        if self.exponent == 1:
            return even
        with np.errstate(over="ignore"):
            turned = np.arctan((np.tan(even[1:-1]) * b / a) ** (1 / (self.exponent - 1)))
        return np.unique(np.concatenate((even, turned)))

    def at(self, angle):
        """The curve where the scaled plane has some angles, from 0 to a right one.

        Returns
        -------
        places : (n, 2) float array
        ahead : (n, 2) float array
            Ways along the curve.
        speed : (n,) float array
            How much of these it goes in a radian.
        turn : (n, 2) float array
            How much these change in a radian.
        """
        (a, b), n = self.half, self.exponent
        c, s = np.cos(angle), np.sin(angle)
        u, v = c ** (n - 1), s ** (n - 1)
        reach = (c * u + s * v) ** (-1 / n)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            turn = (1 - n) * np.stack((a * v / s * c, b * u / c * s), axis=1)
        places = reach[:, None] * np.stack((a * c, b * s), axis=1)
        return places, np.stack((-a * v, b * u), axis=1), reach ** (n + 1), turn

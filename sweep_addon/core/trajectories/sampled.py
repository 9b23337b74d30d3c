# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A smooth trajectory known by points on it."""

from functools import cached_property

import numpy as np

from ..declared.parameters import Array, declared, parameter, points, require
from ..later import later
from .chain import Chain, cut, located
from .curve import row

derivatives = later("core.trajectories.neighbours", "derivatives")
cubics, slopes = later("core.trajectories.monotone", "cubics", "slopes")

SAME = 1e-9  # of the size: points closer than this are one
DEFAULT = ((0, 0, 0), (1, 0, 0), (1, 1, 0.5), (0, 1, 1))


@declared
class Sampled(Chain):
    """A smooth curve through points: a measured path

    u counts the points; one that repeats the point before it does not count. From point to point runs a quintic with
    the tangents and the second derivatives that `derivatives` finds, so that the curvature does not jump. Along it u
    runs so that the speed does not jump either, however far apart the points are: a formula of u is as smooth.

    Examples
    --------
    >>> import numpy as np
    >>> angle = np.linspace(0, 2 * np.pi, 20, endpoint=False)
    >>> circle = Sampled(np.stack((np.cos(angle), np.sin(angle), 0 * angle), axis=1), closed=True)
    >>> round(circle.length() / (2 * np.pi), 5)
    1.0
    """

    points: Array = points(DEFAULT, "Points on the path", most=100_000)
    closed: bool = parameter(False, "The last point leads back to the first")
    radii: Array = parameter((), "Scale of the contour at each point, smoothly between them; none: all 1")
    tilts: Array = parameter((), "Turn of the contour at each point, smoothly between them; none: all 0", unit="angle")

    def check(self):
        """Refuse fewer than two different points, or three of a closed path, and radii that are not one a point."""
        fewest = 3 if self.closed else 2
        require(len(self.kept) >= fewest, f"must have at least {fewest} different points", len(self.kept), "points")
        self.check_carried(len(self.points))

    @cached_property
    def counted(self):
        """The points that do not repeat the one before, or the first at the end of a closed path: (k,) int array."""
        points = self.points.values
        again = SAME * np.ptp(points, axis=0).max(initial=0.0)
        moves = np.linalg.norm(np.diff(points, axis=0), axis=1) > again
        counted = np.flatnonzero(np.append(len(points) > 0, moves))
        ends_again = self.closed and len(counted) > 1 and np.linalg.norm(points[counted[-1]] - points[0]) <= again
        return counted[:-1] if ends_again else counted

    @property
    def kept(self):
        """These points: (k, 3)."""
        return self.points.values[self.counted]

    @cached_property
    def told(self):
        """That some points do not count."""
        again = len(self.points) - len(self.kept)
        count = "repeats a neighbour and does not count" if again == 1 else "repeat a neighbour and do not count"
        return (f"Trajectory: {again:,} of its {len(self.points):,} points {count}.",) if again else ()

    def evaluate(self, u):
        index, (along, *_) = self.run(row(u))
        return cut(along, self.segments[index])[0]

    def derivative(self, u, order=1, before=False):
        require(order <= 3, "must be at most 3", order, "order")
        if not order:
            return self.evaluate(u)
        index, (along, *rates) = self.run(row(u), order, before)
        return chained(rates, cut(along, self.hodographs[index], order - 1))

    def first_two(self, u, before=False):
        index, (along, *rates) = self.run(row(u), 2, before)
        first, second = cut(along, self.hodographs[index], 1)
        return chained(rates[:1], (first,)), chained(rates, (first, second))

    def run(self, u, order=0, before=False):
        """The quintics that parameters are in, how far from 0 to 1, and the derivatives of that up to an order."""
        index, along = located(u, len(self.segments), before)
        a, b, c = self.pacing[:, index]
        rates = ((c * along + b) * along + a) * along, (3 * c * along + 2 * b) * along + a, 6 * c * along + 2 * b, 6 * c
        return index, rates[: order + 1]

    def between(self, values, u):
        """Values at the points, smoothly between them and never beyond them: those of points that repeat one too."""
        values = values[self.counted]
        rises = np.diff(np.append(values, values[:1]) if self.closed else values)
        slope = slopes(rises, self.closed)
        index, along = located(row(u), len(rises))
        a, b, c = np.stack(cubics(rises, slope[:-1], slope[1:]))[:, index]
        return values[index] + ((c * along + b) * along + a) * along

    @cached_property
    def measured(self):
        """First and second derivatives by the length of the chords at each point, and that length up to it."""
        return derivatives(self.kept, self.closed)

    @cached_property
    def pacing(self):
        """How far each quintic is at u, as the coefficients of u, u^2 and u^3 from its start: (3, k).

        By the length of the chords the speed is the same on both sides of a point. So it is by u, where that length
        rises smoothly with u.
        """
        steps = np.diff(self.measured[2])
        slope = slopes(steps, self.closed)
        return np.stack(cubics(1.0, slope[:-1] / steps, slope[1:] / steps))

    @cached_property
    def hodographs(self):
        """The Bezier points of their derivatives: (k, 5, 3)."""
        return 5 * np.diff(self.segments, axis=1)

    @cached_property
    def segments(self):
        """The Bezier points of each quintic: (k, 6, 3)."""
        first, second, knots = self.measured
        points, first, second = (
            np.concatenate((part, part[:1])) if self.closed else part for part in (self.kept, first, second)
        )
        step = np.diff(knots)[:, None]
        start, end = points[:-1], points[1:]
        leave, arrive = step * first[:-1] / 5, step * first[1:] / 5
        bend = step**2 / 20
        return np.stack(
            (
                start,
                start + leave,
                start + 2 * leave + bend * second[:-1],
                end - 2 * arrive + bend * second[1:],
                end - arrive,
                end,
            ),
            axis=1,
        )


def chained(rates, derivatives):
    """The last derivative of a function of a function, by those of both up to its order of at most three."""
    if len(rates) == 1:
        weights = rates
    elif len(rates) == 2:
        weights = rates[1], rates[0] ** 2
    else:
        weights = rates[2], 3 * rates[0] * rates[1], rates[0] ** 3
    return sum(weight[:, None] * part for weight, part in zip(weights, derivatives, strict=True))

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A trajectory as a non-uniform rational B-spline."""

from math import comb

import numpy as np

from ..declared.parameters import Array, count, declared, parameter, points, require
from .curve import Trajectory, row

MOST = 50_000  # control points up to order 4, for which a few seconds are enough
DEFAULT = ((0, 0, 0), (0, 0, 0.6), (0, 0.4, 1), (0, 1, 1))


@declared
class Nurbs(Trajectory):
    """A rational B-spline

    u runs over the knots. Without knots of its own, an open curve is clamped: it starts and ends at its outer points,
    with u from 0 to the number of spans; a closed one has uniform knots.

    Source
    ------
    Piegl, Tiller: The NURBS Book, 2nd ed., algorithms A2.2 (basis by the triangle) and A4.2 (rational derivatives).

    Examples
    --------
    >>> from math import sqrt
    >>> quarter = Nurbs([(1, 0, 0), (1, 1, 0), (0, 1, 0)], weights=[1, sqrt(0.5), 1], order=3)
    >>> round(quarter.length() / (3.141592653589793 / 2), 12)
    1.0
    """

    points: Array = points(DEFAULT, "Control points", most=MOST)
    weights: Array = parameter((), "Weight of each control point; none: all 1")
    order: int = count(4, "Degree plus one", minimum=2, maximum=12)
    knots: Array = parameter((), "Knots, as many as points and order, and order - 1 more if closed; none: even")
    closed: bool = parameter(False, "The end is the start again")
    radii: Array = parameter((), "Scale of the contour at each control point, blended as the points are; none: all 1")
    tilts: Array = parameter(
        (), "Turn of the contour at each control point, blended as the points are; none: all 0", unit="angle"
    )

    def check(self):
        """Refuse numbers of points, weights, knots, radii or tilts that do not fit, and what has no length."""
        size = len(self.points)
        require(size >= 2, "must have at least 2 points", size, "points")
        most = MOST * 4**2 // max(4, self.order) ** 2  # a point of the curve takes time as the order's square
        require(size <= most, f"must have at most {most} points where the order is {self.order}", size, "points")
        require(self.order <= size, f"must be at most {size}, the number of control points", self.order, "order")
        self.check_carried(size)
        weights, knots = self.weights.values, self.knots.values
        require(len(weights) in (0, size), f"must be {size} numbers, one a control point", len(weights), "weights")
        require((weights > 0).all(), "must all be more than 0", weights.tolist(), "weights")
        moving = np.ptp(self.points.values, axis=0).max() > 0
        require(moving, "must not all be in one place", self.points.values.tolist(), "points")
        if len(knots):
            wanted = len(self.control) + self.order
            require(len(knots) == wanted, f"must be {wanted} numbers", len(knots), "knots")
            require((np.diff(knots) >= 0).all(), "must not fall", knots.tolist(), "knots")
            spread = knots[-self.order] > knots[self.order - 1]
            require(spread, "must rise between the first and the last span", knots.tolist(), "knots")
            apart = np.ptp(knots[size:] - knots[:-size]) if self.closed else 0.0
            again = f"must be spaced again as they were after {size} of them, for the curve is closed"
            require(apart <= 1e-9 * np.ptp(knots), again, knots.tolist(), "knots")

    @property
    def control(self):
        """Homogeneous control points (n, 4); those of a closed curve are wrapped round."""
        return self.weighted(self.points.values)

    def weighted(self, values):
        """Values (n, k) at the control points times their weights, and the weights."""
        weights = self.weights.values if len(self.weights) else np.ones(len(values))
        control = np.column_stack((values * weights[:, None], weights))
        return np.concatenate((control, control[: self.order - 1])) if self.closed else control

    def between(self, values, u):
        """Values at the control points, blended as these are: (n,)."""
        total, weight = self.homogeneous(row(u), 0, False, self.weighted(values[:, None])).T
        return total / weight

    @property
    def knot_vector(self):
        if len(self.knots):
            return self.knots.values
        if self.closed:
            return np.arange(len(self.points) + 2 * self.order - 1, dtype=float) - (self.order - 1)
        spans = len(self.points) - self.order + 1
        return np.clip(np.arange(len(self.points) + self.order) - (self.order - 1.0), 0, spans)

    @property
    def domain(self):
        knots, control = self.knot_vector, self.control
        return float(knots[self.order - 1]), float(knots[len(control)])

    def joints(self):
        knots = np.unique(self.knot_vector)
        return knots[(knots >= self.domain[0]) & (knots <= self.domain[1])]

    def evaluate(self, u):
        return self.derivative(u, 0)

    def derivative(self, u, order=1, before=False):
        u = row(u)
        curve = [self.homogeneous(u, k, before, self.control) for k in range(order + 1)]
        weight = curve[0][:, 3:]
        found = []
        for k in range(order + 1):  # Leibniz: (w C)^(k) = A^(k)
            lower = sum(comb(k, i) * curve[i][:, 3:] * found[k - i] for i in range(1, k + 1))
            found.append((curve[k][:, :3] - lower) / weight)
        return found[order]

    def homogeneous(self, u, order, before, control):
        """A derivative of a homogeneous curve (n, k), by de Boor's corner cutting of the differences."""
        knots, degree = self.knot_vector, self.order - 1
        for _ in range(order):
            if degree == 0:
                return np.zeros((len(u), control.shape[1]))
            gap = (knots[degree + 1 : degree + len(control)] - knots[1 : len(control)])[:, None]
            control = degree * np.diff(control, axis=0) / np.where(gap, gap, np.inf)
            knots, degree = knots[1:-1], degree - 1
        side = "left" if before else "right"
        span = np.clip(np.searchsorted(knots, u, side=side) - 1, degree, len(control) - 1)
        span = nonempty(knots, span)
        local = control[span[:, None] + np.arange(-degree, 1)]
        for level in range(1, degree + 1):
            index = span[:, None] + np.arange(level - degree, 1)
            low, high = knots[index], knots[index + degree - level + 1]
            along = ((u[:, None] - low) / np.where(high > low, high - low, 1.0))[..., None]
            local = (1 - along) * local[:, :-1] + along * local[:, 1:]
        return local[:, 0]


def nonempty(knots, span):
    """Spans moved down to the nearest one that has a length."""
    empty = knots[span + 1] <= knots[span]
    while empty.any():
        span = np.where(empty, span - 1, span)
        empty = (knots[span + 1] <= knots[span]) & (span > 0)
    return span

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A chain of polynomial segments, each given by its Bezier points."""

from math import perm

import numpy as np

from .curve import Trajectory, row


class Chain(Trajectory):
    """Segments of any degree; u counts them. A kind gives `segments`, (k, degree + 1, 3)."""

    @property
    def domain(self):
        return 0.0, float(len(self.segments))

    def joints(self):
        return np.arange(self.domain[1] + 1)

    def evaluate(self, u):
        return corner_cutting(u, self.segments)

    def derivative(self, u, order=1, before=False):
        control = self.segments
        for _ in range(order):
            degree = control.shape[1] - 1
            control = degree * np.diff(control, axis=1) if degree else np.zeros_like(control)
        return corner_cutting(u, control, before)


def corner_cutting(u, control, before=False):
    """Points of polynomials with these Bezier points: (n,) and (k, m, 3) to (n, 3)."""
    index, along = located(row(u), len(control), before)
    return cut(along, control[index])[0]


def located(u, count, before=False):
    """In which segment each parameter is, or ends, and where from 0 to 1: two (n,)."""
    index = np.clip(np.ceil(u) - 1 if before else np.floor(u), 0, count - 1).astype(int)
    return index, u - index


def cut(along, points, order=0):
    """A point of each polynomial and its derivatives, by de Casteljau's algorithm: (n,) and (n, m, 3) to (n, 3) each.

    The points that are left before the last cuts tell the derivatives.
    """
    along, degree, found = along[:, None, None], points.shape[1] - 1, []
    for left in range(degree, -1, -1):
        if left <= order:
            found.append(perm(degree, left) * np.diff(points, left, axis=1)[:, 0])
        points = (1 - along) * points[:, :-1] + along * points[:, 1:]
    return found[::-1]

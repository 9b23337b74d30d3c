# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A chain of polynomial segments, each given by its Bezier points."""

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
    """Points of polynomials with these Bezier points, by de Casteljau's algorithm: (n,) and (k, m, 3) to (n, 3)."""
    u = row(u)
    index = np.clip(np.ceil(u) - 1 if before else np.floor(u), 0, len(control) - 1).astype(int)
    along = (u - index)[:, None, None]
    points = control[index]
    while points.shape[1] > 1:
        points = (1 - along) * points[:, :-1] + along * points[:, 1:]
    return points[:, 0]

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A trajectory: a curve with a parameter u, evaluated for many u at once."""

import numpy as np

from ..vectors import norms, unit
from .arc_length import arc_length

SAME_DIRECTION = 1e-6  # radians: tangents closer than this meet smoothly, a corner of a micrometre in a metre
SHARPEST = np.cos(np.radians(179.99))  # a sharper turn is a reversal: its mitre would be 10,000 contours long


class Trajectory:
    """What every kind of trajectory can be asked; a kind gives `evaluate`, `derivative` and `domain`.

    Attributes
    ----------
    domain : (float, float)
        First and last parameter, uI and uF.
    closed : bool
        Whether the end is the start again.
    straight : bool
        Whether there is nothing but straight legs between the joints.
    """

    closed = straight = False

    def evaluate(self, u):
        """Points at parameters u: (n,) to (n, 3) float array, in metres."""
        raise NotImplementedError

    def derivative(self, u, order=1, before=False):
        """Derivatives by u, (n, 3); where the curve has a corner, those before it or after it."""
        raise NotImplementedError

    def joints(self):
        """Parameters between which the curve is smooth, both ends included: (k,) float array."""
        return np.array(self.domain, dtype=float)

    def length(self):
        """The arc length in metres."""
        return arc_length(self).total

    def tangents(self, u, before=False):
        """Unit tangents at parameters u: (n,) to (n, 3) float array.

        Where a derivative vanishes, as at a Bezier point whose handle lies on it, the next one gives the limit.
        """
        scale = arc_length(self).total / (self.domain[1] - self.domain[0])
        tangents = self.derivative(u, 1, before)
        for order in (2, 3):
            vanishing = norms(tangents) < 1e-9 * scale
            if not vanishing.any():
                break
            side = (-1) ** (order - 1) if before else 1
            tangents[vanishing] = side * self.derivative(u[vanishing], order, before)
        return unit(tangents)

    def corners(self):
        """The joints inside the domain where the tangent turns at once, as parameters."""
        joints = self.joints()
        inner = joints[1:-1]
        if self.closed:
            inner = joints[:-1]
        before = self.tangents(np.where(inner == joints[0], joints[-1], inner), before=True)
        return inner[norms(self.tangents(inner) - before) > SAME_DIRECTION]

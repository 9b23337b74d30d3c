# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A trajectory that winds round a torus and closes."""

from math import gcd, tau

import numpy as np

from ..declared.parameters import count, declared, length, require
from .curve import Trajectory


@declared
class TorusKnot(Trajectory):
    """A closed curve on a torus about the z axis

    x = (major + minor cos qu) cos pu, y = (major + minor cos qu) sin pu, z = minor sin qu, u from 0 to 2 pi.

    Examples
    --------
    >>> TorusKnot(p=2, q=3).evaluate([0.0]).tolist()
    [[1.4, 0.0, 0.0]]
    """

    p: int = count(2, "Times it goes round the axis", maximum=200, soft_maximum=12)
    q: int = count(3, "Times it goes through the hole", maximum=200, soft_maximum=12)
    major: float = length(1.0, "Radius of the torus")
    minor: float = length(0.4, "Radius of the tube of the torus")

    closed = True
    domain = (0.0, tau)

    def check(self):
        """Refuse p and q with a factor in common, whose curve would run over itself."""
        require(gcd(self.p, self.q) == 1, f"must share no factor with p, which is {self.p}", self.q, "q")

    def evaluate(self, u):
        u = np.asarray(u, dtype=float)
        ring = (self.major + self.minor * np.cos(self.q * u)) * np.exp(1j * self.p * u)
        return np.stack((ring.real, ring.imag, self.minor * np.sin(self.q * u)), axis=1)

    def derivative(self, u, order=1, before=False):
        # a sum of turning pointers, each of which a derivative multiplies by i times its rate
        u, p, q, half = np.asarray(u, dtype=float), self.p, self.q, self.minor / 2
        about, through = np.exp(1j * p * u), np.exp(1j * q * u)
        times = {rate: (1j * rate) ** order for rate in (p, q, p + q, p - q)}
        ring = about * (times[p] * self.major + half * times[p + q] * through + half * times[p - q] * through.conj())
        return np.stack((ring.real, ring.imag, self.minor * (times[q] * through).imag), axis=1)

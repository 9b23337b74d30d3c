# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trajectories about the z axis: the arc, the helix, and the knot on a torus."""

from math import gcd, hypot, pi, tau

import numpy as np

from ..declared.parameters import angle, count, declared, length, parameter, require
from ..later import later
from .curve import Trajectory, row

turning = later("core.trajectories.turning", "turning")

WHOLE = 2e-5  # radians: an arc this near to a full turn is one, as 6.2832 is meant to be
FLAT = 1e-6  # of the radius of a helix: less rise is none in single precision


@declared
class Arc(Trajectory):
    """A part of a circle about the z axis, or all of it

    u is the angle in radians, from 0 on the x axis. A full turn is closed.

    Examples
    --------
    >>> from math import pi, tau
    >>> round(Arc(radius=2.0, angle=pi).length() / tau, 12)
    1.0
    >>> Arc(angle=pi).closed, Arc(angle=tau).closed
    (False, True)
    """

    radius: float = length(1.0, "Distance from the axis")
    angle: float = angle(pi, "How far it turns; a full turn is closed", above=0.0, maximum=tau + WHOLE)

    @property
    def closed(self):
        return self.angle >= tau - WHOLE

    @property
    def domain(self):
        return 0.0, tau if self.closed else self.angle

    @property
    def pace(self):
        return self.radius

    axis = (0.0, 0.0, 1.0)

    def evaluate(self, u):
        return self.derivative(u, 0)

    def derivative(self, u, order=1, before=False):
        return turning(self.radius, u, 0.0, order)[0]

    def moving(self, u):
        return turning(self.radius, u, 0.0, 0, 1, 2)


@declared
class Helix(Trajectory):
    """A helix about the z axis

    u is the angle in radians, from 0 on the x axis to 2 pi times the turns. A negative pitch makes it left-handed.

    Examples
    --------
    >>> import numpy as np
    >>> helix = Helix(radius=3.0, pitch=8 * np.pi, turns=1.0)
    >>> round(helix.length() / (10 * np.pi), 12)
    1.0
    """

    radius: float = length(1.0, "Distance from the axis")
    pitch: float = parameter(0.5, "Rise in one turn", unit="length")
    turns: float = parameter(5.0, "Number of turns", above=0.0, maximum=10_000.0, soft_maximum=50.0)

    def check(self):
        """Refuse a pitch of less than a millionth of the radius, where a whole turn would lie on itself."""
        least = FLAT * self.radius
        rises = self.turns < 1 or abs(self.pitch) >= least
        require(rises, f"must be at least {least:g} in size, or a whole turn lies on itself", self.pitch, "pitch")

    @property
    def domain(self):
        return 0.0, tau * self.turns

    @property
    def pace(self):
        return hypot(self.radius, self.pitch / tau)

    axis = (0.0, 0.0, 1.0)

    def evaluate(self, u):
        return self.derivative(u, 0)

    def derivative(self, u, order=1, before=False):
        return turning(self.radius, u, self.pitch / tau, order)[0]

    def moving(self, u):
        return turning(self.radius, u, self.pitch / tau, 0, 1, 2)


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
        u = row(u)
        ring = (self.major + self.minor * np.cos(self.q * u)) * np.exp(1j * self.p * u)
        return np.stack((ring.real, ring.imag, self.minor * np.sin(self.q * u)), axis=1)

    def derivative(self, u, order=1, before=False):
        # a sum of turning pointers, each of which a derivative multiplies by i times its rate
        u, p, q, half = row(u), self.p, self.q, self.minor / 2
        about, through = np.exp(1j * p * u), np.exp(1j * q * u)
        times = {rate: (1j * rate) ** order for rate in (p, q, p + q, p - q)}
        ring = about * (times[p] * self.major + half * times[p + q] * through + half * times[p - q] * through.conj())
        return np.stack((ring.real, ring.imag, self.minor * (times[q] * through).imag), axis=1)

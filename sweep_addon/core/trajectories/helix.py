# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A helical trajectory."""

from math import hypot, tau

from ..declared.parameters import declared, length, parameter, require
from ..later import later
from .curve import Trajectory

turning = later("core.trajectories.turning", "turning")

FLAT = 1e-6  # of the radius: less rise is none in single precision


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

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A circular trajectory."""

from math import pi, tau

from ..declared.parameters import angle, declared, length
from ..later import later
from .curve import Trajectory

turning = later("core.trajectories.turning", "turning")

WHOLE = 2e-5  # radians: an arc this near to a full turn is one, as 6.2832 is meant to be


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

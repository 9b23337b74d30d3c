# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A straight trajectory."""

from math import dist

import numpy as np

from ..declared.parameters import declared, parameter, require
from .curve import Trajectory, row


@declared
class Line(Trajectory):
    """A straight line

    u runs from 0 at the start to 1 at the end.

    Examples
    --------
    >>> round(Line(start=(0, 0, 0), end=(0, 3, 4)).length(), 12)
    5.0
    """

    start: tuple[float, float, float] = parameter((0, 0, 0), "Where it starts", unit="length")
    end: tuple[float, float, float] = parameter((0, 0, 1), "Where it ends", unit="length")

    domain = (0.0, 1.0)
    straight = True

    def check(self):
        """Refuse an end that is the start."""
        require(self.start != self.end, "must differ from the start", list(self.end), "end")

    def evaluate(self, u):
        u = row(u)[:, None]
        return (1 - u) * np.array(self.start) + u * np.array(self.end)

    def derivative(self, u, order=1, before=False):
        direction = np.subtract(self.end, self.start) if order == 1 else np.zeros(3)
        return np.tile(direction, (len(row(u)), 1))

    @property
    def pace(self):
        return dist(self.start, self.end)

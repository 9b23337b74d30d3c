# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The rectangle, its corners sharp or rounded, as a contour."""

import numpy as np

from ..parameters import count, declared, length, parameter, require
from .section import Section


@declared
class Rectangle:
    """A rectangle about its reference point

    Corners without rounding are sharp, rounded ones are smooth however few their points.

    Examples
    --------
    >>> Rectangle(width=2.0, height=1.0).section().area
    2.0
    >>> len(Rectangle(width=2.0, height=1.0, rounding=0.1, corner_points=5).section().points)
    20
    """

    width: float = length(1.0, "Size along x, which is e2 of the frame")
    height: float = length(2.0, "Size along y, which is e3 of the frame")
    rounding: float = parameter(
        0.0, "Radius of the corners, at most half the shorter side; 0 leaves them sharp", unit="length", minimum=0.0
    )
    corner_points: int = count(8, "Points around each rounded corner", minimum=2, maximum=1024, soft_maximum=32)

    def check(self):
        most = min(self.width, self.height) / 2
        require(self.rounding <= most, f"must be at most {most:g}, half the shorter side", self.rounding, "rounding")

    def section(self):
        """The rectangle as a `Section` of one loop, which begins at the corner of +x and +y."""
        half = np.array([self.width, self.height]) / 2
        towards = np.array([(1, 1), (-1, 1), (-1, -1), (1, -1)])
        if self.rounding == 0:
            return Section(half * towards, np.array([0, 4]), np.ones(4, dtype=bool))
        angles = np.linspace(0, np.pi / 2, self.corner_points) + np.pi / 2 * np.arange(4)[:, None]
        arcs = self.rounding * np.stack([np.cos(angles), np.sin(angles)], axis=2)
        points = ((half - self.rounding) * towards)[:, None] + arcs
        return Section.from_loops([points.reshape(-1, 2)], sharp=[np.zeros(angles.size, dtype=bool)])

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The rectangle, its corners sharp or rounded, as a contour."""

import numpy as np

from ..declared.parameters import count, declared, length, parameter, require
from ..declared.refusals import require_broad
from ..later import later

rounded, rounded_apexes = later("core.contours.rounding", "rounded", "rounded_apexes")
Section = later("core.contours.section", "Section")

TOWARDS = np.array([(1, 1), (-1, 1), (-1, -1), (1, -1)])  # the corners


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
        """Refuse a side of less than a millionth of the other, and a rounding of more than half the shorter one."""
        require_broad(self, "width", "height")
        most = min(self.width, self.height) / 2
        require(self.rounding <= most, f"must be at most {most:g}, half the shorter side", self.rounding, "rounding")

    @property
    def area(self):
        """What the curve encloses, in square metres."""
        return self.width * self.height - (4 - np.pi) * self.rounding**2

    def section(self):
        """The rectangle as a `Section` of one loop, which begins at the corner of +x and +y."""
        if self.rounding == 0:
            half = np.array([self.width, self.height]) / 2
            return Section(half * TOWARDS, np.array([0, 4]), np.ones(4, dtype=bool))
        return rounded(*self.corners())

    def apexes(self):
        """(m, 2) float array: the point of the curve that is farthest from each edge; none without curves."""
        return rounded_apexes(*self.corners()) if self.rounding else None

    def corners(self):
        """The arcs: their centres, radius, first angles, angle and points."""
        half = np.array([self.width, self.height]) / 2
        return (half - self.rounding) * TOWARDS, self.rounding, np.pi / 2 * np.arange(4), np.pi / 2, self.corner_points

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The ellipse, as a contour."""

import numpy as np

from ..declared.parameters import count, declared, length
from ..declared.refusals import require_broad
from ..later import later

Section = later("core.contours.section", "Section")


@declared
class Ellipse:
    """An ellipse about its reference point

    As the image of a regular polygon in a circle, so that every edge cuts off the same area; smooth all round however
    few its points, the first on +x.

    Examples
    --------
    >>> section = Ellipse(radius_x=2.0, radius_y=1.0, points=4).section()
    >>> section.points.round(9).tolist()
    [[2.0, 0.0], [0.0, 1.0], [-2.0, 0.0], [-0.0, -1.0]]
    """

    radius_x: float = length(1.0, "Distance of the ellipse from the centre along x, which is e2 of the frame")
    radius_y: float = length(0.5, "Distance of the ellipse from the centre along y, which is e3 of the frame")
    points: int = count(64, "Points around the ellipse", minimum=3, maximum=4096, soft_maximum=128)

    def check(self):
        """Refuse a radius of less than a millionth of the other."""
        require_broad(self, "radius_x", "radius_y")

    @property
    def area(self):
        """What the curve encloses, in square metres."""
        return np.pi * self.radius_x * self.radius_y

    def section(self):
        """The polygon as a `Section` of one loop."""
        return Section(self.around(0.0), np.array([0, self.points]), np.zeros(self.points, dtype=bool))

    def apexes(self):
        """(points, 2) float array: the point of the curve that is farthest from each edge."""
        return self.around(0.5)

    def support(self, directions):
        """How far the curve reaches along directions (n, 2), times their lengths: (n,)."""
        return np.hypot(*(directions * (self.radius_x, self.radius_y)).T)

    def around(self, ahead):
        """(points, 2) float array: points of the curve, a part of a step ahead of the polygon's."""
        angles = 2 * np.pi * (np.arange(self.points) + ahead) / self.points
        return np.stack([self.radius_x * np.cos(angles), self.radius_y * np.sin(angles)], axis=1)

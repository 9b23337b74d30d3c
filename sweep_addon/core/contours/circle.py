# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The circle, as a contour."""

import numpy as np

from ..declared.parameters import count, declared, length
from ..later import later

Section = later("core.contours.section", "Section")


@declared
class Circle:
    """A circle about its reference point

    As a polygon inscribed in it, smooth all round however few its points, the first on +x.

    Examples
    --------
    >>> section = Circle(radius=2.0, points=4).section()
    >>> section.points.round(9).tolist()
    [[2.0, 0.0], [0.0, 2.0], [-2.0, 0.0], [-0.0, -2.0]]
    """

    radius: float = length(1.0, "Distance of the points from the centre")
    points: int = count(64, "Points around the circle", minimum=3, maximum=4096, soft_maximum=128)

    @property
    def area(self):
        """What the curve encloses, in square metres."""
        return np.pi * self.radius**2

    def section(self):
        """The polygon as a `Section` of one loop."""
        return Section(self.around(0.0), np.array([0, self.points]), np.zeros(self.points, dtype=bool))

    def apexes(self):
        """(points, 2) float array: the point of the curve that is farthest from each edge."""
        return self.around(0.5)

    def support(self, directions):
        """How far the curve reaches along directions (n, 2), times their lengths: (n,)."""
        return self.radius * np.hypot(*directions.T)

    def around(self, ahead):
        """(points, 2) float array: points of the curve, a part of a step ahead of the polygon's."""
        angles = 2 * np.pi * (np.arange(self.points) + ahead) / self.points
        return self.radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)

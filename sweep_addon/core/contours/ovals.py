# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Round contours: the circle, the ellipse, and the superellipse between a star, that and a rectangle."""

from dataclasses import replace
from math import gamma

import numpy as np

from ..declared.parameters import count, declared, length, parameter
from ..declared.refusals import require_broad
from ..later import later

sections = later("core.contours.section")

TABLE = 1 << 12  # steps of the integral that spaces the points of a superellipse


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
        return sections.Section(self.around(0.0), np.array([0, self.points]), np.zeros(self.points, dtype=bool))

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
        return sections.Section(self.around(0.0), np.array([0, self.points]), np.zeros(self.points, dtype=bool))

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


@declared
class Superellipse:
    """Between a star, an ellipse and a rectangle

    The curve |2x / width|^n + |2y / height|^n = 1 about its reference point, the exponent n: below 1 it has four
    tips, 1 is a rhombus, 2 an ellipse, and large ones come near a rectangle.

    The points stand at equal steps of affine arc length, so that every edge cuts off about the same area whatever the
    exponent: corners keep their points, flat sides take few. It is sharp where, with equal width and height, it turns
    by more than 20 degrees and by half more than a circle of as many points.

    Source
    ------
    Lame: Examen des differentes methodes employees pour resoudre les problemes de geometrie, 1818, the curve;
    affine arc length is the integral of the cube root of the curvature over arc length.

    Examples
    --------
    With exponent 2 the points are those of an `Ellipse`:

    >>> Superellipse(width=4.0, height=2.0, exponent=2.0, quarter_points=2).section().points.round(6).tolist()[:2]
    [[2.0, 0.0], [1.414214, 0.707107]]
    """

    width: float = length(2.0, "Size along x, which is e2 of the frame")
    height: float = length(1.5, "Size along y, which is e3 of the frame")
    exponent: float = parameter(
        2.5, "Below 1 hollow with four tips, 1 a rhombus, 2 an ellipse, more like a rectangle the larger it is",
        minimum=0.25, maximum=100.0, soft_maximum=10.0,
    )  # fmt: skip
    quarter_points: int = count(16, "Points around each quarter", minimum=2, maximum=1024, soft_maximum=32)

    def check(self):
        """Refuse a size of less than a millionth of the other."""
        require_broad(self, "width", "height")

    @property
    def area(self):
        """What the curve encloses, in square metres: Dirichlet's integral."""
        inverse = 1 / self.exponent
        return self.width * self.height * gamma(1 + inverse) ** 2 / gamma(1 + 2 * inverse)

    def section(self):
        """The polygon as a `Section` of one loop, which begins on +x."""
        points = self.around(0.0)
        even = sections.Section(points, np.array([0, len(points)]), np.zeros(len(points), dtype=bool))
        sharp = np.abs(even.turns) > max(sections.SHARP, 1.5 * 2 * np.pi / len(points))
        return replace(even, points=points * self.half, sharp=sharp)

    def apexes(self):
        """(m, 2) float array: a point of the curve about farthest from each edge."""
        return self.around(0.5) * self.half

    @property
    def half(self):
        """Half of width and height, in metres."""
        return self.width / 2, self.height / 2

    def around(self, ahead):
        """(m, 2) float array: points of the curve of half sizes 1, a part of a step ahead of the polygon's."""
        quarter = first_quarter(self.exponent, (np.arange(self.quarter_points) + ahead) / self.quarter_points)
        turned = quarter[:, ::-1] * (-1, 1)
        return np.concatenate([quarter, turned, -quarter, -turned])


def first_quarter(exponent, part):
    """Points of x^n + y^n = 1 from (1, 0) on.

    Parameters
    ----------
    exponent : float
    part : (k,) float array
        How much of the quarter's affine arc length, 0 to 1, lies before each point.

    Returns
    -------
    (k, 2) float array

    The affine arc length up to y^n = v is a beta integral of v and 1 - v to the power a - 1, a = (n + 1) / 3n. The
    integral over v^a has no pole at 0, and the second half of the quarter is the mirror image of the first.
    """
    a = (exponent + 1) / (3 * exponent)
    grid = np.linspace(0, 0.5**a, TABLE + 1)
    rate = (1 - grid ** (1 / a)) ** (a - 1)
    length = np.concatenate(([0.0], np.cumsum(rate[1:] + rate[:-1])))
    v = np.interp(2 * np.minimum(part, 1 - part) * length[-1], length, grid) ** (1 / a)
    points = np.stack([1 - v, v], axis=1) ** (1 / exponent)
    return np.where(part[:, None] > 0.5, points[:, ::-1], points)

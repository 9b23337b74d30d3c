# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Contours of equal sectors: the regular polygon, its corners sharp or rounded, and the star."""

from enum import Enum
from math import cos, pi, sin, tan

import numpy as np

from ..declared.parameters import count, declared, length, parameter, require
from ..declared.refusals import require_broad
from ..later import later

rounded, rounded_apexes = later("core.contours.rounding", "rounded", "rounded_apexes")
Section = later("core.contours.section", "Section")


class RadiusTo(Enum):
    CORNERS = "The radius is that of the circle through the corners"
    SIDES = "The radius is that of the circle inside, half the size across flats"


@declared
class RegularPolygon:
    """A polygon of equal sides and angles

    About its reference point, a corner on +x. Corners without rounding are sharp however many, rounded ones are
    smooth however few their points.

    Examples
    --------
    A hexagon of 2 m across flats has the area 2 sqrt(3):

    >>> hexagon = RegularPolygon(sides=6, radius=1.0, radius_to="sides")
    >>> round(hexagon.section().area**2, 9)
    12.0
    """

    sides: int = count(6, "Number of sides", minimum=3, maximum=1024, soft_maximum=16)
    radius: float = length(1.0, "Distance of the corners, or of the sides, from the centre")
    radius_to: RadiusTo = parameter(RadiusTo.CORNERS, "What the radius is measured to")
    rounding: float = parameter(
        0.0, "Radius of the corners, at most the distance of the sides from the centre; 0 leaves them sharp",
        unit="length", minimum=0.0,
    )  # fmt: skip
    corner_points: int = count(8, "Points around each rounded corner", minimum=2, maximum=256, soft_maximum=32)

    def check(self):
        """Refuse a rounding larger than the distance of the sides from the centre."""
        most = self.inner
        require(self.rounding <= most, f"must be at most {most:.9g}, where the sides are", self.rounding, "rounding")

    @property
    def inner(self):
        """The distance of the sides from the centre, in metres."""
        return self.radius * (cos(pi / self.sides) if self.radius_to is RadiusTo.CORNERS else 1)

    @property
    def area(self):
        """What the sides and arcs enclose, in square metres."""
        corners = self.sides * tan(pi / self.sides)  # of a polygon about the unit circle
        return corners * self.inner**2 - (corners - pi) * self.rounding**2

    def section(self):
        """The polygon as a `Section` of one loop, which begins at the corner on +x."""
        if self.rounding == 0:
            corners = self.towards() * self.inner / cos(pi / self.sides)
            return Section(corners, np.array([0, self.sides]), np.ones(self.sides, dtype=bool))
        return rounded(*self.corners())

    def apexes(self):
        """(m, 2) float array: the point of the curve that is farthest from each edge; none without curves."""
        return rounded_apexes(*self.corners()) if self.rounding else None

    def towards(self):
        """(sides, 2) float array: the directions of the corners."""
        angles = 2 * pi * np.arange(self.sides) / self.sides
        return np.stack([np.cos(angles), np.sin(angles)], axis=1)

    def corners(self):
        """The arcs: their centres, radius, first angles, angle and points."""
        half = pi / self.sides
        centres = self.towards() * (self.inner - self.rounding) / cos(half)
        return centres, self.rounding, half * (2 * np.arange(self.sides) - 1), 2 * half, self.corner_points


@declared
class Star:
    """A star of equal tips

    About its reference point, a tip on +x; sharp at every corner.

    Examples
    --------
    >>> section = Star(points=4, outer=2.0, inner=1.0).section()
    >>> section.points[:2].round(3).tolist(), round(section.area**2, 9)
    ([[2.0, 0.0], [0.707, 0.707]], 32.0)
    """

    points: int = count(5, "Number of tips", minimum=2, maximum=2048, soft_maximum=16)
    outer: float = length(1.0, "Distance of the tips from the centre")
    inner: float = length(0.4, "Distance of the corners between tips from the centre")

    def check(self):
        """Refuse a radius of less than a millionth of the other."""
        require_broad(self, "inner", "outer")

    @property
    def area(self):
        """What the sides enclose, in square metres."""
        return self.points * self.outer * self.inner * sin(pi / self.points)

    def section(self):
        """The star as a `Section` of one loop, which begins at the tip on +x."""
        corners = 2 * self.points
        angles = pi * np.arange(corners) / self.points
        radius = np.where(np.arange(corners) % 2, self.inner, self.outer)
        around = radius[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1)
        return Section(around, np.array([0, corners]), np.ones(corners, dtype=bool))

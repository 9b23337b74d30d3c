# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Morph: further contours along a sweep, which the contour becomes on its way."""

from enum import Enum

from ..contours import Aerofoil, Circle, Contour, Ellipse, Outline, Rectangle, RegularPolygon, Star, Superellipse
from ..declared.parameters import declared, parameter, proven

__all__ = ["Blend", "Match", "Morph"]

LOOP = [(-0.1, -0.1), (0.1, -0.1), (0.1, -0.06), (-0.06, -0.06), (-0.06, 0.1), (-0.1, 0.1)]
AS_THICK = (  # as the tube of a circle: so that another contour in its place passes between the turns of a helix, too
    Circle(0.1),
    Ellipse(0.14, 0.07),
    Rectangle(0.1, 0.2),
    RegularPolygon(radius=0.1),
    Star(outer=0.12, inner=0.05),
    Superellipse(0.2, 0.15),
    proven(Aerofoil, chord=0.25),
    proven(Outline, loops=[LOOP]),
)


class Match(Enum):
    BY_ARC_LENGTH = "Points at the same part of the way round, begun where the contours are turned least"
    BY_CORNER = "Corner to corner, and between them at the same part of the way; all contours have as many"
    BY_INDEX = "First to first, second to second; all contours have as many points"


class Blend(Enum):
    LINEAR = "Straight from each contour to the next"
    SMOOTH = "In a smooth curve through all contours, that goes no farther than they do"
    EASED = "Slowly out of each contour and into the next"


@declared
class Morph:
    """A further contour on the way

    >>> Morph(0.5, Circle(2.0)).contour.radius
    2.0
    """

    t: float = parameter(1.0, "Where it stands, as a part of the trajectory's length", above=0.0, maximum=1.0)
    contour: Contour = parameter(
        Rectangle(0.1, 0.2), "What the contour has become there", others=AS_THICK, accepts=("CURVE", "FONT")
    )

    @classmethod
    def after(cls, shape):
        """One more for a shape: at the end, or amid the widest gap."""
        taken = sorted(each.t for each in shape.morph)
        if not shape.trajectory.closed and (not taken or taken[-1] < 1):
            return cls(1.0)
        gaps = list(zip([0.0, *taken], [*taken, 1.0], strict=True))
        first, last = max(gaps, key=lambda gap: gap[1] - gap[0])
        return cls((first + last) / 2)

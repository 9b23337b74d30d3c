# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prisms, as solids: figures that have moved along z, as much below their plane as above."""

import numpy as np

from ..declared.parameters import count, declared, length, require
from ..shapes.operand import Operand


class Prism(Operand):
    """A figure that has moved along z. A kind gives `figure`, the contour, and `height`, in metres."""

    def mesh(self):
        """The surface as a `Mesh`."""
        return self.sweep().mesh()

    def sweep(self):
        """The same as a `TranslationalSweep`."""
        from ..shapes.translational_sweep import TranslationalSweep  # shapes have solids as parameters

        contour, height = self.figure(), self.height
        return TranslationalSweep(contour, height=height, directions="symmetric", texture="none", attributes=False)


@declared
class Block(Prism):
    """A block about its reference point

    Examples
    --------
    >>> Block(width=2.0, depth=2.0, height=2.0).mesh().euler_characteristic()
    2
    """

    width: float = length(0.5, "Size along x")
    depth: float = length(0.5, "Size along y")
    height: float = length(0.5, "Size along z")

    def figure(self):
        from ..contours import Rectangle

        return Rectangle(self.width, self.depth)


@declared
class Cylinder(Prism):
    """A round cylinder about the z axis

    Its base is a polygon inscribed in the circle.

    Examples
    --------
    >>> len(Cylinder(points=6).mesh().vertices)
    12
    """

    radius: float = length(0.2, "Distance of the points from the axis")
    height: float = length(0.6, "Size along z")
    points: int = count(64, "Points around the axis", minimum=3, maximum=4096, soft_maximum=128)

    def figure(self):
        from ..contours import Circle

        return Circle(self.radius, self.points)


@declared
class Bracket(Prism):
    """An L-bracket: two legs at a right angle

    Its legs run along x and y from the corner at the origin.

    Examples
    --------
    >>> round(Bracket(width=0.4, depth=0.6, thickness=0.1, height=1.0).mesh().volume(), 12)
    0.09
    """

    width: float = length(0.5, "Length of the leg along x")
    depth: float = length(0.5, "Length of the leg along y")
    thickness: float = length(0.12, "Thickness of both legs")
    height: float = length(0.2, "Size along z")

    def check(self):
        """Refuse legs that are no longer than thick."""
        most = min(self.width, self.depth)
        require(self.thickness < most, f"must be less than {most:g}, the shorter leg", self.thickness, "thickness")

    def figure(self):
        from ..contours import Outline

        w, d, t = self.width, self.depth, self.thickness
        return Outline([[(0, 0), (w, 0), (w, t), (t, t), (t, d), (0, d)]])


@declared
class DrilledBlock(Prism):
    """A block with a round hole drilled through along z

    The hole's edge is a polygon inscribed in its circle.

    Examples
    --------
    >>> DrilledBlock().mesh().euler_characteristic()
    0
    """

    width: float = length(0.5, "Size along x")
    depth: float = length(0.5, "Size along y")
    height: float = length(0.3, "Size along z")
    radius: float = length(0.15, "Radius of the hole")
    points: int = count(64, "Points around the hole", minimum=3, maximum=4096, soft_maximum=128)

    def check(self):
        """Refuse a hole that is no less wide than the block."""
        most = min(self.width, self.depth) / 2
        require(self.radius < most, f"must be less than {most:g}, half the shorter side", self.radius, "radius")

    def figure(self):
        from ..contours import Circle, Outline, Rectangle

        sections = Rectangle(self.width, self.depth).section(), Circle(self.radius, self.points).section()
        return Outline([np.array(section.points) for section in sections])

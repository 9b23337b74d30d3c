# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The cylinder, as a solid."""

from ..declared.parameters import count, declared, length
from ..later import later
from ..shapes.operand import Operand

prism = later("core.solids.prism", "prism")


@declared
class Cylinder(Operand):
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

    def mesh(self):
        """The surface as a `Mesh`."""
        return self.sweep().mesh()

    def sweep(self):
        """The same as a `TranslationalSweep`."""
        from ..contours import Circle

        return prism(Circle(self.radius, self.points), self.height)

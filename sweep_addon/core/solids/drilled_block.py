# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The drilled block, as a solid of constructive solid geometry: a block less a cylinder."""

import numpy as np

from ..declared.parameters import count, declared, length, require
from ..later import later
from ..shapes.operand import Operand

prism = later("core.solids.prism", "prism")


@declared
class DrilledBlock(Operand):
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

    def mesh(self):
        """The surface as a `Mesh`."""
        return self.sweep().mesh()

    def sweep(self):
        """The same as a `TranslationalSweep`."""
        from ..contours import Circle, Outline, Rectangle

        sections = Rectangle(self.width, self.depth).section(), Circle(self.radius, self.points).section()
        return prism(Outline([np.array(section.points) for section in sections]), self.height)

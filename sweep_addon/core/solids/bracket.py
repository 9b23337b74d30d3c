# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The bracket, as a solid: an L that has moved along z."""

from ..declared.parameters import declared, length, require
from ..later import later
from ..shapes.operand import Operand

prism = later("core.solids.prism", "prism")


@declared
class Bracket(Operand):
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

    def mesh(self):
        """The surface as a `Mesh`."""
        return self.sweep().mesh()

    def sweep(self):
        """The same as a `TranslationalSweep`."""
        from ..contours import Outline

        w, d, t = self.width, self.depth, self.thickness
        return prism(Outline([[(0, 0), (w, 0), (w, t), (t, t), (t, d), (0, d)]]), self.height)

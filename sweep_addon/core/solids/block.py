# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The block, as a solid."""

from ..declared.parameters import declared, length
from ..later import later
from ..shapes.operand import Operand

prism = later("core.solids.prism", "prism")


@declared
class Block(Operand):
    """A block about its reference point

    Examples
    --------
    >>> Block(width=2.0, depth=2.0, height=2.0).mesh().euler_characteristic()
    2
    """

    width: float = length(0.5, "Size along x")
    depth: float = length(0.5, "Size along y")
    height: float = length(0.5, "Size along z")

    def mesh(self):
        """The surface as a `Mesh` of six faces."""
        return self.sweep().mesh()

    def sweep(self):
        """The same as a `TranslationalSweep`."""
        from ..contours import Rectangle

        return prism(Rectangle(self.width, self.depth), self.height)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Stock: the block of material that a program cuts."""

import numpy as np

from ..declared.parameters import declared, length, parameter, require

LEAST = 1e-6  # metres that a side of the block has at least


@declared
class Around:
    """A block around all that the program cuts

    It is as wide as the moves below its top and the tool take, and a margin on every side.

    >>> Around(margin=0.001, floor=0.002).top
    0.0
    """

    margin: float = parameter(0.002, "Material beside what is cut", unit="length", minimum=0.0)
    floor: float = length(0.002, "Material below the deepest cut")
    top: float = parameter(0.0, "Height of its top, from the zero of the program", unit="length")

    def box(self, path, starts, ends, radii):
        """Its lowest and highest corner, for moves of tools with such radii: two (3,) arrays in metres."""
        below = np.minimum(starts[:, 2], ends[:, 2]) < self.top - LEAST
        lowest = min(starts[:, 2].min(), ends[:, 2].min())
        require(below.any(), f"must be above {lowest:g}, the lowest Z of the program in metres", self.top, "top")
        reach = radii[below, None] + self.margin
        low = (np.minimum(starts, ends)[below, :2] - reach).min(axis=0)
        high = (np.maximum(starts, ends)[below, :2] + reach).max(axis=0)
        deepest = np.minimum(starts[:, 2], ends[:, 2]).min()
        return np.append(low, deepest - self.floor), np.append(high, self.top)


@declared
class Box:
    """A block from corner to corner, in the places of the program

    >>> Box(low=(0, 0, -0.01), high=(0.1, 0.05, 0)).high
    (0.1, 0.05, 0.0)
    """

    low: tuple[float, float, float] = parameter((-0.05, -0.05, -0.02), "Its lowest corner", unit="length")
    high: tuple[float, float, float] = parameter((0.05, 0.05, 0.0), "Its highest corner", unit="length")

    def check(self):
        """Refuse corners that are not below each other."""
        sides = np.subtract(self.high, self.low)
        require((sides >= LEAST).all(), "must be above the lowest corner along each axis", list(self.high), "high")

    def box(self, path, starts, ends, radii):
        return np.array(self.low), np.array(self.high)


Stock = Around | Box

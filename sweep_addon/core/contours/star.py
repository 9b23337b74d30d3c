# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The star, as a contour."""

from math import pi, sin

import numpy as np

from ..declared.parameters import count, declared, length
from ..declared.refusals import require_broad
from ..later import later

Section = later("core.contours.section", "Section")


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

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Planes that lean towards the mitres of straight legs, as rings of the mesh do where a law changes the contour.

On the inner side of a corner a plane across its leg is cut off by the mitre. Where the contour stays as it is that
makes no difference; else it is what the leaning planes sweep that is continuous there: `..mitres`.
"""

import numpy as np

from ...rings.mitres import fans, legs
from ...shapes.carrying import across, placed
from ...vectors import cross, unit
from .way import Carried

TIP = 1e-12  # a scale of a contour that is a point: its plane has axes all the same


class Leaning:
    """How contours stand at the stations of straight legs.

    Parameters
    ----------
    standing : callable
        From arc lengths to Stations, the scales there, how far the contours are off, and two axes.
    corners : (k,) float array
        The arc lengths of corners, and of an open way's ends.
    reach : float
        How far the contour gets from its reference point before any scale, in metres.
    """

    def __init__(self, standing, corners, reach):
        self.standing, self.corners, self.reach = standing, corners, reach

    def breaks(self):
        """Arc lengths where planes begin to lean, or cease to."""
        stations, rings, *_ = self.rings(self.corners)
        (first, last, _), (starts, ends) = legs(stations), fans(stations, rings, self.reach)
        places = np.concatenate((stations.s[first] + starts[1], stations.s[last] - ends[1]))
        return places % stations.total

    def rings(self, s):
        """Stations, the contours' ways off them and their axes before they lean, and the scales of and in these."""
        stations, scales, offset, e2, e3 = self.standing(s)
        some = np.where(scales == 0, TIP, scales)
        return stations, np.stack((across(offset, e2, e3), e2 * some[:, [0]], e3 * some[:, [1]])), scales, some

    def carried(self, s):
        """The planes at rising arc lengths: a `Carried`."""
        held = np.unique(np.concatenate((s, self.corners)))
        stations, rings, *scales = self.rings(held)
        middle, x, y = placed(stations, self.reach, *rings)[:, np.searchsorted(held, s)]
        scales, some = (part[np.searchsorted(held, s)] for part in scales)
        x, y = x / some[:, [0]], y / some[:, [1]]
        normal = unit(cross(x, y))
        told = np.linalg.inv(np.stack((x, y, normal), axis=2))
        return Carried(middle, normal, told[:, 0], told[:, 1], scales)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The section across an ISO metric screw thread, as a contour."""

from math import sqrt

import numpy as np

from ..declared.parameters import count, declared, length, require
from ..later import later

Section = later("core.contours.section", "Section")

DEPTH = 5 / 8 * sqrt(3) / 2  # of the pitch: five eighths of the height of the triangle
PARTS = np.array([2, 5, 4, 5]) / 16  # of the pitch: crest, flank, root and the other flank


@declared
class ScrewThread:
    """A cut across an ISO metric thread, to be twisted by a turn a pitch

    Along a line with ``twist="2*pi*s/pitch"`` it sweeps the thread on its core, with a negative twist a left-handed
    one: what an axial cut shows along a pitch, a cut across shows round a turn. So crest and root are arcs about the
    axis, and the flanks, which are straight in the axial cut, are spirals of Archimedes. The middle of a crest lies on
    +x. With several starts a turn of the twist is their number of pitches.

    Source
    ------
    ISO 68-1, ISO general purpose screw threads, basic profile: flanks at 60 degrees, crests of an eighth and roots of a
    quarter of the pitch.

    Examples
    --------
    The minor diameter of M8, 6.647 mm in ISO 724:

    >>> section = ScrewThread(diameter=0.008, pitch=0.00125).section()
    >>> round(2000 * float(np.hypot(*section.points.T).min()), 3)
    6.647
    """

    diameter: float = length(0.008, "Diameter over the crests")
    pitch: float = length(0.00125, "Distance from crest to crest along the axis")
    starts: int = count(1, "Threads side by side", maximum=64, soft_maximum=4)
    points: int = count(64, "Points of each thread, shared by crest, flanks and root", minimum=16, maximum=1024)

    def check(self):
        """Refuse a pitch so large that the roots reach the axis."""
        most = self.diameter / 2 / DEPTH
        require(self.pitch < most, f"must be less than {most:.6g}, or the roots reach the axis", self.pitch, "pitch")

    @property
    def area(self):
        """What the curve encloses, in square metres: sectors of circles, and of spirals by Simpson's rule, exactly."""
        crest, root = self.radii
        squares = np.array([crest**2, 0, root**2, 0])
        squares[[1, 3]] = (crest**2 + crest * root + root**2) / 3
        return float(np.pi * squares @ PARTS)

    def section(self):
        """The polygon as a `Section` of one loop, with edges where flanks meet crest and root."""
        points, sharp = self.around(0.0)
        return Section(points, np.array([0, len(points)]), sharp)

    def apexes(self):
        """(m, 2) float array: a point of the curve about farthest from each edge."""
        return self.around(0.5)[0]

    @property
    def radii(self):
        """Radius of crests and roots, in metres."""
        return self.diameter / 2, self.diameter / 2 - DEPTH * self.pitch

    def around(self, ahead):
        """Points of the curve (m, 2), a part of a step ahead of the polygon's, and (m,) bools: which begin a part."""
        shares = np.round(self.points * PARTS).astype(int)
        part = np.repeat(np.arange(4), shares)
        within = np.arange(len(part)) - np.repeat(np.cumsum(shares) - shares, shares)
        ends = np.cumsum(PARTS) - PARTS[0] / 2
        place = (ends - PARTS)[part] + PARTS[part] * (within + ahead) / shares[part]  # in pitches, from a crest
        radius = np.interp(place, ends, np.array(self.radii)[[0, 1, 1, 0]])
        thread = np.arange(self.starts)[:, None]
        turned = np.exp(2j * np.pi * (thread + place) / self.starts).ravel()
        points = np.tile(radius, self.starts)[:, None] * np.stack([turned.real, turned.imag], axis=1)
        return points, np.tile(within == 0, self.starts)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A primitive of a converted outline: the cross-section of a block, a wedge, a cylinder, ..."""

import numpy as np

from ..contours import Outline
from ..declared.frozen import frozen
from .inside import inside
from .loop import Loop


@frozen
class Primitive:
    """A region of the plane of one of the kinds; extruded, it is the solid of that name

    Parameters
    ----------
    kind : str
        One of `kinds.KINDS`.
    loop : Loop
        Its corners and bulges, counter-clockwise.

    Examples
    --------
    >>> round(Primitive("cylinder", Loop(((1.0, 0.0), (-1.0, 0.0)), (1.0, 1.0))).area, 6)
    3.141593
    """

    kind: str
    loop: Loop

    @property
    def corners(self):
        """(n, 2) float array: the vertices."""
        return np.array(self.loop.corners)

    @property
    def bulges(self):
        """(n,) float array: the bulge of the edge after each vertex."""
        return np.array(self.loop.bulges)

    @property
    def area(self):
        """The area by formula, from the chords and the angles of the arcs."""
        return self.loop.area

    @property
    def outline(self):
        """The region as a contour that can be swept."""
        return outline_of(self.loop)

    def classify(self, points):
        """(n,) bool array: which of the points (n, 2) are inside."""
        return inside(self.loop, points)


def outline_of(loop):
    """A loop as a contour that can be swept."""
    return Outline(loops=[np.array(loop.corners)], bulges=[np.array(loop.bulges)])

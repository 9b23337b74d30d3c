# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Upright prisms, whose distance is that of their contour."""

import numpy as np


class Prism:
    """A planar sweep along z that is also known by its distance.

    Parameters
    ----------
    plane : MovingPlane
        The same as a set of points.
    region : Disc or Loops
    aside : (2,) float array
        Where the contour's origin is.
    low, high : float
        Between which heights.
    """

    overlaps = False

    def __init__(self, plane, region, aside, low, high):
        self.plane, self.region, self.aside, self.ends, self.box = plane, region, aside, (low, high), plane.box
        self.is_sheet = plane.is_sheet

    def labels(self, points, tolerance):
        """IN, ON, OUT or TOUCHED for points (n, 3): (n,) int8."""
        return self.plane.labels(points, tolerance)

    def distance(self, points):
        """How far points (n, 3) are from the surface, negative inside: (n,)."""
        across = self.region.distance(points[:, 0] - self.aside[0], points[:, 1] - self.aside[1])
        along = np.maximum(self.ends[0] - points[:, 2], points[:, 2] - self.ends[1])
        outside = np.sqrt(np.maximum(across, 0.0) ** 2 + np.maximum(along, 0.0) ** 2)
        return outside + np.minimum(np.maximum(across, along), 0.0)

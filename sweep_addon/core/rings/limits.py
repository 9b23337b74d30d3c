# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Limits: what ends a constant cross-section solid at the start and at the end of its axis."""

from functools import cached_property

import numpy as np

from ..declared.parameters import declared, parameter, require
from ..vectors import unit
from .ends import Flat, Open

__all__ = ["Flat", "Limit", "Open", "Plane"]


@declared
class Plane:
    """A plane in any position, up to which the solid is cut off, or goes on straight beyond the trajectory's end

    >>> from sweep_addon.core.contours import Rectangle
    >>> from sweep_addon.core.stations.directions import Arrows
    >>> from sweep_addon.core.shapes.pd_curve_sweep import PDCurveSweep
    >>> from sweep_addon.core.trajectories import Line
    >>> wedge = PDCurveSweep(Rectangle(1, 1), Line(end=(0, 0, 2)), Arrows(), end=Plane((0, 0, 1.5), (-1, 0, 1)))
    >>> round(wedge.mesh().volume(), 12)
    1.5
    """

    point: tuple[float, float, float] = parameter((0, 0, 0), "A point of the plane", unit="length")
    normal: tuple[float, float, float] = parameter((0, 0, 1), "The direction across the plane, to either side")

    def check(self):
        """Refuse a normal without length."""
        require(np.linalg.norm(self.normal) > 0, "must have a length", list(self.normal), "normal")

    @cached_property
    def across(self):
        """The unit normal: (3,) float array."""
        return unit(np.array(self.normal, dtype=float))

    def heights(self, points):
        """How far points (..., 3) lie beyond the plane, on the side of its normal, in metres."""
        return (points - np.array(self.point)) @ self.across


Limit = Flat | Plane | Open


def __dir__():
    return __all__  # what a console offers

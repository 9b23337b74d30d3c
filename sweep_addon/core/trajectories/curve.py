# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A trajectory: a curve with a parameter u, evaluated for many u at once."""

from math import cos, radians

import numpy as np

from ..declared.parameters import Array, require
from ..later import later
from ..vectors import norms, unit

arc_length = later("core.trajectories.arc_length", "arc_length")

SAME_DIRECTION = 1e-6  # radians: tangents closer than this meet smoothly, a corner of a micrometre in a metre
SHARPEST = cos(radians(179.99))  # a sharper turn is a reversal: its mitre would be 10,000 contours long
NONE = Array(())


def row(u):
    """Parameters as they are asked for, as numbers, (n,); anything else is refused."""
    try:
        numbers = np.asarray(u, dtype=float)
    except (TypeError, ValueError):
        numbers = None
    require(numbers is not None and numbers.ndim == 1, "must be a list or an array of numbers", u, "u")
    return numbers


class Trajectory:
    """What every kind of trajectory can be asked; a kind gives `evaluate`, `derivative` and `domain`.

    Attributes
    ----------
    straight : bool
        Whether there is nothing but straight legs between the joints.
    pace : float or None
        The speed, in metres for each unit of u, where it is the same everywhere.
    axis : tuple of three float, or None
        A direction about which all tangents turn by a radian for each unit of u, at one angle to it, if there is one.
    radii, tilts : Array
        What the curve itself scales the contour by and turns it by, in radians, at each of its points; empty: 1 and 0.
    too_sharp : (k,) int array
        Corners that a contour may not go round with a mitre; where there are any, `limited` has none of them.
    told : tuple of str
        Sentences for people: what was decided where the points left it open.
    """

    straight = False
    pace = axis = None
    radii = tilts = NONE
    too_sharp = told = ()

    @property
    def domain(self):
        """First and last parameter, uI and uF: (float, float), in the unit that the kind says.

        Examples
        --------
        >>> from sweep_addon.core.trajectories import Line
        >>> Line(end=(0, 0, 3)).domain
        (0.0, 1.0)
        """
        raise NotImplementedError

    @property
    def closed(self):
        """Whether the end is the start again.

        Examples
        --------
        >>> from sweep_addon.core.trajectories import Polyline
        >>> Polyline([(0, 0, 0), (3, 0, 0), (0, 4, 0)], closed=True).length()
        12.0
        """
        return False

    def evaluate(self, u):
        """Points of the trajectory.

        Parameters
        ----------
        u : (n,) array
            Parameters in the domain.

        Returns
        -------
        (n, 3) float array
            In metres.

        Raises
        ------
        ShapeError
            For anything but a row of numbers, and where a formula has no finite value.

        Examples
        --------
        >>> from sweep_addon.core.trajectories import Line
        >>> Line(end=(0, 0, 3)).evaluate([0.0, 0.5, 1.0]).tolist()
        [[0.0, 0.0, 0.0], [0.0, 0.0, 1.5], [0.0, 0.0, 3.0]]
        """
        raise NotImplementedError

    def derivative(self, u, order=1, before=False):
        """Derivatives by u, (n, 3); where the curve has a corner, those before it or after it."""
        raise NotImplementedError

    def first_two(self, u, before=False):
        """First and second derivatives at parameters u: two (n, 3), with less work than each by itself."""
        return self.derivative(u, 1, before), self.derivative(u, 2, before)

    def moving(self, u):
        """Points, first and second derivatives at parameters u: three (n, 3), with less work than each by itself."""
        return self.evaluate(u), *self.first_two(u)

    def speeds(self, u, before=False):
        """How long the derivatives are at parameters u: (n,) to (n,)."""
        return np.full(np.shape(u), self.pace) if self.pace else norms(self.derivative(u, 1, before))

    def joints(self):
        """Parameters between which the curve is smooth, both ends included: (k,) float array."""
        return np.array(self.domain, dtype=float)

    @property
    def carries(self):
        """Whether the curve itself scales or turns the contour."""
        return len(self.radii) > 0 or len(self.tilts) > 0

    def carried(self, u):
        """The curve's own scale and turn of the contour at parameters u: two (n,)."""
        return tuple(
            self.between(given.values, u) if len(given) else np.full(np.shape(u), otherwise)
            for given, otherwise in ((self.radii, 1.0), (self.tilts, 0.0))
        )

    def between(self, values, u):
        """Values at the joints, linear in u between them, as Blender has them."""
        return np.interp(u, self.joints(), np.append(values, values[:1]) if self.closed else values)

    def check_carried(self, size):
        """Refuse radii and tilts that are not one a point, and radii below 0."""
        for key in ("radii", "tilts"):
            given = len(getattr(self, key))
            require(given in (0, size), f"must be {size} numbers, one a point", given, key)
        least = self.radii.values.min(initial=0.0)
        require(least >= 0, "must all be at least 0", float(least), "radii")

    def length(self):
        """The arc length in metres.

        Raises
        ------
        ShapeError
            Where it is less than a millionth of a micrometre, or a formula has no finite derivative.

        Examples
        --------
        >>> from sweep_addon.core.trajectories import Polyline
        >>> Polyline([(0, 0, 0), (3, 0, 0), (3, 4, 0)]).length()
        7.0
        """
        return arc_length(self).total

    def tangents(self, u, before=False, first=None):
        """Unit tangents at parameters u: (n,) to (n, 3) float array.

        Where a derivative vanishes, as at a Bezier point whose handle lies on it, the next one gives the limit.
        First derivatives are computed unless given.
        """
        tangents = self.derivative(u, 1, before) if first is None else first
        if self.pace:
            return tangents / self.pace
        scale = arc_length(self).total / (self.domain[1] - self.domain[0])
        for order in (2, 3):
            vanishing = norms(tangents) < 1e-9 * scale
            if not vanishing.any():
                break
            side = (-1) ** (order - 1) if before else 1
            tangents = tangents.copy()
            tangents[vanishing] = side * self.derivative(u[vanishing], order, before)
        return unit(tangents)

    def corners(self):
        """The joints inside the domain where the tangent turns at once, as parameters."""
        joints = self.joints()
        inner = joints[1:-1]
        if self.closed:
            inner = joints[:-1]
        if not len(inner):
            return inner
        before = self.tangents(np.where(inner == joints[0], joints[-1], inner), before=True)
        return inner[norms(self.tangents(inner) - before) > SAME_DIRECTION]

    def stops(self):
        """Parameters inside the domain where a contour stands whatever the sampling says: (k,) float array."""
        return self.corners()

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A trajectory of cubic Bezier segments."""

import numpy as np

from ..declared.parameters import Array, ShapeError, declared, parameter, points, require
from .chain import Chain

NEAR_ZERO = 1e-9
DEFAULT = ((0, 0, 0), (0, 0, 0.5), (0, 0.5, 1), (0, 1, 1))


@declared
class Bezier(Chain):
    """A chain of cubic Bezier segments

    The points are knot, handle, handle, knot, and so on: 3 k + 1 of them, or 3 k where the chain is closed and the
    last handle leads to the first knot. u counts the segments. Where handles meet at an angle, the corner is mitred.

    Examples
    --------
    >>> Bezier([(0, 0, 0), (1, 0, 0), (2, 0, 0), (3, 0, 0)]).evaluate([0.5]).tolist()
    [[1.5, 0.0, 0.0]]
    """

    points: Array = points(DEFAULT, "Knots with their handles")
    closed: bool = parameter(False, "The last knot leads back to the first")
    radii: Array = parameter((), "Scale of the contour at each knot, evenly between them; none: all 1")
    tilts: Array = parameter((), "Turn of the contour at each knot, evenly between them; none: all 0", unit="angle")

    def check(self):
        """Refuse a number of points that makes no segments, a segment without length, and a cusp."""
        rest = 0 if self.closed else 1
        require(len(self.points) >= 3 + rest, f"must have at least {3 + rest} points", len(self.points), "points")
        form = "a multiple of 3" if self.closed else "1 more than a multiple of 3"
        require(len(self.points) % 3 == rest, f"must be {form}: knot, handle, handle, ...", len(self.points), "points")
        moves = np.abs(np.diff(self.segments, axis=1)).max(axis=(1, 2))
        still = moves <= 1e-9 * max(np.ptp(self.points.values, axis=0).max(), 1e-300)
        if still.any():
            raise ShapeError(f"must have no segment without length, got segment {np.argmax(still) + 1}", "points")
        cusps = self.cusps()
        if len(cusps):
            raise ShapeError(f"must not turn back on itself, got a cusp at u = {cusps[0]:.6g}", "points")
        self.check_carried(len(self.segments) + (not self.closed))

    def cusps(self):
        """Parameters inside the segments where the derivative passes zero, so that the curve turns back: (c,).

        There the coordinates of the derivative, quadratic polynomials, have a simple root in common.
        """
        a, b, c = np.diff(self.segments, axis=1).swapaxes(0, 1)
        square, half = a - 2 * b + c, b - a
        size = np.abs(self.segments - self.segments[:, :1]).max(axis=(1, 2))[:, None]
        with np.errstate(all="ignore"):
            discriminant = half**2 - square * a
            larger = -half - np.copysign(np.sqrt(discriminant), half)
            roots = np.stack((larger / square, a / larger))
        inside = (discriminant > NEAR_ZERO * size**2) & (roots > NEAR_ZERO) & (roots < 1 - NEAR_ZERO)
        index = np.nonzero(inside)[1]
        u = index + roots[inside]
        return np.sort(u[np.linalg.norm(self.derivative(u), axis=1) <= NEAR_ZERO * size[index, 0]])

    @property
    def segments(self):
        """The control points, segment by segment: (k, 4, 3)."""
        points = self.points.values
        chain = np.concatenate((points, points[:1])) if self.closed else points
        return np.stack([chain[i : len(chain) - 3 + i : 3] for i in range(4)], axis=1)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A trajectory of straight legs whose corners are meant."""

from functools import cached_property

import numpy as np

from ..declared.parameters import Array, ShapeError, declared, parameter, parameters, points, require
from ..rings.corners import UNLIMITED, Corner, Mitre, Round
from ..vectors import dot, unit
from .curve import NONE, SHARPEST
from .legs import Cut, Legs

INVISIBLE = 1e-7  # of the whole path: a corner that would take less of its legs is left as it is
ROUNDING = 1e-6  # of a leg, by which single precision, and the number that a refusal shows, may be too long
APART = 1.001  # times what it must take: so its inner edges come near each other and do not touch
TAKEN = 1 / 3  # of the shorter leg: what a mitre beyond its limit may take


@declared
class Polyline(Legs):
    """Straight legs with mitred, round or bevelled corners

    u counts the corners: 0 at the first, 1 at the second, and so on; of a round or bevelled one it is the middle.

    Examples
    --------
    >>> round(Polyline([(0, 0, 0), (1, 0, 0), (1, 2, 0)]).length(), 12)
    3.0
    """

    points: Array = points(((0, 0, 0), (0, 0, 1)), "Corners of the path")
    closed: bool = parameter(False, "The last corner leads back to the first")
    corner: Corner = parameter(Mitre(), "What becomes of the corners", splines=("POLY",))
    radii: Array = parameter((), "Scale of the contour at each corner, evenly between them; none: all 1")
    tilts: Array = parameter((), "Turn of the contour at each corner, evenly between them; none: all 0", unit="angle")

    def check(self):
        """Refuse a leg without length, a leg straight back, and corners that take more of a leg than there is."""
        fewest = 3 if self.closed else 2
        require(len(self.points) >= fewest, f"must have at least {fewest} points", len(self.points), "points")
        legs = self.legs
        size = np.ptp(self.points.values, axis=0).max()
        self.refuse(self.lengths <= 1e-9 * size, "must not be where the next one is")
        legs = unit(legs)
        turn = dot(legs, np.roll(legs, 1, axis=0))
        self.refuse((turn < SHARPEST)[0 if self.closed else 1 :], "must not turn back on itself", not self.closed)
        self.check_carried(len(self.points))
        if not isinstance(self.corner, Mitre):
            self.check_room()

    def refuse(self, where, sentence, skipped=0):
        """Refuse the first point where something holds; the skipped points are not among those asked."""
        if where.any():
            index = int(np.argmax(where)) + skipped
            raise ShapeError(f"{sentence}, got point {index + 1} at {self.points.values[index].tolist()}", "points")

    def check_room(self):
        """Refuse corners that take more of a leg than there is."""
        leg = int(np.argmax(self.crowding))
        size = parameters(type(self.corner))[0].name
        got, most = getattr(self.corner, size), self.crowding[leg]
        start, end = (points[leg] + 1 for points in self.ends)
        fits = most <= 1 + ROUNDING
        sentence = f"must be at most {got / max(most, 1):.7g} to fit into the leg from point {start} to point {end}"
        require(fits, sentence, got, f"corner.{size}")

    @cached_property
    def wanted(self):
        """What each corner takes from both its legs where there is room, in metres: (n,) float array."""
        return np.where(self.turns > 0, self.corner.setbacks(self.turns), 0.0)

    @cached_property
    def crowding(self):
        """The part of each leg that its corners take: (k,) float array."""
        start, end = self.ends
        return (self.wanted[start] + self.wanted[end]) / self.lengths

    @cached_property
    def setbacks(self):
        """What each corner takes from both its legs, in metres: an `Array`, empty where they are mitred."""
        if isinstance(self.corner, Mitre):
            return NONE
        taken = self.wanted / max(1.0, self.crowding.max())
        return Array(np.where(taken > INVISIBLE * self.lengths.sum(), taken, 0.0))

    @property
    def rounded(self):
        return isinstance(self.corner, Round)

    @cached_property
    def too_sharp(self):
        """Indices of the points where a mitre would be longer than its limit: (k,) int array."""
        if not isinstance(self.corner, Mitre) or self.corner.limit >= UNLIMITED:
            return ()
        return np.flatnonzero(self.corner.limit * np.cos(self.turns / 2) < 1)

    def limited(self, reach):
        """The path with bevels for mitres that are too long, and a sentence that says so.

        The outer edge of a contour that reaches so far, in metres, then runs from where that of one leg ends, square to
        the corner, to where that of the other begins, as in SVG, while the inner edges meet as those of a mitre do. In
        the middle between both are the setbacks, as far as the legs have room for that.
        """
        sharp, taken = self.too_sharp, np.zeros(len(self.points))
        shorter = np.minimum(self.lengths[sharp - 1], self.lengths[sharp])
        least = INVISIBLE * self.lengths.sum()
        taken[sharp] = np.minimum(np.maximum(APART * reach * np.tan(self.turns[sharp] / 2) / 2, least), TAKEN * shorter)
        length = 1 / np.cos(self.turns[sharp[0]] / 2)
        all_of_them = f"it and {len(sharp) - 1} more are" if len(sharp) > 1 else "it is"
        told = (
            f"Corner: the mitre at point {sharp[0] + 1} would be {length:.3g} widths long, and the limit is "
            f"{self.corner.limit:.9g}; {all_of_them} bevelled."
        )
        return Cut(self.points, self.closed, Array(taken), reach, self.radii, self.tilts), told

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Along the path: how the contour is scaled and turned at each station, its tapers included."""

from dataclasses import dataclass, replace

import numpy as np

from .ends import Taper
from .laws import Constant, Law
from .parameters import ShapeError, at, require
from .sampling import WIDEST_TURN
from .trajectories.arc_length import arc_length

NOTHING = 1e-9  # of the largest scale: a contour this small is a point
SEARCHED = 4097  # places along the trajectory where a change of sign is looked for


@dataclass(frozen=True)
class Along:
    """The laws of one sweep.

    Parameters
    ----------
    trajectory : Trajectory
    scale_x, scale_y, twist : Law
    tapers : tuple of two float
        Lengths in metres over which the contour grows from a point at the start and shrinks to one at the end; 0: none.
    """

    trajectory: object
    scale_x: Law
    scale_y: Law
    twist: Law
    tapers: tuple = (0.0, 0.0)

    @property
    def is_constant(self):
        return self.scale_x.is_constant and self.scale_y.is_constant and self.twist.is_constant

    def unchanging(self):
        """The same for all laws that are constant, whose values do not move the stations."""
        one = Constant(1.0)
        return replace(self, scale_x=one, scale_y=one, twist=one) if self.is_constant else self

    def at(self, s, u=None):
        """Scales along e2 and e3 and the twist in radians at arc lengths, or at parameters known: three (n,)."""
        measure = arc_length(self.trajectory)
        u, t = measure.parameter(s) if u is None else u, s / measure.total
        values = []
        for key in ("scale_x", "scale_y", "twist"):
            with at(key):
                values.append(getattr(self, key).evaluate(u, t, s))
        taper = np.ones_like(s)
        for length, left in zip(self.tapers, (s, measure.total - s), strict=True):
            if length:
                taper *= np.clip(left / length, 0.0, 1.0)
        return values[0] * taper, values[1] * taper, values[2]

    def marks(self):
        """Arc lengths where a station must be: the starts of tapers, and where the scale changes its sign."""
        total = arc_length(self.trajectory).total
        require(sum(self.tapers) <= total * (1 + 1e-9), f"must be at most {total:g} together", sum(self.tapers), "end")
        marks = [self.tapers[0], total - self.tapers[1]]
        if not self.is_constant:
            marks.extend(self.crossings(np.linspace(0.0, total, SEARCHED)))
        return tuple(mark for mark in marks if 0.0 < mark < total)

    def crossings(self, s):
        """Arc lengths where the scale along e2 passes zero, by bisection of all of them at once."""
        positive = self.at(s)[0] > 0
        change = np.flatnonzero(positive[1:] != positive[:-1])
        low, high = s[change], s[change + 1]
        for _ in range(50):
            middle = (low + high) / 2
            below = (self.at(middle)[0] > 0) == positive[change]
            low, high = np.where(below, middle, low), np.where(below, high, middle)
        return high

    def density(self, reach):
        """Steps per metre that twist and scale ask for, as a function of arc length and chord tolerance.

        The outermost point of the contour, ``reach`` metres out, bends by reach * twist'^2 and reach * scale''.
        """

        def steps(s, chord):
            scale_x, scale_y, twist = self.at(s)
            rate = np.abs(np.gradient(twist, s))
            size = np.maximum(np.abs(scale_x), np.abs(scale_y))
            change = sum(np.abs(np.gradient(np.gradient(scale, s), s)) for scale in (scale_x, scale_y))
            change[change * s[-1] ** 2 < 1e-4 * size.max()] = 0.0  # rounding of the differences
            bend = reach * (size * rate**2 + change)
            return np.maximum(np.sqrt(bend / (8 * chord)), rate / WIDEST_TURN)

        return steps

    def check_closed(self):
        """On a closed trajectory every law must come back to where it began, the twist by whole turns."""
        measure = arc_length(self.trajectory)
        ends = self.at(np.array([0.0, measure.total]))
        for key, (first, last) in zip(("scale_x", "scale_y"), ends[:2], strict=True):
            same = abs(last - first) <= 1e-9 * max(abs(first), abs(last))
            require(same, f"must be the same at both ends of a closed trajectory, {first:g}", float(last), key)
        turns = (ends[2][1] - ends[2][0]) / (2 * np.pi)
        whole = abs(turns - np.round(turns)) <= 1e-9
        require(whole, "must grow by whole turns along a closed trajectory", f"{turns:.9g} turns", "twist")


def tapers(start, end):
    """The lengths of two ends that taper to a point, 0 where they do not."""
    return tuple(end.length if isinstance(end, Taper) else 0.0 for end in (start, end))


def tips(scale_x, scale_y):
    """Where the contour is a point: a (n,) bool array; and whether it is mirrored.

    Raises
    ------
    ShapeError
        Where the contour is a line, changes its side, or is a point along a stretch.
    """
    largest = max(np.abs(scale_x).max(), np.abs(scale_y).max())
    require(largest > 0, "must not be 0 everywhere", 0, "scale_x")
    flat_x, flat_y = np.abs(scale_x) <= NOTHING * largest, np.abs(scale_y) <= NOTHING * largest
    for flat, other, keys in ((flat_x, flat_y, ("scale_x", "scale_y")), (flat_y, flat_x, ("scale_y", "scale_x"))):
        if (flat & ~other).any():
            raise ShapeError(
                f"must not be 0 where {keys[1]} is not, got 0 at contour {np.argmax(flat & ~other) + 1}", keys[0]
            )
    side = np.sign(scale_x * scale_y)[~flat_x]
    require(len(set(side)) == 1, "must not change its sign against scale_x", "both signs", "scale_y")
    stretch = flat_x[1:] & flat_x[:-1]
    require(not stretch.any(), "must not stay 0 along a stretch", f"0 at contour {np.argmax(stretch) + 1}", "scale_x")
    return flat_x, bool(side[0] < 0)

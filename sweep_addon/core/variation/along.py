# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Along the path: how the contour is scaled, turned and moved at each station, its tapers included."""

from dataclasses import replace
from functools import cached_property, lru_cache
from math import gcd

import numpy as np

from ..contours.symmetry import ALIKE
from ..declared.frozen import frozen
from ..declared.parameters import LARGEST, ShapeError, at, require
from ..rings.ends import Taper
from ..stations.cells import WIDEST_TURN
from ..stations.frames import FixedUp, turn
from ..stations.leaps import leaps
from ..stations.search import highest
from ..trajectories.arc_length import arc_length
from .laws import Constant, Law

NOTHING = 1e-7  # of the largest scale: single precision cannot tell a contour this small from a point
NEARLY = 0.01  # of the largest scale: between places so close a law that is not steep comes to zero
SHARPLY = 22  # narrowings: 1e-14 of an interval is left
SEARCHED = 4097  # places along the trajectory where a change of sign is looked for
LAWS = ("scale_x", "scale_y", "twist", "offset_x", "offset_y")


@frozen
class Along:
    """The laws of one sweep.

    Parameters
    ----------
    trajectory : Trajectory
    scale_x, scale_y, twist, offset_x, offset_y : Law
    tapers : tuple of two float
        Lengths in metres over which the contour grows from a point at the start and shrinks to one at the end; 0: none.
    spin : float
        The angle in radians that the frame adds from the start to the end: only stations ask for it.
    frame : Frenet, FixedUp or None
        A frame that turns about the tangent as the trajectory's places say: again only stations ask for it.
    change : Changing or None
        How the contour itself changes, which stands where another begins.
    rails : Rails or None
        What also scales and moves the contour, beside the laws.
    """

    trajectory: object
    scale_x: Law
    scale_y: Law
    twist: Law
    offset_x: Law = Constant(0.0)
    offset_y: Law = Constant(0.0)
    tapers: tuple = (0.0, 0.0)
    spin: float = 0.0
    frame: object = None
    change: object = None
    rails: object = None

    @cached_property
    def is_constant(self):
        still = not self.spin and self.frame is None and self.change is None and not self.trajectory.carries
        return still and all(getattr(self, key).is_constant for key in LAWS)

    @cached_property
    def keeps_legs(self):
        """Whether each straight leg has one cross-section: a level frame turns at corners, and nothing else does."""
        level = replace(self, frame=None) if isinstance(self.frame, FixedUp) else self
        return level.is_constant and not any(self.tapers)

    def unchanging(self):
        """The same for all laws whose values do not move the stations."""
        if self.is_constant:
            return replace(self, **dict.fromkeys(LAWS, Constant(1.0)))
        return replace(self, twist=Constant(0.0)) if self.twist.is_constant else self

    def at(self, s, u=None):
        """The values of `LAWS` at arc lengths, or at parameters known: five (n,), in radians and metres.

        The tapers, and the radius and the tilt of the curve itself, are in them.
        """
        measure = arc_length(self.trajectory)
        u, t = measure.parameter(s) if u is None else u, s / measure.total
        values = []
        for key in LAWS:
            law = getattr(self, key)
            with at(key):
                values.append(law.evaluate(u, t, s))
                most = 0.0 if isinstance(law, Constant) else float(np.abs(values[-1]).max(initial=0.0))
                require(most <= LARGEST, f"must be at most {LARGEST:g} in size", most)
        taper = 1.0
        for length, left in zip(self.tapers, (s, measure.total - s), strict=True):
            if length:
                taper = taper * np.clip(left / length, 0.0, 1.0)
        if self.trajectory.carries:
            radius, tilt = self.trajectory.carried(u)
            taper, values[2] = taper * radius, values[2] + tilt
        guided = self.rails and self.rails.laws(self.trajectory, u, t)
        if guided:
            scale_x, scale_y, *offset = guided
            values[0], values[1] = values[0] * scale_x, values[1] * scale_y
            values[3:] = [law + more for law, more in zip(values[3:], offset, strict=True)]
        return values[0] * taper, values[1] * taper, *values[2:]

    def marks(self):
        """Arc lengths where a station must be.

        Where tapers start, beside leaps of the frame, where there is no scale, and one between two such points.
        """
        total = left = arc_length(self.trajectory).total
        for key, length in zip(("start.length", "end.length"), self.tapers, strict=True):
            fits = length <= left + 1e-9 * total
            require(fits, f"must be at most {left:.6g}, what is left of the trajectory", length, key)
            left = max(left - length, 0.0)
        marks = [self.tapers[0], total - self.tapers[1]]
        if self.trajectory.carries:  # the radius may bend there at once
            marks.extend(arc_length(self.trajectory).at(self.trajectory.joints()))
        if self.change is not None:
            marks.extend(self.change.places * total)
        marks.extend(leaps(self.frame, self.trajectory).ravel())
        if not self.is_constant:
            points = np.sort(np.concatenate(([0.0], self.crossings(), self.touches(), [total])))
            flat = np.abs(self.at(points)[0]) <= NOTHING * self.largest
            bodies = (points[1:] + points[:-1])[flat[1:] & flat[:-1]] / 2
            marks.extend((*points, *bodies))
        return tuple(mark for mark in marks if 0.0 < mark < total)

    @cached_property
    def largest(self):
        """The largest scale anywhere along the trajectory."""
        return float(np.abs(self.everywhere()[:2]).max())

    def farthest(self, reach):
        """How far from the trajectory a contour gets that reaches so far from its reference point, in metres."""
        return reach * self.largest + float(np.hypot(*self.everywhere()[3:]).max())

    def everywhere(self):
        """The values of `LAWS` all along the trajectory, those of constant ones once: five (n,)."""
        if self.is_constant:
            return tuple(getattr(self, key).evaluate(*np.zeros((3, 1))) for key in LAWS)
        return searched(self)[1:]

    def symmetry(self, section):
        """In how many turns a section is mapped to itself as the laws leave it: a stretched one by a half at most."""
        scale_x, scale_y, _, *offset = self.everywhere()
        if np.any(offset):
            return 1
        alike = np.abs(np.abs(scale_x) - np.abs(scale_y)).max() <= ALIKE * self.largest
        if alike:
            return 1 if section.is_round else section.symmetry
        return gcd(section.symmetry, 2)

    @property
    def scaled_by(self):
        """The keys of what changes the scales along e2 and e3: the laws, or where these do not, the path's radii."""
        laws = self.scale_x, self.scale_y
        if self.rails:
            return ("rails",) * 2
        radii = self.trajectory.carries and all(law.is_constant for law in laws)
        return ("trajectory.radii",) * 2 if radii else ("scale_x", "scale_y")

    def crossings(self):
        """Arc lengths where the scale along e2 passes zero, by bisection of all of them at once."""
        s, scale, *_ = searched(self)
        positive = scale > 0
        change = np.flatnonzero(positive[1:] != positive[:-1])
        low, high = s[change], s[change + 1]
        for _ in range(50 if len(change) else 0):
            middle = (low + high) / 2
            below = (self.at(middle)[0] > 0) == positive[change]
            low, high = np.where(below, middle, low), np.where(below, high, middle)
        return high

    def touches(self):
        """Arc lengths where the scale along e2 comes to zero and does not pass it, as an absolute value does."""
        s, scale, *_ = searched(self)
        size = np.abs(scale)
        least = (size[1:-1] <= size[:-2]) & (size[1:-1] <= size[2:]) & (size[1:-1] < NEARLY * size.max())
        least &= scale[:-2] * scale[2:] > 0
        if not least.any():
            return s[:0]
        place, most = highest(lambda s: -np.abs(self.at(s)[0]), s[:-2][least], s[2:][least], SHARPLY)
        return place[most >= -NOTHING * size.max()]

    def asks(self, reach):
        """What the laws of a contour that reaches so far ask of `place` beside the samples: its marks and its extra."""
        return self.marks(), None if self.is_constant else self.density(reach)

    def density(self, reach):
        """Steps per metre that laws and frame ask for, as a function of arc length, parameter and chord tolerance.

        The outermost point of the contour, ``reach`` metres out, bends by reach * twist'^2 and reach * scale'', and
        with the reference point on its way beside the trajectory.
        """

        def steps(s, u, chord):
            scale_x, scale_y, twist, *offset = self.at(s, u)
            twist = twist + self.spin / s[-1] * s
            if self.frame is not None:
                twist += np.interp(s, *turn(self.frame, self.trajectory))
            rate, size = np.gradient(twist, s), np.maximum(np.abs(scale_x), np.abs(scale_y))
            change = np.abs(slopes((scale_x, scale_y), s)[1]).sum(axis=0)
            bend = reach * (size * rate**2 + change)
            if np.any(offset):
                bend += bend_beside(offset, twist, s)
            warp = 0.0
            if self.change is not None:
                more, warp = self.change.asked(s / s[-1])
                bend += size * more / s[-1] ** 2
                warp = size * warp / s[-1] / (4 * chord)
            return np.maximum(np.maximum(np.sqrt(bend / (8 * chord)), np.abs(rate) / WIDEST_TURN), warp)

        return steps

    def grown(self, symmetry):
        """By how many parts of a turn, of which so many are a whole one, the twist grows along a closed trajectory.

        Raises
        ------
        ShapeError
            Where they are not whole, or another law does not come back to where it began.
        """
        if self.is_constant:
            return 0
        ends = dict(zip(LAWS, self.at(np.array([0.0, arc_length(self.trajectory).total])), strict=True))
        begun, ended = ends.pop("twist")
        farthest = float(np.abs(self.everywhere()[3:]).max())
        for key, (first, last) in ends.items():
            same = abs(last - first) <= 1e-9 * (self.largest if key in ("scale_x", "scale_y") else farthest)
            require(same, f"must be the same at both ends of a closed trajectory, {first:g}", float(last), key)
        turns = (ended - begun) / (2 * np.pi)
        whole = round(turns * symmetry)
        if abs(turns - whole / symmetry) > 1e-9:
            step = f"multiples of 1/{symmetry} turn" if symmetry > 1 else "whole turns"
            raise ShapeError(f"must grow by {step} along a closed trajectory, got {turns:.9g} turns", "twist")
        return whole


def tapers(start, end):
    """The lengths of two ends that taper to a point, 0 where they do not."""
    return tuple(end.length if isinstance(end, Taper) else 0.0 for end in (start, end))


@lru_cache(maxsize=16)
def searched(along):
    """Arc lengths all along the trajectory, and the values of the laws there: six (n,) float arrays."""
    s = np.linspace(0.0, arc_length(along.trajectory).total, SEARCHED)
    return s, *along.at(s)


def slopes(values, s):
    """The first and the second derivative of rows of values by differences, no second one where it is rounding."""
    first = np.gradient(values, s, axis=-1)
    second = np.gradient(first, s, axis=-1)
    second[np.abs(second) * s[-1] ** 2 < 1e-4 * np.abs(values).max()] = 0.0
    return first, second


def bend_beside(offset, twist, s):
    """How much the way of a point bends that is moved off a straight trajectory and turned about it: (n,) in 1/m.

    The point is o exp(i twist) at height s, and its acceleration counts as far as it is across its velocity.
    """
    rates, changes = slopes(offset, s)
    place, moving, swerving = ((1, 1j) @ np.array(pair) for pair in (offset, rates, changes))
    turning, spinning = slopes(twist, s)
    velocity = moving + 1j * place * turning
    acceleration = swerving + 2j * moving * turning + (1j * spinning - turning**2) * place
    along = (acceleration * velocity.conj()).real ** 2 / (1 + np.abs(velocity) ** 2)
    return np.sqrt(np.maximum(np.abs(acceleration) ** 2 - along, 0.0))


def tips(scale_x, scale_y, largest, closed, keys=("scale_x", "scale_y")):
    """Where the contour is a point: a (n,) bool array; and whether it is mirrored. The keys name what scales it.

    Raises
    ------
    ShapeError
        Where the contour is a line, changes its side, jumps over zero or is a point along a stretch.
    """
    if min(scale_x.min(), scale_y.min()) > NOTHING * largest:  # as nearly always
        return np.full(len(scale_x), False), False
    x, y = (np.where(np.abs(scale) > NOTHING * largest, np.sign(scale), 0.0) for scale in (scale_x, scale_y))
    require(x.any(), "must not be 0 everywhere", 0, "scale_x")
    following = np.roll(x, -1)
    following[-1] = x[0] if closed else x[-2]
    side = x * y
    first = side[np.argmax(side != 0)]
    for key, sentence, wrong in (
        ("scale_x", "must not be 0 where scale_y is not", (x == 0) & (y != 0)),
        ("scale_y", "must not be 0 where scale_x is not", (y == 0) & (x != 0)),
        ("scale_y", "must not change its sign against scale_x", side * first < 0),
        ("scale_x", "must not stay 0 along a stretch", (x == 0) & (following == 0)),
        ("scale_x", "must reach 0 where it changes its sign", x * following < 0),
    ):
        if wrong.any():
            contour = int(np.argmax(wrong))
            got = (scale_x if key == "scale_x" else scale_y)[contour]
            raise ShapeError(f"{sentence}, got {got:.6g} at contour {contour + 1}", keys[key == "scale_y"])
    return x == 0, bool(first < 0)

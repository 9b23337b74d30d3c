# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Straight legs whose corners may be cut off: a chain of straight pieces and exact arcs."""

from functools import cached_property

import numpy as np

from ..declared.frozen import frozen, individual
from ..declared.parameters import Array
from ..vectors import norms, unit
from .curve import NONE, SAME_DIRECTION, Trajectory, row

NOTHING = 1e-12  # of a leg: where two corners meet, rounding leaves no more of it


class Legs(Trajectory):
    """Legs from point to point; u counts the points, and on what is left of a leg runs evenly.

    Where a corner is cut off, its number is the middle of what stands there instead. A kind gives `points` and
    `closed`, and in metres the `setbacks` of its corners, what each takes from both its legs.
    """

    setbacks = NONE
    rounded = False

    @property
    def straight(self):
        return not (self.rounded and self.setbacks.values.any())

    @cached_property
    def legs(self):
        """The vector of each leg: (k, 3) float array."""
        corners = self.points.values
        return np.diff(np.concatenate((corners, corners[:1])) if self.closed else corners, axis=0)

    @cached_property
    def lengths(self):
        """The length of each leg in metres: (k,) float array."""
        return norms(self.legs)

    @cached_property
    def directions(self):
        """Unit vectors along the legs before and after each point, (n, 3) and (n, 3); at an open end they are one."""
        legs = unit(self.legs)
        if self.closed:
            return np.roll(legs, 1, axis=0), legs
        return np.concatenate((legs[:1], legs)), np.concatenate((legs, legs[-1:]))

    @cached_property
    def turns(self):
        """The angle in radians by which the path turns at each point, 0 where it does not: (n,) float array."""
        before, after = self.directions
        turns = 2 * np.arctan2(norms(after - before), norms(after + before))
        return np.where(turns > SAME_DIRECTION, turns, 0.0)

    @property
    def ends(self):
        """Indices of the points where each leg starts and ends: (k,) and (k,)."""
        start = np.arange(len(self.legs))
        return start, (start + 1) % len(self.points)

    @property
    def domain(self):
        return 0.0, float(len(self.legs))

    def joints(self):
        return np.append(self.pieces.start, self.domain[1])

    def stops(self):
        joints = self.joints()[1:-1]
        return np.union1d(self.corners(), joints[joints % 1 > 0]) if self.rounded else self.corners()

    def between(self, values, u):
        values = np.append(values, values[:1]) if self.closed else values
        return np.interp(u, np.arange(len(values)), values)

    @cached_property
    def pieces(self):
        return pieces(self)

    def evaluate(self, u):
        return self.pieces.evaluate(row(u))

    def derivative(self, u, order=1, before=False):
        return self.pieces.derivative(row(u), order, before)


@frozen
class Cut(Legs):
    """Legs with a short one across some of their corners, for a `Mitre` beyond its limit.

    The contour reaches so far, in metres, that the setback over it is by how much the rings of a bevel lean.
    """

    points: Array
    closed: bool = False
    setbacks: Array = NONE
    reach: float = 1.0
    radii: Array = NONE
    tilts: Array = NONE


@individual
class Pieces:
    """Straight pieces and arcs, one after the other.

    Parameters
    ----------
    start : (k,) float array
        The parameter where each piece starts.
    zero, width : (k,) float array
        The parameter at its origin, which may be its end, and how much of the parameter it takes.
    origin, step : (k, 3) float array
        A straight piece goes by its step.
    turn : (k,) float array
        An arc turns by an angle in radians.
    normal, tangent : (k, 3) float array
        From an arc's origin to its centre, and as long along it; zero for a straight piece.
    """

    start: np.ndarray
    zero: np.ndarray
    width: np.ndarray
    origin: np.ndarray
    step: np.ndarray
    turn: np.ndarray
    normal: np.ndarray
    tangent: np.ndarray

    @cached_property
    def whole(self):
        """Whether every leg is one piece."""
        return bool((self.width == 1).all())

    @cached_property
    def curved(self):
        """Whether there is an arc among the pieces."""
        return bool(self.turn.any())

    @cached_property
    def pace(self):
        """The derivative of each piece that is straight: (k, 3) float array."""
        return self.step / self.width[:, None]

    def piece(self, u, before=False):
        """Which piece each parameter is on."""
        if self.whole:
            piece = (np.ceil(u) - 1 if before else np.floor(u)).astype(int)
        else:
            piece = np.searchsorted(self.start, u, side="left" if before else "right") - 1
        return piece.clip(0, len(self.start) - 1)

    def evaluate(self, u):
        piece = self.piece(u)
        along = (u - self.zero[piece]) / self.width[piece]
        points = self.origin[piece] + along[:, None] * self.step[piece]
        if not self.curved:
            return points
        angle = (along * self.turn[piece])[:, None]
        height = 2 * np.sin(angle / 2) ** 2  # 1 - cos, which would lose a gentle arc to rounding
        return points + height * self.normal[piece] + np.sin(angle) * self.tangent[piece]

    def derivative(self, u, order, before):
        piece = self.piece(u, before)
        rate = self.pace[piece] if order == 1 else np.zeros((len(piece), 3))
        if not self.curved:
            return rate
        speed = self.turn[piece] / self.width[piece]
        phase = ((u - self.zero[piece]) * speed + order * np.pi / 2)[:, None]
        bent = np.sin(phase) * self.tangent[piece] - np.cos(phase) * self.normal[piece]
        return rate + speed[:, None] ** order * bent


def pieces(path):
    """The `Pieces` of legs: of each half of what stands for the corner behind it, itself, and half of the next one."""
    legs, points, number = path.legs, path.points.values, np.arange(len(path.legs), dtype=float)
    flat, straight = np.zeros_like(legs), np.zeros(len(legs))
    if not path.setbacks.values.any():
        return Pieces(number, number, straight + 1, points[: len(legs)], legs, straight, flat, flat)

    start, end = path.ends
    behind, ahead = path.setbacks.values[np.stack((start, end))] / path.lengths
    left = 1 - behind - ahead
    leg = points[start] + behind[:, None] * legs, left[:, None] * legs, straight, flat, flat
    corners = replacements(path)
    rows = (
        (number, number, behind, *(part[start] for part in corners)),
        (number + behind, number + behind, left, *leg),
        (number + 1 - ahead, number + 1, ahead, *(part[end] for part in corners)),
    )
    fields = [np.stack(field, axis=1).reshape(-1, *field[0].shape[1:]) for field in zip(*rows, strict=True)]
    there = fields[2] > NOTHING
    return Pieces(*(field[there] for field in fields))


def replacements(path):
    """What stands for each point: its middle, and from there on half of a short leg or of an arc.

    Returns
    -------
    middle, step : (n, 3) float array
    half : (n,) float array
    normal, tangent : (n, 3) float array
        The origin, step, turn, normal and tangent of a piece.
    """
    before, after = path.directions
    half, setback = path.turns / 2, path.setbacks.values
    inward, along = unit(after - before), unit(after + before)
    if not path.rounded:
        middle = path.points.values + (setback * np.sin(half))[:, None] * inward
        none = np.zeros_like(middle)
        return middle, (setback * np.cos(half))[:, None] * along, none[:, 0], none, none
    radius = setback / np.tan(np.where(half, half, 1.0))
    middle = path.points.values + (setback * np.tan(half / 2))[:, None] * inward
    return middle, np.zeros_like(middle), half, radius[:, None] * inward, radius[:, None] * along

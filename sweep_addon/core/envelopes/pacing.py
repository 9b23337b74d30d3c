# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pacing: where circles stand on balls that grow and shrink, by how far they go and by how they lean.

Along the surface a circle goes on by cos(lean) in a metre, less what the lean takes back, r times its rate, and in that
the surface bends by the rate. Beside a limit, where circles become points, they shrink as a square root does.
"""

from functools import lru_cache

import numpy as np

from ..declared.frozen import individual
from ..stations.cells import WIDEST_TURN, chord_angle
from ..stations.sampling import Tolerance
from .balls import UPRIGHT

CLOSE = 16  # circles at most that stand close to a limit
GRADES = (np.arange(1, 9) / 8) ** 2  # of a cell: a square root is straight from one to the next
LEAST = 0.25  # of the way without what the lean takes back: beside where nothing is left of it, it changes quickly
STILL = 1e-9  # of the way: where balls are swallowed nothing goes on


@individual
class Pace:
    """What cells of a trajectory ask for.

    Parameters
    ----------
    s : (n + 1,) float array
        Arc lengths between them.
    lean : (n,) float array
        By how many radians circles lean more at the end of each than at its start, kinks left out.
    radius, cosine : (n,) float array
        In the middle of each.
    swallowed : (n,) bool array
    """

    s: np.ndarray
    lean: np.ndarray
    radius: np.ndarray
    cosine: np.ndarray
    swallowed: np.ndarray

    @property
    def way(self):
        """Arc lengths, and how far it is to each in metres with what circles go round on their balls: (2, n + 1)."""
        onward = np.where(self.swallowed, STILL, 1.0) * np.diff(self.s) + self.radius * np.abs(self.lean)
        return np.stack((self.s, np.concatenate(([0.0], np.cumsum(onward)))))

    def density(self, s, u, chord):
        """Steps per metre that a tolerance asks for at arc lengths: (n,), the more of both sides of each."""
        rate = self.lean / np.maximum(np.diff(self.s), 1e-300)
        onward = self.cosine * rate
        bent = np.maximum(np.abs(onward - self.radius * rate**2), LEAST * np.abs(onward))
        asked = np.maximum(np.sqrt(bent / (8 * chord)), np.abs(rate) / WIDEST_TURN)
        before, after = (
            (np.searchsorted(self.s, s, side=side) - 1).clip(0, len(rate) - 1) for side in ("left", "right")
        )
        return np.maximum(asked[before], asked[after])


@lru_cache(maxsize=16)
def pace(balls):
    """The pace of circles on balls."""
    cells = np.diff(balls.u)[(np.searchsorted(balls.u, balls.limits) - 1).clip(0, len(balls.u) - 2), None]
    close = (balls.limits[:, None] + np.concatenate((-GRADES, GRADES)) * cells).ravel()
    close = close[(close > balls.u[0]) & (close < balls.u[-1])]
    u = np.unique(np.concatenate((balls.u, balls.limits, close)))
    s = balls.measure.at(u) if len(close) else balls.s
    radius = balls.radius(u, s)
    first, last = balls.lean(u[:-1], s[:-1]), balls.lean(u[1:], s[1:], before=True)
    lean = last - first
    if len(balls.kinks):
        lean[(np.searchsorted(u, balls.kinks.mean(axis=1)) - 1).clip(0, len(lean) - 1)] = 0.0
    swallowed = (np.abs(first) == UPRIGHT) & (np.abs(last) == UPRIGHT)
    return Pace(s, lean, (radius[1:] + radius[:-1]) / 2, np.cos((first + last) / 2), swallowed)


def marks(balls, samples):
    """Arc lengths where a circle must stand: breaks, points, limits; one between two points; some near limits."""
    if balls.is_constant:
        return ()
    ends = np.unique(np.concatenate((balls.trajectory.domain, balls.points, balls.limits, balls.breaks)))
    point = np.isin(ends, balls.limits) | (balls.radius(ends) == 0)
    between = (ends[1:] + ends[:-1])[point[1:] & point[:-1]] / 2
    found = balls.measure.at(np.concatenate((ends, between)))
    if isinstance(samples, Tolerance):
        found = np.concatenate((found, near_limits(balls, samples.chord)))
    return tuple(mark for mark in found.tolist() if 0.0 < mark < balls.measure.total)


def near_limits(balls, chord):
    """Arc lengths beside limits, no farther than the next cells, where circles lean by steps of a tolerance."""
    s, radius = balls.measure.at(balls.limits), balls.radius(balls.limits)
    step = np.minimum(chord_angle(chord, np.where(radius > 0, radius, 1.0)), WIDEST_TURN)
    change = np.maximum(np.abs(balls.slopes(balls.limits)[1]), 1e-300)
    lean = step * np.arange(1, CLOSE + 1)[:, None]
    aside = lean**2 / (2 * change)  # the square of cos(lean) is twice the change times the way
    near = (lean < UPRIGHT / 2) & (aside < 2 * balls.measure.total / len(balls.u))
    found = np.concatenate(((s + aside)[near], (s - aside)[near]))
    found = found[(found > 0) & (found < balls.measure.total)]
    return found[~balls.swallowing(balls.measure.parameter(found), found)]

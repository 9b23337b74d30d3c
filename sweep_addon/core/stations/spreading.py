# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spreading: arc lengths at even distances, or as few as keep the chords between them near the curve."""

import numpy as np

from ..declared.parameters import require
from .cells import RESERVE, cells
from .sampling import MOST_STATIONS

FLOOR = 0.05  # of the mean density, so that no step grows without bound where the curvature vanishes
ROUNDS = 30  # two or three are usual


def fewest(trajectory):
    """Steps that a tube cannot do without: a closed one of two would lie on itself."""
    return 3 if trajectory.closed else 1


def distinct(values, least):
    """Values in rising order, those dropped that are within a distance of the one before."""
    values = np.sort(values)
    return values[np.concatenate(([True], np.diff(values) > least))]


def spread_evenly(ends, steps, way=None):
    """Arc lengths with a number of steps shared out among the pieces between the ends by their lengths.

    The lengths may be measured in another way, (2, n): at rising arc lengths, how far it is to each.
    """
    at_ends = ends if way is None else np.interp(ends, *way)
    lengths = np.diff(at_ends)

    def arc_lengths(piece, fraction):
        along = at_ends[piece] + fraction * lengths[piece]
        return along if way is None else np.interp(along, *way[::-1])

    return pieces(ends, shared_out(steps, lengths), arc_lengths)


def shared_out(steps, lengths):
    """Whole numbers in proportion to lengths, at least 1 each, that add up to the steps wherever those suffice."""
    fair = lengths / lengths.sum() * steps
    shares = np.maximum(1, np.floor(fair)).astype(int)
    missing = max(steps, len(shares)) - shares.sum()
    while missing:  # a few rounds: those farthest from their fair share first
        side = np.sign(missing)
        able = np.flatnonzero((shares > 1) | (side > 0))
        first = able[np.argsort(side * (shares - fair)[able], kind="stable")][: abs(missing)]
        shares[first] += side
        missing -= side * len(first)
    return shares


def spread(trajectory, ends, chord, extra):
    """Arc lengths whose chords keep the tolerance, as few as that takes.

    A chord of length h over curvature k is k h^2 / 8 away from the curve: equal distances need steps as 1 / sqrt(k).
    That is not enough where the curvature begins within a step, from nothing at an inflection or at once behind a
    straight piece. Steps that are too long so are found, and more is asked for there.
    """
    grid, asked, squares = cells(trajectory, chord, extra)
    for _ in range(ROUNDS):
        s = equalized(trajectory, ends, chord, grid, asked)
        away = farthest(grid, squares, s)
        if away.max() <= 1:
            break
        asked = asked * seen_from(grid, s, np.sqrt(np.where(away > 1, away / RESERVE, 1.0)))
    return s


def farthest(grid, squares, s):
    """How far from each chord between arc lengths the curve can be, in tolerances: (n - 1,).

    It is farthest if it always bends to the same side, in one plane: as the curve over s whose second derivative is the
    curvature, which is farthest from its chord where its slope is the chord's.

    Parameters
    ----------
    grid, squares : (k + 1,) and (k,) float array
        Arc lengths between cells, and how far one chord over each would be from the curve.
    s : (n,) float array
    """
    width = np.diff(grid)
    bend = 8 * squares / width**2
    slope = np.concatenate(([0.0], np.cumsum(bend * width)))
    height = np.concatenate(([0.0], np.cumsum((slope[1:] + slope[:-1]) / 2 * width)))

    def curve(s):
        cell = np.searchsorted(grid[1:-1], s, side="right")
        ahead = s - grid[cell]
        return height[cell] + (slope[cell] + bend[cell] / 2 * ahead) * ahead

    ends = curve(s)
    rise = np.diff(ends) / np.diff(s)
    place = np.interp(rise, slope, grid).clip(s[:-1], s[1:])
    return ends[:-1] + rise * (place - s[:-1]) - curve(place)


def seen_from(grid, s, values):
    """The largest of the values (n - 1,) of the steps between arc lengths s that meet each cell of a grid: (k,)."""
    first, end = np.searchsorted(s, grid[:-1], side="right") - 1, np.searchsorted(s, grid[1:])
    return np.maximum.reduceat(np.append(values, 0.0), np.column_stack((first, end)).ravel())[::2]


def equalized(trajectory, ends, chord, grid, asked):
    """Arc lengths between which steps are equal parts of what the cells of a grid ask for.

    A straight piece between two ends is one step whatever the floor.
    """
    mean = asked.sum() / grid[-1]
    needed, reached = (
        np.concatenate(([0.0], np.cumsum(steps))) for steps in (asked, np.maximum(asked, FLOOR * mean * np.diff(grid)))
    )
    at_ends = np.interp(ends, grid, reached)
    wanted = np.diff(np.interp(ends, grid, needed))
    wanted = np.where(wanted > 1, np.diff(at_ends), wanted)
    steps = np.maximum(-(-fewest(trajectory) // len(wanted)), np.ceil(wanted - 1e-9))
    most = f"must be larger, or the sweep turn less: it needs {steps.sum():,.0f} contours of {MOST_STATIONS:,} at most"
    require(steps.sum() <= MOST_STATIONS, most, chord, "samples.chord")
    steps = steps.astype(np.int64)

    def arc_lengths(piece, fraction):
        return np.interp(at_ends[piece] + fraction * np.diff(at_ends)[piece], reached, grid)

    def evenly(piece, fraction):
        return ends[piece] + fraction * np.diff(ends)[piece]

    return pieces(ends, steps, arc_lengths if mean > 0 else evenly)


def pieces(ends, steps, arc_lengths):
    """All stations of all pieces, each cut into its number of steps; the ends themselves are exact."""
    first = np.cumsum(steps) - steps
    piece = np.repeat(np.arange(len(steps)), steps) if len(steps) > 1 else np.zeros(1, int)
    within = np.arange(steps.sum()) - first[piece]
    s = arc_lengths(piece, within / steps[piece])
    s[first] = ends[:-1]
    return np.append(s, ends[-1])

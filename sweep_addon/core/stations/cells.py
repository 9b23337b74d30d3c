# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cells: small pieces of a trajectory, and how many steps each asks for, by its bends and by what the contour does."""

import numpy as np

from ..later import later
from ..vectors import dot, norms
from .search import GOLDEN

arc_length, subdivided = later("core.trajectories.arc_length", "arc_length", "subdivided")

WIDEST_TURN = np.radians(30)  # a twist in one step; more looks broken at any tolerance
WIDEST_BEND = np.radians(60)  # a bend in one step, so that a circle is a hexagon at least
CELLS = 2048  # at least, in which the curvature is looked at
PARTS = (1, 3, 9, 27, 81)  # into which a cell is cut, until a law is seen that changes often
SPARSE = 3  # cells for one place that shows whether they see a law
SEEN, FEW = 0.1, 4.0  # a law is seen where those ask for no more steps than so, as a part or in all, more or less
RESERVE = 0.98  # of the tolerance, for what the curvature changes within a step
NOISE = 64 * np.finfo(float).eps  # of the largest derivative: the rounding of any
ROUNDING = 1e-13  # of the length: differences over less are noise


def chord_angle(chord, radius):
    """The angle in radians of a chord whose middle is so far from the circle of a radius, at most half a turn."""
    return 4 * np.arcsin(np.sqrt(np.minimum(chord / radius, 1.0) / 2))


def cells(trajectory, chord, extra):
    """Small cells of a trajectory, and what each asks for.

    Returns
    -------
    grid : (k + 1,) float array
        Arc lengths between the cells, from 0 to the whole.
    steps : (k,) float array
        The steps that each cell asks for: so many that chords are a little nearer than they must be.
    squares : (k,) float array
        How far one chord over each cell would be from the curve, in tolerances.

    A cell bends as the more bent one of its ends, so that no chord is too far away; but where that is a peak, as beside
    a cusp, by no more than half a turn.
    """
    measure = arc_length(trajectory)
    u = cut(measure)
    width = measure.measure(u[:-1], u[1:])
    kept = width > ROUNDING * measure.total  # a trajectory may stand still
    width, u = width[kept], np.stack((u[:-1], u[1:]))[:, kept]
    grid = np.concatenate(([0.0], np.cumsum(width)))
    grid[-1] = measure.total
    turns = [norms(bend(trajectory, u[end], end == 1)) * width for end in (0, 1)]
    turn = np.minimum(np.maximum(*turns), np.maximum(np.minimum(*turns), np.pi))
    squares = turn * width / (8 * chord)
    steps = np.maximum(np.sqrt(squares / RESERVE), turn / WIDEST_BEND)
    return (grid, steps, squares) if extra is None else refined(grid, u, steps, squares, extra, RESERVE * chord)


def cut(measure):
    """Parameters that cut a trajectory into `CELLS` or more, each within one piece of it: (k + 1,)."""
    return subdivided(measure.nodes, -(-CELLS // (len(measure.nodes) - 1)))


def refined(grid, u, steps, squares, extra, chord):
    """Cells cut into equal parts until what is asked for in addition is seen, and what each part asks for.

    A law may change so often that cells miss it. It is seen when fewer places elsewhere ask for as many steps.

    Parameters
    ----------
    grid : (k + 1,) float array
        Arc lengths between the cells.
    u : (2, k) float array
        The parameters at the start and at the end of each.
    steps, squares : (k,) float array
        What the trajectory's bends ask for.
    """
    for parts in PARTS:
        s = subdivided(grid, parts)
        within = u[0, :, None] + (u[1] - u[0])[:, None] * (np.arange(parts) / parts)
        inner = np.append(within.ravel(), u[1, -1])
        asked = needed(extra, s, inner, chord)
        some = needed(extra, *aside(s, inner), chord)
        missed = abs(some.sum() - asked.sum())
        if missed <= max(SEEN * asked.sum(), FEW):
            break
    steps, squares = np.repeat(steps / parts, parts), np.repeat(squares / parts**2, parts)
    return s, np.hypot(steps, asked), squares + RESERVE * asked**2


def aside(s, u):
    """Fewer places, spaced unevenly: an even spacing can be in time with a law that repeats itself.

    Multiples of the golden section, whole numbers left out, are in time with nothing.
    """
    first = np.arange(0, len(s) - 1, SPARSE)
    part = first * GOLDEN % 1
    return (np.append(x[first] + part * (x[first + 1] - x[first]), x[-1]) for x in (s, u))


def needed(extra, s, u, chord):
    """The steps that a density asks for between places, where it is the larger one of both ends: (k - 1,)."""
    density = extra(s, u, chord)
    return np.maximum(density[1:], density[:-1]) * np.diff(s)


def bend(trajectory, u, before=False, first=None, second=None):
    """Curvature vectors (n, 3) in 1/m: the part of p'' across p', over |p'| squared; all of it at an even pace.

    Where p' nearly vanishes, as beside a Bezier knot whose handle lies on it, rounding turns it, and with it a part of
    p'' across: what is no more than that is no bend. Derivatives are computed unless given.
    """
    second = trajectory.derivative(u, 2, before) if second is None else second
    if trajectory.pace:
        return second / trajectory.pace**2
    first = trajectory.derivative(u, 1, before) if first is None else first
    squared = dot(first, first)
    squared = np.where(squared > 0, squared, np.inf)
    across = second - (dot(first, second) / squared)[:, None] * first
    noise = (NOISE * np.abs(first).max(initial=0.0)) ** 2 * dot(second, second) / squared
    across[dot(across, across) <= noise] = 0.0
    return across / squared[:, None]

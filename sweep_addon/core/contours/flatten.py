# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattening: cubic Bezier segments, in the plane or in space, become chords within a tolerance."""

import numpy as np

from ..declared.parameters import require
from ..vectors import dot
from .outline import MOST_POINTS

STEEPEST = np.radians(7.5)  # between a chord and the curve at its ends: two chords in a row turn by at most twice that
SHORT = 1 / 8  # of the tolerance: a turn within a shorter chord is a corner
ROUNDING = 1e-9  # a count must not hang on a last bit


def flatten_cubics(control, tolerance):
    """Points on cubic Bezier segments, with chords that keep a tolerance and turn by at most 15 degrees.

    Parameters
    ----------
    control : (n, 4, d) float array
        The control points of each segment, d = 2 or 3, in metres.
    tolerance : float
        Largest distance of a segment from its chords, in metres.

    Returns
    -------
    points : (m, d) float array
        From the start of each segment to before its end: segments that follow each other share no point twice.
    first : (n,) int array
        The index of each segment's start among the points.

    Raises
    ------
    ShapeError
        For a tolerance that gives more than 200,000 points.

    A turn that takes place within an eighth of the tolerance is taken for a corner.

    Examples
    --------
    >>> points, first = flatten_cubics(np.array([[(0.0, 0.0), (0.0, 1.0), (1.0, 2.0), (2.0, 2.0)]]), tolerance=0.1)
    >>> points[first].tolist()
    [[0.0, 0.0]]
    """
    segment, t = cubic_parameters(control, tolerance)
    return evaluate_cubics(control, segment, t), np.searchsorted(segment, np.arange(len(control)))


def cubic_parameters(control, tolerance):
    """Where `flatten_cubics` takes its points, as (m,) segments and (m,) parameters from 0 to below 1.

    The second derivative bounds the distance to the chords of equal steps, and so their number; steps that turn too
    much are then halved, all at once.
    """
    bend = np.linalg.norm(np.diff(control, n=2, axis=1), axis=2).max(axis=1, initial=0.0)
    count = np.maximum(np.ceil(np.sqrt(0.75 * bend / tolerance) - ROUNDING), 1)
    require_few(count.sum())
    count = count.astype(int)
    segment = np.repeat(np.arange(len(control)), count)
    t = (np.arange(len(segment)) - np.repeat(np.cumsum(count) - count, count)) / count[segment]
    while (steep := steep_chords(control, segment, t, tolerance)).any():
        require_few(len(t) + steep.sum())
        segment, t = halved(segment, t, steep)
    return segment, t


def require_few(points):
    sentence = f"must be large enough to give at most {MOST_POINTS} points"
    require(points <= MOST_POINTS, sentence, float(points), "tolerance")


def halved(segment, t, which):
    """Parameters with the middle of those steps added that (m,) bools choose."""
    middle = (t[which] + step_ends(segment, t)[which]) / 2
    segment, t = np.append(segment, segment[which]), np.append(t, middle)
    order = np.lexsort((t, segment))
    return segment[order], t[order]


def step_ends(segment, t):
    return np.where(np.append(segment[1:] != segment[:-1], True), 1.0, np.append(t[1:], 1.0))


def steep_chords(control, segment, t, tolerance):
    """(m,) bool array: which chords, unless short, differ too much in direction from the curve at one of their ends."""
    end = step_ends(segment, t)
    chord = evaluate_cubics(control, segment, end) - evaluate_cubics(control, segment, t)
    steep = np.zeros(len(t), dtype=bool)
    for at in (t, end):
        tangent = cubic_tangents(control, segment, at)
        along = dot(chord, tangent)
        squares = dot(chord, chord) * dot(tangent, tangent)
        steep |= along < np.cos(STEEPEST) * (1 - ROUNDING) * np.sqrt(squares)
    return steep & (np.linalg.norm(chord, axis=1) > SHORT * tolerance)


def evaluate_cubics(control, segment, t):
    """(m, d) float array: points on (m,) segments at (m,) parameters."""
    t, s = t[:, None], 1 - t[:, None]
    a, b, c, d = control[segment].swapaxes(0, 1)
    return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d


def cubic_tangents(control, segment, t):
    """(m, d) float array: directions of (m,) segments at (m,) parameters, of any length.

    At an end whose control point coincides with it the direction is that to the next control point that does not.
    """
    a, b, c, d = control.swapaxes(0, 1)
    start = first_nonzero(b - a, c - a, d - a)[segment]
    end = first_nonzero(d - c, d - b, d - a)[segment]
    t, s = t[:, None], 1 - t[:, None]
    between = s * s * (b - a)[segment] + 2 * s * t * (c - b)[segment] + t * t * (d - c)[segment]
    return np.where(t == 0, start, np.where(t == 1, end, between))


def first_nonzero(*vectors):
    """Of several (n, d) arrays, row by row, the first that is not zero."""
    found = vectors[-1]
    for candidates in vectors[-2::-1]:
        found = np.where(candidates.any(axis=1, keepdims=True), candidates, found)
    return found


def cubics_from_lines(ends):
    """(n, 2, d) ends of straight lines as the (n, 4, d) control points of equal cubics."""
    start, end = np.asarray(ends, dtype=float).swapaxes(0, 1)
    return np.stack([start, start + (end - start) / 3, end - (end - start) / 3, end], axis=1)


def cubics_from_quadratics(control):
    """(n, 3, d) control points of quadratic Bezier segments as the (n, 4, d) control points of equal cubics."""
    a, b, c = np.asarray(control, dtype=float).swapaxes(0, 1)
    return np.stack([a, a + 2 / 3 * (b - a), c + 2 / 3 * (b - c), c], axis=1)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Circular arcs given by their bulge, the tangent of a quarter of the angle, positive where the path turns left.

All functions take edges as arrays: ``start`` and ``end`` (n, 2) and ``bulges`` (n,), of which 0 is a straight line.
"""

import numpy as np

STEEPEST = np.radians(30)  # the most that one chord turns
ROUNDING = 1e-9  # a count must not hang on a last bit


def apexes(start, end, bulges):
    """(n, 2) float array: the middle of each arc. Its height over the chord is half the chord times the bulge."""
    x, y = (end - start).T
    return (start + end) / 2 + bulges[:, None] / 2 * np.stack([y, -x], axis=1)


def chords(start, end, bulges, tolerance):
    """(n,) int array: the chords each arc needs to stay within a distance of it, and to turn by at most 30 degrees.

    Examples
    --------
    >>> chords(np.zeros((2, 2)), np.ones((2, 2)), np.array([0.0, 1.0]), tolerance=1.0).tolist()
    [1, 6]
    """
    angle = np.abs(4 * np.arctan(bulges))
    straight = bulges == 0
    curvature = 4 * np.abs(bulges) / (1 + bulges**2) / np.where(straight, 1, np.hypot(*(end - start).T))
    step = 4 * np.arcsin(np.sqrt(np.minimum(tolerance * curvature, 1) / 2))  # the cosine of flat arcs would round to 1
    step = np.where(straight, STEEPEST, np.minimum(step, STEEPEST))
    count = np.divide(angle, step, out=np.zeros_like(angle), where=step > 0)
    return np.maximum(np.ceil(count - ROUNDING), 1).astype(int)


def arc_points(start, end, bulges, count):
    """Points on the arcs at equal angles, from the start of each to before its end.

    Parameters
    ----------
    count : (n,) int array
        Points of each arc.

    Returns
    -------
    (count.sum(), 2) float array

    Turned by half the angle left to go and shortened, the chord reaches the arc: the inscribed angle theorem.

    Examples
    --------
    >>> half = arc_points(np.array([[1.0, 0.0]]), np.array([[-1.0, 0.0]]), np.array([1.0]), np.array([2]))
    >>> half.round(9).tolist()
    [[1.0, 0.0], [0.0, 1.0]]
    """
    edge = np.repeat(np.arange(len(count)), count)
    within = np.arange(len(edge)) - np.repeat(np.cumsum(count) - count, count)
    half = 2 * np.arctan(bulges)[edge]
    done = half * within / count[edge]
    ratio = np.sin(done) / np.where(within > 0, np.sin(half), 1)
    chord = (end - start)[edge]
    x = np.cos(done - half) * chord[:, 0] - np.sin(done - half) * chord[:, 1]
    y = np.sin(done - half) * chord[:, 0] + np.cos(done - half) * chord[:, 1]
    return start[edge] + ratio[:, None] * np.stack([x, y], axis=1)


def segments(start, end, bulges):
    """(n,) float array: the area between each arc and its chord, to the right of the chord positive.

    Examples
    --------
    >>> segments(np.array([[1.0, 0.0]]), np.array([[-1.0, 0.0]]), np.array([1.0])).round(6).tolist()
    [1.570796]
    """
    angle = 4 * np.arctan(bulges)
    series = angle**3 / 6 * (1 - angle**2 / 20 + angle**4 / 840)  # where the difference would cancel
    excess = np.where(np.abs(angle) < 0.04, series, angle - np.sin(angle))
    radius = np.hypot(*(end - start).T) * (1 + bulges**2) / (4 * np.where(bulges == 0, 1, bulges))
    return radius**2 / 2 * excess


def tangent_turns(start, end, bulges, following):
    """(n,) float array: the angle in radians by which the outline turns where each edge starts, left is positive.

    The directions at both ends of an arc differ from its chord's by half its angle.
    """
    chord = end - start
    direction = np.arctan2(chord[:, 1], chord[:, 0])
    half = 2 * np.arctan(bulges)
    turns = np.empty(len(start))
    turns[following] = (direction - half)[following] - (direction + half)
    return (turns + np.pi) % (2 * np.pi) - np.pi

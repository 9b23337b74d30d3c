# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Neighbours: how a curve known by points goes through each of them, as the points around it tell."""

import numpy as np

from ..vectors import unit

MOST = 7  # points whose polynomial is differentiated
TRUSTED = (0.1, 0.025)  # the part of a tangent that two more points may change; beyond twice that they are not heard
SLOWEST = 0.5  # of the chord's speed; less is a point where the curve turns back


def derivatives(points, closed):
    """First and second derivatives by the chord length at each point, (n, 3) and (n, 3), and its knots.

    The polynomial through a point and one neighbour on each side is corrected by the next two and by two more, in
    Newton's form, as long as the corrections are small: on a smooth curve the error is of sixth order, and points with
    noise, gaps or sharp turns are joined by parabolas, which overshoot least. Where the curve turns back on itself it
    would stop: it is given a speed, and makes a hairpin.

    Parameters
    ----------
    points : (n, 3) float array
        No two that follow each other the same.
    closed : bool

    Returns
    -------
    first, second : (n, 3) float array
    knots : (n,) float array, or (n + 1,) of a closed curve
        The length of the chords up to each point.
    """
    size = len(points)
    chords = np.diff(points, axis=0, append=points[:1]) if closed else np.diff(points, axis=0)
    knots = np.concatenate(([0.0], np.cumsum(np.linalg.norm(chords, axis=1))))
    here = np.arange(size)[:, None]
    if closed:
        near = here + np.array([0, -1, 1, -2, 2, -3, 3])
    else:
        near = np.clip(here - MOST // 2, 0, max(size - MOST, 0)) + np.arange(min(MOST, size))
        near = np.take_along_axis(near, np.argsort(np.abs(near - here), axis=1, kind="stable"), axis=1)
    away = knots[near % size] + near // size * knots[-1] - knots[:size, None]
    found, *corrections = corrected(away, points[near % size])
    trust = 1.0
    for correction, most in zip(corrections, TRUSTED, strict=False):
        trust = trust * np.clip(2 - np.linalg.norm(correction[0], axis=1) / most, 0.0, 1.0)
        found = found + trust[:, None] * correction
    first, second = found
    leaving = chords if closed else np.concatenate((chords, chords[-1:]))
    return hairpins(first, unit(leaving)), second, knots


def corrected(away, values):
    """First and second derivatives at 0 by three points, and what each two more add to them: list of (2, n, 3).

    Newton's divided differences: places (n, m) and values there (n, m, 3), the nearest first.
    """
    rise = values.copy()
    for k in range(1, away.shape[1]):
        rise[:, k:] = (rise[:, k:] - rise[:, k - 1 : -1]) / (away[:, k:] - away[:, :-k])[..., None]
    found = [np.zeros((2, len(away), 3))]
    product, slope, bend = np.ones(len(away)), np.zeros(len(away)), np.zeros(len(away))
    for k, x in enumerate(away.T):
        if k > 2 and k % 2:
            found.append(np.zeros_like(found[0]))
        found[-1] += np.stack((slope, bend))[..., None] * rise[:, k]
        product, slope, bend = -x * product, product - x * slope, 2 * slope - x * bend
    return found


def hairpins(first, chords):
    """Tangents made at least so fast; one that is lost goes sideways, level if the chord is not vertical."""
    speed = np.linalg.norm(first, axis=1, keepdims=True)
    level = np.cross(chords, (0.0, 0.0, 1.0))
    level = np.where(np.linalg.norm(level, axis=1, keepdims=True) > 1e-6, level, (1.0, 0.0, 0.0))
    sideways = np.where(speed > 1e-9, first, level)
    return np.where(speed < SLOWEST, SLOWEST * unit(sideways), first)

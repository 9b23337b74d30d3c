# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rounding: circular arcs of one radius in place of the corners of a figure, joined by its straight sides."""

import numpy as np

from .loops import apart
from .section import Section


def rounded(centres, radius, first, turn, points):
    """The section of a figure with round corners, smooth all round.

    Parameters
    ----------
    centres : (n, 2) float array
        Of the arcs, counter-clockwise, in metres.
    radius : float
    first : (n,) float array
        Where each arc starts, as an angle in radians.
    turn : float
        The angle of every arc.
    points : int
        Of each arc, its ends among them.

    Returns
    -------
    Section
        Of one loop. Arcs that meet share a point.
    """
    corners = arcs(centres, radius, first + np.linspace(0, turn, points)[:, None])
    return Section.from_loops([corners], sharp=[np.zeros(len(corners), dtype=bool)])


def rounded_apexes(centres, radius, first, turn, points):
    """(m, 2) float array: of each edge of such a section, the middle of its arc or of its side."""
    corners = arcs(centres, radius, first + np.linspace(0, turn, points)[:, None])
    middles = arcs(centres, radius, first + (turn / (points - 1) * (np.arange(points) + 0.5))[:, None])
    middles[points - 1 :: points] = (corners + np.roll(corners, -1, axis=0))[points - 1 :: points] / 2
    return middles[apart(corners, np.array([0, len(corners)]))]


def arcs(centres, radius, angles):
    """(points n, 2) float array: arc after arc the points at (points, n) angles."""
    around = radius * np.stack([np.cos(angles.T), np.sin(angles.T)], axis=2)
    return (centres[:, None] + around).reshape(-1, 2)

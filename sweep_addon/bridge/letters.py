# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The letters of a text object as one outline, though their parts may overlap, as they do in many fonts."""

import numpy as np

from ..core.contours import reading
from ..core.contours.flatten import cubics_from_lines
from .curves import closed_cubics, coordinates


def letter_paths(splines):
    """The splines of a text as closed paths of cubics, (n, 4, 2) float arrays; underlines are straight."""
    return [closed_cubics(spline)[..., :2] if spline.type == "BEZIER" else straight(spline) for spline in splines]


def straight(spline):
    points = coordinates(spline.points, "co", 4)[:, :2]
    return cubics_from_lines(np.stack((points, np.roll(points, -1, axis=0)), axis=1))


def around_letters(paths):
    """The outline around what such paths fill; a letter that turns back on itself, or runs into another, may do so."""
    return reading.outline(paths, np.zeros(len(paths), dtype=int), [False], tolerance=0.0, centred=False)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far points are from a contour that stands scaled or leaning in its plane.

A map of the plane takes the contour's own places to where they stand. Of lines the ends are mapped, and of lines that
change too. Of curves the distance is that to first order: outside a convex one it is never too large.
"""

import numpy as np

from ..vectors import dot
from .drawn import Drawn
from .loops import Loops
from .one_by_one import nearest_of
from .smooth import Disc, Superdisc

LEAST = 1e-300


def stretch(scales, x=None, y=None):
    """The maps of the plane that scale, (2, n), and lean where the axes' duals x and y, (n, 3), say so: (n, 2, 2).

    They keep all distances that are so in space; their own directions mean nothing.
    """
    made = np.zeros((scales.shape[1], 2, 2))
    if x is None:
        made[:, 0, 0], made[:, 1, 1] = scales
        return made
    xx, yy, xy = dot(x, x), dot(y, y), dot(x, y)
    flat = xx * yy - xy**2
    a, b, c = yy / flat, xx / flat, -xy / flat  # the products of the axes themselves
    made[:, 0, 0], made[:, 0, 1] = np.sqrt(a), c / np.sqrt(a)
    made[:, 1, 1] = np.sqrt(np.maximum(b - c**2 / a, 0.0))
    return made * scales.T[:, None]


def mapped(region, points, parameters, maps):
    """How far points (n, 2) of the contour's own plane are from it where maps (n, 2, 2) take all, negative inside."""
    held = getattr(region, "region", region)
    if isinstance(held, Disc | Superdisc):
        return of_convex(held if isinstance(held, Superdisc) else Superdisc((held.radius,) * 2, 2.0), points, maps)
    if isinstance(held, Loops):
        return nearest_of(held, *points.T, maps)
    if isinstance(held, Drawn):
        return held.mapped(points, parameters, maps)
    depth, outward = region.exact(points, parameters)
    return np.sign(depth) * np.minimum(np.abs(depth) / slopes(outward, maps), narrowest(maps) * region.radius)


def of_convex(disc, points, maps):
    """The same of a `Superdisc`: outside it is never too large, as its level is convex."""
    level, slope = disc.levels(points)
    first = (level - 1) / np.maximum(slopes(slope, maps), LEAST)
    return disc.bounded(level, first, narrowest(maps), widest(maps))


def slopes(outward, maps):
    """By what a distance that grows along directions (n, 2) grows where maps take all: (n,)."""
    a, b, d = maps[:, 0, 0], maps[:, 0, 1], maps[:, 1, 1]
    first = outward[:, 0] / a
    return np.hypot(first, (outward[:, 1] - b * first) / d)


def narrowest(maps):
    """How much maps (n, 2, 2) stretch at least: (n,)."""
    return maps[:, 0, 0] * maps[:, 1, 1] / widest(maps)


def widest(maps):
    """How much they stretch at most: (n,)."""
    squares, product = (maps**2).sum(axis=(1, 2)), maps[:, 0, 0] * maps[:, 1, 1]
    return np.sqrt((squares + np.sqrt(np.maximum(squares**2 - 4 * product**2, 0.0))) / 2)

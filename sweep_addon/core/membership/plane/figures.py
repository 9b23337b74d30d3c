# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far points are from a contour that stands scaled or leaning in its plane.

A map of the plane takes the contour's own places to where they stand. Of lines the ends are mapped, and of lines that
change too. Of curves the distance is that to first order or less, and nowhere too large: a place that is nearer to one
side of a contour may be nearer to another when the map has taken both.
"""

import numpy as np

from ...vectors import dot
from .loops import Loops
from .maps import narrowest, slopes
from .one_by_one import nearest_of
from .smooth import Disc, Superdisc
from .strands import Strands


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
    if isinstance(held, Strands):
        return np.abs(nearest_of(held.edges, *points.T, maps))
    return region.mapped(points, parameters, maps)


def of_convex(disc, points, maps):
    """The same of a `Superdisc`."""
    level, slope = disc.levels(points)
    return disc.bounded(level, slopes(slope, maps), narrowest(maps))

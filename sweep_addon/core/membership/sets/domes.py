# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Round ends as sets of points: contours that shrink towards a tip as those of half a ball do."""

import numpy as np

from ...vectors import dot, norms
from ..labels import IN, ON, OUT
from ..motion.way import Carried, Way

TINY = 1e-9  # of the contour: less is the tip


def as_sweep(dome, region, is_sheet):
    """The way of a contour over the plane of an end that shrinks to the tip: its parameter is an angle."""

    def carried(angle):
        rising, shrunk = np.sin(angle), np.cos(angle)
        drawn = (1 - shrunk)[:, None] * (dome.centre * dome.scales @ dome.axes)
        middle = dome.middle + dome.height * rising[:, None] * dome.outward + drawn
        up, x, y = (np.tile(axis, (len(angle), 1)) for axis in (dome.outward, *dome.axes))
        return Carried(middle, up, x, y, shrunk[:, None] * dome.scales)

    faces = (not is_sheet, True)
    return Way(carried, np.array([0.0, np.pi / 2]), False, region.standing(dome.parameter), 4, faces=faces)


def in_dome(dome, region, points, tolerance, is_sheet=False):
    """IN, ON or OUT for points (n, 3), of a sheet none IN: (n,) int8."""
    way = points - dome.middle
    height = dot(way, dome.outward)
    part = np.clip(height / dome.height, 0.0, 1.0)
    shrunk = np.sqrt(1 - part**2)
    places = np.einsum("ni,ji->nj", way, dome.axes) / dome.scales
    images = dome.centre + (places - dome.centre) / np.maximum(shrunk, TINY)[:, None]
    depth, outward = region.exact(images, np.full(len(points), dome.parameter))
    across = outward / (dome.scales * np.maximum(shrunk, TINY)[:, None])
    # of a place above the plane the image moves away from the centre as it rises
    rising = (outward * (images - dome.centre)).sum(axis=1) * part / (np.maximum(shrunk, TINY) ** 2 * dome.height)
    distance = depth / np.sqrt((across**2).sum(axis=1) + rising**2)
    tip = dome.middle + dome.centre * dome.scales @ dome.axes + dome.height * dome.outward
    distance = np.where(norms(points - tip) <= tolerance, 0.0, distance)
    present = (distance <= tolerance) & (height >= -tolerance) & (height <= dome.height + tolerance)
    if is_sheet:
        return np.where(present & (distance >= -tolerance), ON, OUT).astype(np.int8)
    inside = (distance < -tolerance) & (height > tolerance)
    return np.where(inside, IN, np.where(present, ON, OUT)).astype(np.int8)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sectors: of contours that are star-shaped the part that something comes near, from the middle out to the surface."""

import numpy as np

from ..vectors import cross, dot, norms

MOST = 0.6  # of the strips that are united as whole tubes: more in sectors saves too little


def sectors(rings, plan, chunks):
    """The strips of faces that another stretch of the sweep may come near, in each segment one run round the contour.

    Parameters
    ----------
    rings : Rings
    plan : Plan
    chunks : Chunks

    Returns
    -------
    (m, segments) bool array or None
        None where whole tubes are to be united: where contours fold or are not star-shaped, where an end comes near
        something, or where sectors are hardly less.
    """
    at_ends = not rings.closed and chunks.conflict[[0, -1]].any()
    if plan.folds or rings.grid.tips or at_ends or len(rings.grid.offsets) > 2:
        return None
    found = near(rings, chunks)
    found = one_run(found | before(rings, found) | after(rings, found))
    ahead = after(rings, found)
    apart = found.any(axis=0) & ahead.any(axis=0) & ~(found & ahead).any(axis=0)
    found = np.repeat(found, np.diff(chunks.start), axis=1)
    saves = found.mean() <= MOST * (~plan.untouched).mean()
    return found if saves and not apart.any() and star_shaped(rings) else None


def star_shaped(rings):
    """Whether every ring is seen whole from its centre, counter-clockwise about its normal."""
    aside = rings.points - rings.centres
    return bool((dot(cross(aside, aside[rings.grid.following]), rings.normals) > 0).all())


def near(rings, chunks):
    """Which strips of each chunk another chunk that might meet it comes near: (m, k) bool array.

    A ball round all points of a chunk holds the chunk, one round those of a strip the strip. Where the middle line of a
    chunk may be in the ball of another all its strips are near.
    """
    busy = np.flatnonzero(chunks.conflict.any(axis=1))
    found = np.full((rings.grid.columns, len(chunks.folded)), False)
    if not len(busy):
        return found
    size = np.diff(chunks.start)[busy] + 1  # in rings
    last = np.cumsum(size) - 1
    first = last + 1 - size
    points = rings.mesh.vertices[rings.vertices(np.arange(last[-1] + 1) + np.repeat(chunks.start[busy] - first, size))]
    centre = (points[:, first] + points[:, last]).mean(axis=0) / 2
    radius = reach(points, np.repeat(centre[None], size, axis=1), first).max(axis=0)
    ahead = points[rings.grid.following]
    middle = (points[:, first] + points[:, last] + ahead[:, first] + ahead[:, last]) / 4
    spread = np.repeat(middle, size, axis=1)
    around = np.maximum(reach(points, spread, first), reach(ahead, spread, first))
    one, other = np.nonzero(chunks.conflict[np.ix_(busy, busy)])
    close = norms(middle[:, one] - centre[other]) <= around[:, one] + radius[other]
    half = norms(points[:, last] - points[:, first]).max(axis=0)
    inside = norms(centre[one] - centre[other]) <= radius[other] + half[one]
    found[:, busy] = np.logical_or.reduceat(close | inside, np.flatnonzero(np.diff(one, prepend=-1)), axis=1)
    return found


def reach(points, middle, first):
    """How far at most points (m, n, 3) are from middles, of each chunk, which begins at a first ring: (m, k)."""
    return np.maximum.reduceat(norms(points - middle), first, axis=1)


def before(rings, found):
    """The strips (m, k) of the chunk before each."""
    shifted = np.roll(found, 1, axis=1)
    shifted[:, 0] = False
    if rings.closed:
        shifted[rings.turned, 0] = found[:, -1]
    return shifted


def after(rings, found):
    """The strips (m, k) of the chunk after each."""
    shifted = np.roll(found, -1, axis=1)
    shifted[:, -1] = found[rings.turned, 0] if rings.closed else False
    return shifted


def one_run(found):
    """Strips (m, k) and what is between them, but for the longest gap of each column of the array."""
    count = len(found)
    twice = np.concatenate((found, found))
    number = np.arange(2 * count)[:, None]
    last = np.maximum.accumulate(np.where(twice, number, -1))  # the one before or at each
    gap = np.where(twice, 0, number - last)[count:]
    end, longest = gap.argmax(axis=0), gap.max(axis=0)
    behind = (end - np.arange(count)[:, None]) % count
    return found.any(axis=0) & (behind >= longest)

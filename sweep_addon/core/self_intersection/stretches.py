# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Stretches of a lattice, and which of them may meet.

Most pairs are ruled out without a look at their faces: they are far from each other, or the discs round their contours
are too near along the trajectory to meet.
"""

import numpy as np

from ..vectors import dot, norms, unit

BANDS = 8  # in the shortest stretches
COARSE = 64  # stretches that the search begins with, at least
MANY = 1000  # pairs of stretches: where there are more, every other ring is enough to see how they meet
TOO_MANY = 3  # times as many, at a guess: rings of which these are left are not looked at before there are fewer


def stretches(bands, size):
    """The first ring and the last of stretches of so many bands: two (k,)."""
    start = np.arange(0, bands, size)
    return start, np.minimum(start + size, bands)


def coarse(lattice, folded):
    """The lattice, of few enough rings to look closely at all that may meet, and the stretches that may.

    Parameters
    ----------
    lattice : Lattice
    folded : sequence of (float, float)
        Parameters between which it folds, as the local test has told.

    Returns
    -------
    lattice : Lattice
    pairs : (k, 2) int array
        Numbers of stretches of `BANDS` bands, the first no larger than the second.
    """
    while True:
        found, each = far_pairs(lattice, folded, 2 * MANY)
        wide = len(found) > 2 * MANY
        if not wide:
            found = found[boxes_meet(lattice, *found.T)]
        thinner = lattice.coarser() if len(found) > MANY else None
        if not thinner:
            return lattice, far_pairs(lattice, folded)[0] if wide else found
        left = each * len(found) / lattice.bands**2
        while left * thinner.bands**2 > TOO_MANY * MANY and (next_one := thinner.coarser()):
            thinner = next_one
        lattice = thinner


def far_pairs(lattice, folded, enough=None):
    """Stretches of bands whose balls meet, and between which there is enough way for them to.

    Returns
    -------
    pairs : (k, 2) int array
        Of more than are enough these may be some, but more than so many.
    each : int
        How many pairs each of them stands for.
    """
    pairs, each = followed(lattice, folded, enough)
    return followed(lattice, folded) if each > 1 and len(pairs) <= enough else (pairs, each)


def followed(lattice, folded, most=None):
    """The same: of more pairs than most the halves of some alone are looked at, however few come of it."""
    nearness, each = lattice.held(folded), 1
    halvings = max(int(np.log2(max(lattice.bands / (BANDS * COARSE), 1))), 0)
    first, last = np.triu_indices(-(-lattice.bands // (BANDS << halvings)))
    for size in (BANDS << level for level in range(halvings, -1, -1)):
        start, end = stretches(lattice.bands, size)
        if size < BANDS << halvings:
            step = -(-len(first) // most) if most and len(first) > most else 1
            first, last = children(first[::step], last[::step], len(start))
            each *= step
        kept = np.flatnonzero(balls_meet(*balls(lattice, start, end), first, last))
        first, last = first[kept], last[kept]
        kept = ~(nearness.near(start[first], end[last]) | nearness.around(end[first], start[last]))
        first, last = first[kept], last[kept]
    return np.stack((first, last), axis=1), each


def balls_meet(middle, radius, first, last):
    """Whether pairs of balls, by their numbers, meet: (k,) bool."""
    apart = sum((part.take(first) - part.take(last)) ** 2 for part in middle.T)
    return apart <= (radius.take(first) + radius.take(last)) ** 2


def children(first, last, count):
    """Of pairs of stretches those of their halves: each pair once."""
    pairs = np.stack((np.repeat(2 * first, 4), np.repeat(2 * last, 4)))
    pairs += np.tile([[0, 0, 1, 1], [0, 1, 0, 1]], len(first))
    return pairs[:, (pairs[0] <= pairs[1]) & (pairs[1] < count)]


def balls(lattice, start, end):
    """Balls round stretches: their middles (k, 3) and radii (k,)."""
    middle = (lattice.path[start] + lattice.path[end]) / 2
    size = int((end - start).max())
    rings = np.minimum(start[:, None] + np.arange(size + 1), end[:, None])
    return middle, (norms(lattice.path[rings] - middle[:, None]) + lattice.radii[rings]).max(axis=1)


def boxes_meet(lattice, first, last):
    """Whether boxes round stretches meet, along the axes of both and between their directions: (k,) bool."""
    if not len(first):
        return np.zeros(0, bool)
    used, which = np.unique(np.concatenate((first, last)), return_inverse=True)
    i, j = which.reshape(2, -1)
    middle, axes, half = boxes(lattice, *(part[used] for part in stretches(lattice.bands, BANDS)))
    chord, one, other, half_one, half_other = middle[j] - middle[i], axes[i], axes[j], half[i], half[j]
    turned = np.abs(one @ other.swapaxes(1, 2))
    apart = np.abs(one @ chord[..., None])[..., 0] - half_one - np.einsum("pab,pb->pa", turned, half_other)
    meet = (apart <= 0).all(axis=1)
    apart = np.abs(other @ chord[..., None])[..., 0] - half_other - np.einsum("pab,pa->pb", turned, half_one)
    meet &= (apart <= 0).all(axis=1)
    for direction in (unit(one[:, 0] + other[:, 0]), unit(chord)):
        reach = sum(
            dot(half_side, np.abs(side @ direction[..., None])[..., 0])
            for side, half_side in ((one, half_one), (other, half_other))
        )
        meet &= np.abs(dot(chord, direction)) <= reach
    return meet


def boxes(lattice, start, end):
    """Boxes round stretches: their middles (k, 3), axes (k, 3, 3), the first one forward, and half their edges."""
    rings = np.minimum(start[:, None] + np.arange(BANDS + 1), end[:, None])
    origin = lattice.path[start]
    points = lattice.points(rings).transpose(1, 3, 0, 2).reshape(len(rings), 3, -1)
    points -= origin[:, :, None]
    forward = unit(lattice.normals[rings].sum(axis=1))
    aside = points[:, :, :: BANDS + 1]
    longest = aside[np.arange(len(aside)), :, (aside * aside).sum(axis=1).argmax(axis=1)]
    wide = longest - dot(longest, forward)[:, None] * forward
    none = norms(wide) < 1e-12
    wide[none] = np.cross(forward[none], np.eye(3)[np.abs(forward[none]).argmin(axis=1)])
    wide = unit(wide)
    axes = np.stack((forward, wide, np.cross(forward, wide)), axis=1)
    along = axes @ points
    low, high = along.min(axis=2), along.max(axis=2)
    return origin + np.einsum("pa,pak->pk", (low + high) / 2, axes), axes, (high - low) / 2

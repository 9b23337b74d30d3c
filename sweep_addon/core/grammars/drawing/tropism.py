# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What turns a turtle as it stands: what rolls it level, and the tropism towards which its segments bend."""

import numpy as np

from .products import multiplied, put, taken

LEAST = np.finfo(float).tiny  # of the sine between a heading and a tropism, so that it divides
UPRIGHT = 1e-12  # of the sine between heading and up, below which nothing is level


def tropism(told):
    """What segments bend towards, of its direction and how easily they bend."""
    *towards, ease = told
    towards = np.array(towards) / np.abs(towards).max()  # whose square may be no number
    return Tropism(towards / np.linalg.norm(towards), ease)


class Tropism:
    """What segments bend towards.

    Orientations are multiplied in axes of which the first is its direction: there a heading turns towards it by a
    factor of z and one of w, as these are the cosine and the sine of half the angle between them, each times a number
    of size 1.

    Parameters
    ----------
    direction : (3,) float array
        Of length 1.
    ease : float
        By what times the sine between heading and direction a segment turns, in radians.
    """

    def __init__(self, direction, ease):
        x, across, self.ease = float(direction[0]), complex(*direction[1:].tolist()), ease
        longer = np.sqrt((1 + abs(x)) / 2)
        shorter = 1j * across / (2 * longer)
        self.axes = np.array((longer, shorter) if x >= 0 else (shorter, longer), dtype=complex)[:, None]
        self.back = np.stack((self.axes[0].conj(), -self.axes[1]))  # from these axes to those outside

    def bent(self, pair):
        """Turn headings towards it."""
        size = np.abs(pair)
        sine = 2 * size[0] * size[1]
        half = self.ease / 2 * sine
        by = 2 * np.sin(half) / np.maximum(sine, LEAST)
        size *= size
        factor = by * size[::-1]
        np.negative(factor[1], out=factor[1])
        factor += np.cos(half)
        return pair * factor


def level(pair, tropism=None):
    """Roll about the heading until the left is level; of orientations in the axes of a tropism, if there is one."""
    z, w = pair if tropism is None else multiplied(tropism.axes, pair)
    side = z.conj() ** 2 - w**2
    half = root(side.real, side.imag)
    return np.stack((pair[0] * half, pair[1] * half.conj()))


def root(x, y):
    """(n,) complex array: the square root of the direction of x + iy, 1 of none."""
    size = np.sqrt(x * x + y * y)
    none = size < UPRIGHT
    if none.any():
        x, y, size = np.where(none, 1, x), np.where(none, 0, y), np.where(none, 1, size)
    longer = np.sqrt(0.5 + 0.5 / size * np.abs(x))
    shorter = 0.5 / size * y / longer
    found = np.empty(len(size), dtype=complex)
    found.real = np.where(x < 0, np.abs(shorter), longer)
    found.imag = np.where(x < 0, np.copysign(longer, y), shorter)
    return found


def changed(pair, which, change):
    """Orientations of which a function changes some."""
    which = which.nonzero()[0]
    if len(which) == pair.shape[1]:
        return change(pair)
    if not len(which):
        return pair
    found = pair.copy()
    put(found, which, change(taken(pair, which)))
    return found

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A balanced tree of triangles: every node has four children, or a few triangles, and a slab that holds them."""

from functools import cached_property

import numpy as np

from ..declared.frozen import individual
from ..vectors import cross, dot, norms, unit
from .triangles import placed

FEWEST = 2  # triangles of a leaf; it has fewer than twice as many
FAN = 4  # children of a node
TOP = 16  # nodes at most that a search begins with
ROOM = np.float32(1 + 1e-5)  # for rounding of a node's size to single precision


@individual
class Tree:
    """Triangles ordered so that nodes are runs of them; in single precision, about the middle of all.

    Parameters
    ----------
    corners : (f, 3, 3) float array
        The corners of the triangles in metres.
    middle : (3,) float array
        What the single-precision arrays are measured from.
    order : (s, k) int array
        The triangles of each leaf; some are in several places.
    levels : tuple of (11, n) float32 arrays
        Of each node, leaves first: centre, normal, radius and half the thickness of the slab, and a point of a
        triangle. Components are rows, as arithmetic on many nodes likes them.

    Examples
    --------
    >>> corners = np.array([[(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)]])
    >>> Tree.of(corners).order.tolist()
    [[0]]
    """

    corners: np.ndarray
    middle: np.ndarray
    order: np.ndarray
    levels: tuple

    @classmethod
    def of(cls, corners, largest=np.inf):
        """The tree of triangles (f, 3, 3).

        Parameters
        ----------
        corners : (f, 3, 3) float array
        largest : float
            Triangles that reach farther from their centroid are cut into smaller ones for the search, in metres: one
            long triangle would make the slabs of all its neighbours large.
        """
        pieces, own = cut(corners, largest)
        order = ordered(pieces.mean(axis=1))
        own, pieces = own[order], pieces[order.ravel()].reshape(*order.shape, 3, 3)
        low, high = corners.min(axis=(0, 1)), corners.max(axis=(0, 1))
        middle = (low + high) / 2
        pieces = pieces - middle
        levels = [slabs(pieces)]
        while levels[-1].shape[1] > TOP:
            pieces = pieces.reshape(-1, FAN * pieces.shape[1], 3, 3)
            levels.append(slabs(pieces))
        return cls(corners, middle, own, tuple(levels))

    @cached_property
    def size(self):
        """The largest coordinate from the middle, in metres."""
        return float(np.abs(self.corners - self.middle).max())

    @cached_property
    def rows(self):
        """(18, s k) float32 array: the triangles of all leaves, each placed in its own plane."""
        return placed(self.corners - self.middle).astype(np.float32).take(self.order.ravel(), axis=1)


def cut(corners, largest):
    """Triangles halved across their longest sides until none reaches farther; each with the number of its original."""
    done, parents = [], []
    left, own = corners, np.arange(len(corners))
    while len(left):
        large = norms(left - left.mean(axis=1, keepdims=True)).max(axis=1) > largest
        done.append(left[~large])
        parents.append(own[~large])
        left, own = left[large], np.repeat(own[large], 2)
        longest = norms(np.roll(left, -1, axis=1) - left).argmax(axis=1)
        turn = (longest[:, None] + np.arange(3)) % 3
        a, b, c = np.take_along_axis(left, turn[:, :, None], axis=1).swapaxes(0, 1)
        half = (a + b) / 2
        left = np.stack((a, half, c, half, b, c), axis=1).reshape(-1, 3, 3)
    return np.concatenate(done), np.concatenate(parents)


def ordered(places):
    """Leaves of places near each other, (n, k) int array: halved again and again across their longest extent.

    The tree is full, so some places are in two leaves; all halves of one round are made in one call.
    """
    depth = max(len(places) // FEWEST, 1).bit_length() - 1
    each = -(-len(places) // 2**depth)
    order = np.arange(each * 2**depth) * len(places) // (each * 2**depth)
    for level in range(depth):
        order = order.reshape(2**level, -1)
        here = places[order]
        axis = np.ptp(here, axis=1).argmax(axis=1)
        along = np.take_along_axis(here, axis[:, None, None], axis=2)[:, :, 0]
        half = along.shape[1] // 2
        order = np.take_along_axis(order, along.argpartition(half, axis=1), axis=1)
    return order.reshape(-1, each)


def slabs(pieces):
    """A disc with a thickness about each group of triangles (n, k, 3, 3): (11, n) float32 array."""
    normals = cross(pieces[:, :, 1] - pieces[:, :, 0], pieces[:, :, 2] - pieces[:, :, 0]).sum(axis=1)
    normals = unit(normals)
    points = pieces.reshape(len(pieces), -1, 3)
    centres = (points.min(axis=1) + points.max(axis=1)) / 2
    away = points - centres[:, None]
    height = dot(away, normals[:, None])
    across = np.sqrt(np.maximum(dot(away, away) - height**2, 0))
    near = np.take_along_axis(points, dot(away, away).argmin(axis=1)[:, None, None], axis=1)[:, 0]
    size = np.abs(points).max(initial=0.0)
    reach = np.stack((across.max(axis=1), np.abs(height).max(axis=1)), axis=1) + 1e-6 * size
    found = np.concatenate((centres, normals, reach * ROOM, near), axis=1)
    return np.ascontiguousarray(found.T, dtype=np.float32)

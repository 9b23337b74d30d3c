# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A balanced tree of triangles: every node has four children, or a few triangles, and a box that holds them."""

from functools import cached_property

import numpy as np

from ..declared.frozen import individual
from ..stations.rotations import any_normal
from ..vectors import cross, dot, norms, unit
from .triangles import Exact, placed

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
    levels : tuple of (18, n) float32 arrays
        Of each node, leaves first: the centre of the box, its three axes and half its size along each, and a point of a
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
            long triangle would make the boxes of all its neighbours large.
        """
        pieces, own = cut(corners, largest)
        order = ordered(pieces.mean(axis=1))
        own, pieces = own[order], pieces[order.ravel()].reshape(*order.shape, 3, 3)
        low, high = corners.min(axis=(0, 1)), corners.max(axis=(0, 1))
        middle = (low + high) / 2
        pieces = pieces - middle
        levels = [boxes(pieces)]
        while levels[-1].shape[1] > TOP:
            pieces = pieces.reshape(-1, FAN * pieces.shape[1], 3, 3)
            levels.append(boxes(pieces))
        return cls(corners, middle, own, tuple(levels))

    @cached_property
    def size(self):
        """The largest coordinate from the middle, in metres."""
        return float(np.abs(self.corners - self.middle).max())

    @cached_property
    def rows(self):
        """(18, s k) float32 array: the triangles of all leaves, each placed in its own plane."""
        return placed(self.corners - self.middle).astype(np.float32).take(self.order.ravel(), axis=1)

    @cached_property
    def exact(self):
        """The triangles in double precision, as `Exact`."""
        return Exact.of(self.corners)


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


def boxes(pieces):
    """A box about each group of triangles (n, k, 3, 3), flat as they are and along them: (18, n) float32 array."""
    normals = unit(cross(pieces[:, :, 1] - pieces[:, :, 0], pieces[:, :, 2] - pieces[:, :, 0]).sum(axis=1))
    normals[~normals.any(axis=1)] = (0.0, 0.0, 1.0)
    points = pieces.reshape(len(pieces), -1, 3)
    middle = points.mean(axis=1)
    away = points - middle[:, None]
    x = any_normal(normals)
    y = cross(normals, x)
    u, v = (away @ axis[:, :, None] for axis in (x, y))
    turn = np.arctan2(2 * (u * v).sum(axis=1), (u * u - v * v).sum(axis=1)) / 2  # to where they are longest
    x = np.cos(turn) * x + np.sin(turn) * y
    axes = np.stack((x, cross(normals, x), normals), axis=1)
    along = away @ axes.swapaxes(1, 2)
    low, high = along.min(axis=1), along.max(axis=1)
    centres = middle + ((low + high)[:, None] @ axes)[:, 0] / 2
    away = points - centres[:, None]
    near = np.take_along_axis(points, dot(away, away).argmin(axis=1)[:, None, None], axis=1)[:, 0]
    half = (high - low) / 2 + 1e-6 * np.abs(points).max(initial=0.0)
    found = np.concatenate((centres, axes.reshape(-1, 9), half * ROOM, near), axis=1)
    return np.ascontiguousarray(found.T, dtype=np.float32)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The vertices of a sweep, in the order of its grid."""

import numpy as np

from ..meshes.mesh import require_precise
from ..vectors import product


def drawn(grid, weights, rings, dtype, empty=np.empty):
    """The vertices, column by column, then tips, then poles: one matrix product of the section with the rings.

    Parameters
    ----------
    grid : Grid
    weights : (m, k) float array
        What each point of the section is made of: 1 and its coordinates, see `affine`, or more.
    rings : (k, n, 3) float array
        What has these weights at each station: the place of the section's origin, its axes, or more.
    dtype : numpy dtype
        Single or double precision; anything else is refused.
    empty : callable
        Gives room for a number of coordinates and a dtype.

    Returns
    -------
    (v, 3) array
    """
    require_precise(dtype)
    whole = rings[:, grid.whole] if grid.tips else rings
    lines = weights[grid.lines] if grid.poles else weights
    ringed = len(lines) * whole.shape[1]
    vertices = empty(3 * (ringed + len(grid.tips) + len(grid.poles)), dtype).reshape(-1, 3)
    axes = np.empty(whole.shape, dtype)
    for i in range(3):  # rings lie column by column: to read each on end takes half the time of `astype`
        axes[..., i] = whole[..., i]
    room = vertices[:ringed].reshape(len(lines), -1)
    product(lines.astype(dtype, order="C"), axes.reshape(len(rings), -1), room)
    vertices[ringed:] = np.concatenate((rings[0, list(grid.tips)], weights[list(grid.poles)] @ rings[:, 0]))
    return vertices


def affine(points):
    """The weights of points that a place and two axes carry: (m, 3) float array of 1, x and y."""
    return np.column_stack((np.ones(len(points)), points))

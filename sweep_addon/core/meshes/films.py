# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Films: what is left between operands of a boolean whose faces meet but for rounding."""

import numpy as np

from ..vectors import cross, dot, norms
from .components import components

THIN = 1e-12  # of the size: films are ten thousand times thinner, and volumes are known to a thousandth of this


def without_films(vertices, triangles):
    """The triangles of a closed surface without shells that hold nothing: (k, 3) of (t, 3) int arrays.

    Both sides of a film are as near to a point beside it, and it is in neither. Cavities hold something.

    Examples
    --------
    >>> corners = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)] * 2) * 1.0
    >>> faces = np.array([(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])
    >>> both = np.concatenate((faces, faces[:, ::-1] + 4))
    >>> corners[4:] *= 0.2
    >>> len(without_films(corners, both))
    8
    >>> corners[7, 2] = 1e-17
    >>> len(without_films(corners, both))
    4
    """
    shell, volume, area = shells(vertices, triangles)
    if not shell.any():  # all of one
        return triangles
    return triangles[(volume > THIN * np.ptp(vertices, axis=0).max() * area)[shell]]


def shells(vertices, triangles):
    """The shell of each triangle, (t,) int array, and by its number the size of what it bounds, and its area."""
    shell = components(len(vertices), np.concatenate((triangles[:, :2], triangles[:, 1:])))[triangles[:, 0]]
    corners = (vertices - vertices[:1])[triangles]
    areas = cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    volume, area = (np.bincount(shell, each) for each in (dot(corners[:, 0], areas) / 6, norms(areas) / 2))
    return shell, np.abs(volume), area

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shells: the closed surfaces that a union consists of, and specks among them that are none."""

import numpy as np

from ..meshes.components import components
from ..vectors import cross, dot

SPECK = 1e-9  # of the largest volume


def without_specks(vertices, triangles):
    """Which triangles are of a shell that bounds more than a speck: (t,) bool array.

    Cavities are shells of their own and stay.
    """
    if not len(triangles):
        return np.zeros(0, bool)
    pairs = np.concatenate((triangles[:, :2], triangles[:, 1:]))
    shell = components(len(vertices), pairs)[triangles[:, 0]]
    a, b, c = (vertices - vertices.mean(axis=0))[triangles].swapaxes(0, 1)
    volume = np.abs(np.bincount(shell, dot(cross(a, b), c)))
    return volume[shell] > SPECK * volume.max()

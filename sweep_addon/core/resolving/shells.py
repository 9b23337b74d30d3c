# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shells: the closed surfaces that a union consists of, and specks among them that are none."""

from ..meshes.films import shells

SPECK = 1e-9  # of the largest volume


def without_specks(vertices, triangles):
    """Which triangles are of a shell that bounds more than a speck: (t,) bool array.

    Cavities are shells of their own and stay.
    """
    shell, volume, _ = shells(vertices, triangles)
    return volume[shell] > SPECK * volume.max(initial=0.0)

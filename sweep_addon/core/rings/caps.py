# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Caps: the faces that fill a section, one for each outline without holes and triangles for one that has them."""

from functools import lru_cache

import numpy as np

from ..meshes.triangulate import triangulate
from .ends import Flat


@lru_cache(maxsize=16)
def faces(section):
    """The faces of a section.

    Parameters
    ----------
    section : Section

    Returns
    -------
    points, offsets : tuple of int
        The section's points at the corners of the faces, and where each face starts.
    """
    corners, sizes = [], []
    for outer, *holes in section.islands:
        loops = [np.arange(*section.offsets[loop : loop + 2]) for loop in (outer, *holes)]
        found = triangulate(section.points, loops) if holes else loops[0][None]
        corners.extend(found.ravel().tolist())
        sizes.extend([found.shape[1]] * len(found))
    return tuple(corners), (0, *np.cumsum(sizes).tolist())


def at_ends(sections, ends, points):
    """The faces of two ends, or None where one is not flat or a point, as a grid takes them; an open line has none."""
    return tuple(
        faces(section) if isinstance(end, Flat) and section.closed and not point else None
        for section, end, point in zip(sections, ends, points, strict=True)
    )

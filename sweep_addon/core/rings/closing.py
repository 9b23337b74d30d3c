# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Closing: how the contour meets itself when it has been carried round a closed trajectory.

It may come back turned by any of the turns that map it to itself: its points then lead to others. So the frame is
twisted by half of such a turn at most, and a band may have one side alone.
"""

from functools import lru_cache
from math import tau

from ..contours.symmetry import turned_onto
from ..stations.transport import transport


def sectors(frame, along, symmetry):
    """By how many of the parts of a turn that map the contour to itself it comes back turned.

    Parameters
    ----------
    frame : RotationMinimizing, Frenet or FixedUp
    along : Along
        The laws, whose twist may grow by such parts.
    symmetry : int
        How many parts are a whole turn.

    Returns
    -------
    int
        From 0 to symmetry - 1.
    """
    holonomy = transport(along.trajectory).holonomy
    turned = frame.grown(holonomy, symmetry) + holonomy
    return (round(turned * symmetry / tau) + along.grown(symmetry)) % symmetry


@lru_cache(maxsize=16)
def seam(section, sectors, symmetry):
    """The point that each point of a section leads to when it is turned by parts of a turn: a tuple, () for none."""
    return tuple(turned_onto(section, symmetry / sectors).tolist()) if sectors else ()

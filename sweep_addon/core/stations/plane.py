# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The plane of a trajectory."""

import numpy as np

from ..declared.parameters import ShapeError
from ..trajectories.arc_length import arc_length
from ..vectors import norms, unit
from .cells import cut

FLAT = 1e-6  # of the size: points no farther out are in the plane
UP = np.array((0.0, 0.0, 1.0))


def normal_of(trajectory):
    """The unit normal of the plane that a trajectory lies in, (3,), on the upper side.

    A straight one lies in many: the plane is then as level as it can be.

    Raises
    ------
    ShapeError
        For a trajectory that is in no plane.
    """
    measure = arc_length(trajectory)
    points = trajectory.evaluate(cut(measure))
    points = points - points.mean(axis=0)
    size = float(norms(points).max())
    spread, ways = np.linalg.svd(points, full_matrices=False)[1:]
    if spread[1] <= FLAT * spread[0]:
        along = ways[0]
        normal = UP - (UP @ along) * along
        if np.linalg.norm(normal) < 1e-6:
            normal = np.array((0.0, -1.0, 0.0))
        return unit(normal)
    normal = ways[2]
    farthest = float(np.abs(points @ normal).max())
    if farthest > FLAT * size:
        sentence = f"must lie in a plane for discs, got points {farthest:.6g} m off one: balls need none"
        raise ShapeError(sentence)
    first = np.abs(normal[::-1]) > 1e-9
    return normal * np.sign(normal[::-1][np.argmax(first)])

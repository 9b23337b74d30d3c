# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Straight ways out: directions in which a part gets away from all around it."""

from .legs import Leg


def ways_out(scene, directions, pose, distance=None):
    """The straight legs on which a part seems to get out from a pose, by samples, the shortest first.

    Parameters
    ----------
    scene : Scene
    directions : (n, 3) float array
    pose : Pose
    distance : float, optional
        How far it is to go in metres; by default until a plane lies between it and all around.

    Yields
    ------
    Leg
    """
    travels = scene.travels(directions, pose)
    for number in travels.argsort(kind="stable"):
        leg = Leg((travels[number] if distance is None else distance) * directions[number])
        if scene.is_free(leg, pose):
            yield leg

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Stops: places on a motion at which to begin another one, where something opens or nothing goes on."""

import numpy as np

from .legs import Pose

ALONG = 200  # places of a motion at which it is looked what opens: where parts fit into slots, few of them
FAR = (0.05, 0.15, 0.3, 0.6, 1.2)  # of the part's size it is tried how far it goes aside there
SHORTEST = 0.01  # of the part's size: shorter motions lead nowhere
PROBES = 6  # directions at most


def stops(scene, leg, pose, directions):
    """The parts of a leg, from 0 to 1, at which another motion may begin.

    Parameters
    ----------
    scene : Scene
    leg : Leg
    pose : Pose
        In which it begins.
    directions : (n, 3) float array
        In which it is looked what is free on the way.

    Returns
    -------
    list of float
        The end of what is free of the leg, and amid each stretch of it on which other directions are free than at its
        start; the nearest first.
    """
    speed = leg.speed(pose.of(scene.core.vertices))
    end = scene.free_part(leg, pose)
    if end < 1.0:
        end -= scene.tolerance / 4 / speed  # not so near that nothing can be proven
    if end * speed < SHORTEST * scene.part.size:
        return []
    parts = np.linspace(0.0, end, ALONG + 1)
    along = [leg.axis, -leg.axis] if leg.turns else np.zeros((0, 3))
    probes = np.concatenate((along, directions))[:PROBES]
    open_ = np.array([opened(scene, probes, leg.pose(part).after(pose)) for part in parts])
    amid = {float(parts[first : last + 1].mean()) for row in open_.T for first, last in widest(row)}
    return sorted({*amid, float(end)})


def opened(scene, probes, pose):
    """How far the part may go aside in each direction (n, 3) from a pose, as a number of `FAR`: a list."""
    found = []
    for probe in probes:
        aside = (Pose(pose.matrix, pose.origin + far * scene.part.size * probe) for far in FAR)
        found.append(next((number for number, each in enumerate(aside) if scene.blocked(each)), len(FAR)))
    return found


def widest(row):
    """Where numbers (n,) are larger than beside it: the first and the last of each such stretch but the one at 0."""
    starts = np.append(0, np.flatnonzero(np.diff(row)) + 1)
    ends, height = np.append(starts[1:], len(row)) - 1, np.concatenate(([-1], row[starts], [-1]))
    above = (height[1:-1] > height[:-2]) & (height[1:-1] > height[2:])
    return [(int(first), int(last)) for first, last in zip(starts[above], ends[above], strict=True) if first]

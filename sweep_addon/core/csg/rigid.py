# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rigid motions: how a solid moves that neither stretches nor bends on the way."""

from ..declared.parameters import angle, declared, parameter
from ..stations.frames import FixedUp, Frenet, Parallel, RotationMinimizing
from ..trajectories import Arc, Trajectory
from ..variation.laws import Law

Carried = Parallel | RotationMinimizing | Frenet | FixedUp


@declared
class RigidMotion:
    """A motion along a trajectory that turns and does not stretch

    A point of the solid is turned about the solid's x, its y and its z axis, and then carried by the frame: parallel to
    itself, or with x and y along e2 and e3.

    Examples
    --------
    >>> RigidMotion(turn_z="2*pi*t").turn_z
    Formula(text='2*pi*t')
    """

    trajectory: Trajectory = parameter(Arc(), "The path along which it moves")
    frame: Carried = parameter(Parallel(), "The axes that carry it")
    turn_x: Law = angle(0.0, "Turn about the solid's x axis")
    turn_y: Law = angle(0.0, "Turn about the solid's y axis")
    turn_z: Law = angle(0.0, "Turn about the solid's z axis")

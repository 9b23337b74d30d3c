# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Assemblies of which it is known how a part gets out, or that it does not: a part, and what stays, by name."""

import numpy as np

from sweep_addon.core.contours import Circle, Outline
from sweep_addon.core.csg import Placed
from sweep_addon.core.meshes.booleans import body_of
from sweep_addon.core.meshes.polyhedron import polyhedron
from sweep_addon.core.removal.legs import turn
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.shapes.translational_sweep import TranslationalSweep
from sweep_addon.core.solids import Ball, Block, Cylinder
from sweep_addon.core.trajectories import Arc

Z = np.array([0.0, 0.0, 1.0])


def drawer():
    """A drawer that fits its case without play, open at its front, which looks along -y."""
    case = Block(0.6, 0.5, 0.4).moved(y=0.05) - Block(0.4, 0.5, 0.2).moved(y=-0.05)
    return Block(0.4, 0.4, 0.2), {"case": case}


def dovetail():
    """A key with flanks that hold it, in a groove along z that ends in a wall: it gets out along +z alone."""
    flanks = [[(-0.2, 0), (0.2, 0), (0.1, 0.2), (-0.1, 0.2)]]
    key = TranslationalSweep(Outline(flanks), height=1.0)
    groove = TranslationalSweep(Outline(flanks), height=2.0)
    return key, {"rail": Block(1.0, 0.6, 1.2).moved(y=-0.1, z=0.4) - groove}


def caged_ball(radius):
    """A ball in a cubic cage with square windows half as wide as the cage."""
    bars = Block(1.0, 1.0, 1.0) - Block(0.9, 0.9, 0.9)
    for sides in np.eye(3) + 0.5 * (1 - np.eye(3)):
        bars = bars - Block(*(2.0 * sides - (sides < 1) * 0.5))
    return Ball(radius), {"cage": bars}


def key_in_a_slot():
    """A key whose foot is behind a slotted lid: along the slot to its mouth, 0.595 m on, and out through that."""
    key = Block(0.1, 0.1, 1.2).moved(z=0.5) | Block(0.1, 0.5, 0.1).moved(z=-0.05)
    slot, mouth = Block(0.71, 0.11, 1.0).moved(x=0.3, z=0.5), Block(0.12, 0.52, 1.0).moved(x=0.595, z=0.5)
    return key, {"box": Block(2.0, 1.2, 0.5) - Block(1.8, 1.0, 0.3) - slot - mouth}


def bayonet():
    """A plug with two lugs in a groove, which two slots lead out of: a turn of 1.2, or 1.2 - pi, and straight out."""
    plug = Cylinder(0.2, 1.0, points=16) | Block(0.6, 0.1, 0.1)
    socket = Cylinder(0.5, 0.6, points=16) - Cylinder(0.21, 2.0, points=16) - Cylinder(0.33, 0.2, points=16)
    return plug, {"socket": socket - turned(Block(0.66, 0.12, 1.0), turn(Z, 1.2), (0, 0, 0.5))}


def curved_tube():
    """A tube along an arc about the z axis, in a sleeve along it: a turn about that axis."""
    tube, sleeve, hole = (
        GeneralizedCylinder(Circle(radius, points=12), Arc(1.0, angle))
        for radius, angle in ((0.1, 1.6), (0.2, 1.4), (0.11, 1.7))
    )
    return tube, {"sleeve": sleeve - hole}


def bent_rod():
    """A rod whose foot is behind a window that is shorter than it: no chain of straight ways leads out."""
    window = Block(0.45, 0.3, 1.0).moved(x=0.125, z=0.5)
    rod = Block(0.1, 0.1, 0.6).moved(z=0.3) | Block(0.5, 0.1, 0.1).moved(x=0.2, z=-0.05)
    return rod, {"box": (Block(1.6, 1.6, 1.0) - Block(1.5, 1.5, 0.9)).moved(z=-0.29) - window}


def shelled():
    """A ball in the hollow of another one, whose surfaces it does not touch."""
    return Ball(0.1), {"shell": Ball(0.5) - Ball(0.4)}


def turned(operand, matrix, origin):
    """An operand where an assembly is elsewhere."""
    return Placed(operand, np.column_stack((matrix, origin)))


def overlaps(path, part, others, steps=60):
    """The largest volume that part and others share on the way, by manifold3d at many places."""
    own = part.mesh() if hasattr(part, "mesh") else part
    stay = [body_of(other.mesh()) for other in others.values()]
    largest = 0.0
    for matrix in path.matrices(steps):
        moved = body_of(polyhedron(own.vertices @ matrix[:3, :3].T + matrix[:3, 3], own.corners, own.offsets))
        largest = max(largest, *((moved ^ other).volume() for other in stay))
    return largest

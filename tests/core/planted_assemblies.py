# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Assemblies of which it is known how a part gets out, or that it does not: a part, and what stays, by name."""

import numpy as np

from sweep_addon.core.contours import Outline
from sweep_addon.core.csg import Placed
from sweep_addon.core.shapes.translational_sweep import TranslationalSweep
from sweep_addon.core.solids import Ball, Block


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


def shelled():
    """A ball in the hollow of another one, whose surfaces it does not touch."""
    return Ball(0.1), {"shell": Ball(0.5) - Ball(0.4)}


def turned(operand, matrix, origin):
    """An operand where an assembly is elsewhere."""
    return Placed(operand, np.column_stack((matrix, origin)))

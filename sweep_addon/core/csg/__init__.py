# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweep-CSG: sweeps and other solids united, intersected and taken from each other, and moved as a whole.

Source
------
Hui: Solid modelling with sweep-CSG representation, CSG 94, 1994, pp. 119-131: leaves are sweeps, internal nodes are set
operations or sweep again, by a solid that moves.
"""

from .placed import Placed
from .rigid import RigidMotion
from .swept_contour import Rotation, SweptContour, Translation
from .swept_solid import SweptSolid
from .tree import Operation, Step, Tree

NODES = (Tree, Placed, SweptSolid, SweptContour)

__all__ = [
    "NODES",
    "Operation",
    "Placed",
    "RigidMotion",
    "Rotation",
    "Step",
    "SweptContour",
    "SweptSolid",
    "Translation",
    "Tree",
]

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What may be chosen of an offset."""

from enum import Enum


class Side(Enum):
    OUTSIDE = "The solid and all within the radius of it"
    INSIDE = "What of the solid is farther than the radius from its surface"
    SHELL = "All within the radius of the surface, on both sides"


class Engine(Enum):
    AUTOMATIC = "Convex solids as such, those of few flat faces by rounded faces, all others by a level set"
    CONVEX = "The hull of the faces moved out, with arcs and domes; inside, the faces moved in"
    ROUNDED_FACES = "The union of a rounded body around each flat face"
    LEVEL_SET = "Where the exact distance is the radius, on a lattice"

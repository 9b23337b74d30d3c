# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Options that several shapes have alike, or that who makes their meshes knows too."""

from enum import Enum

from .parameters import parameter

MEETING = "Self-Intersection"  # the sub-panel of what is done about it
PREFIX = "Self-intersection: "  # how every sentence about it begins


class Texture(Enum):
    LENGTHS = "True lengths in metres along the trajectory and round the contour"
    UNIT = "From 0 to 1 along the trajectory and round each loop of the contour, and over each cap"
    NONE = "No texture coordinates"


class Side(Enum):
    OUTSIDE = "The solid and all within the radius of it"
    INSIDE = "What of the solid is farther than the radius from its surface"
    SHELL = "All within the radius of the surface, on both sides"


class Engine(Enum):
    AUTOMATIC = "Convex solids as such, those of few flat faces by rounded faces, all others by a level set"
    CONVEX = "The hull of the faces moved out, with arcs and domes; inside, the faces moved in"
    ROUNDED_FACES = "The union of a rounded body around each flat face"
    LEVEL_SET = "Where the exact distance is the radius, on a lattice"


def solid_option():
    """Declare whether a shape's mesh is to be its solid."""
    return parameter(False, "Where the sweep meets itself, make the boundary of all that it visits", group=MEETING)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How texture coordinates are measured."""

from enum import Enum


class Texture(Enum):
    LENGTHS = "True lengths in metres along the trajectory and round the contour"
    UNIT = "From 0 to 1 along the trajectory and round each loop of the contour, and over each cap"
    NONE = "No texture coordinates"

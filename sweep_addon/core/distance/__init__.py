# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distance to a mesh of triangles: the nearest point, exact, for many points at once, and on which side they are."""

from .nearest_points import Nearest, nearest
from .sign import PseudoNormals
from .tree import Tree

__all__ = ["Nearest", "PseudoNormals", "Tree", "nearest"]

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweep-to-CSG conversion: outlines of lines and arcs as primitives that are united and taken off."""

from .areas import Conversion, convert
from .decomposition import Decomposition, Step, decompose
from .kinds import KINDS
from .primitive import Primitive
from .trees import kind, sweep_to_csg

__all__ = ["KINDS", "Conversion", "Decomposition", "Primitive", "Step", "convert", "decompose", "kind", "sweep_to_csg"]

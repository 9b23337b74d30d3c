# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The shapes of the program: adding one here brings it to Blender, job files and the command line."""

from ..declared.parameters import spelled
from .canal_surface import CanalSurface
from .general_sweep import GeneralSweep
from .generalized_cylinder import GeneralizedCylinder
from .machined_stock import MachinedStock
from .offset_surface import OffsetSurface
from .pd_curve_sweep import PDCurveSweep
from .plant import Plant
from .rotational_sweep import RotationalSweep
from .translational_sweep import TranslationalSweep

PLANAR = (TranslationalSweep, RotationalSweep, PDCurveSweep, GeneralizedCylinder)  # in the lecture's order
SOLID = (CanalSurface, OffsetSurface)
SWEEPS = {"Planar Generator": PLANAR, "Solid Generator": SOLID, "Any Generator": (GeneralSweep,)}
SWEPT = tuple(shape for shapes in SWEEPS.values() for shape in shapes)
CLASSIFICATION = SWEEPS | {"Machining": (MachinedStock,), "Grammar": (Plant,)}
SHAPES = tuple(shape for shapes in CLASSIFICATION.values() for shape in shapes)
SHAPE_NAMES = {spelled(shape): shape for shape in SHAPES}  # as jobs name them

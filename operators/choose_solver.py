# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Give the steps of a tree the solver that suits them as they are now."""

from bpy.types import Operator

from ..sweep_addon.core.later import later
from .on_tree import OnTree

solvers = later("bridge.solvers")


class OBJECT_OT_sweep_tree_choose_solver(OnTree, Operator):
    """Use the manifold solver where all operands are closed, else the exact one; make solid what meets itself"""

    bl_idname = "object.sweep_tree_choose_solver"
    bl_label = "Choose Solver"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        parts = solvers.parts(context.active_object)
        told = [solvers.make_solid(part) for part in parts] + [solvers.choose(part) for part in parts]
        for sentence in dict.fromkeys(filter(None, told)):
            self.report({"WARNING"}, sentence)
        return {"FINISHED"}

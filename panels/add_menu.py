# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The menu of what can be added, in Add > Mesh and in the sidebar."""

from bpy.types import Menu

from ..operators.add_shape import OPERATORS
from ..sweep_addon.presets import PRESETS


class VIEW3D_MT_sweep_add(Menu):
    """Shapes made by moving a contour along a trajectory, and presets of them"""

    bl_label = "Sweep"

    def draw(self, context):
        self.layout.operator_context = "INVOKE_REGION_WIN"
        for operator in OPERATORS:
            self.layout.operator(operator.bl_idname, icon="MESH_CYLINDER")
        self.layout.separator()
        for preset in PRESETS:
            self.layout.operator("mesh.sweep_preset_add", text=preset.title).preset = preset.name.upper()


def draw_in_mesh_add(self, context):
    self.layout.separator()
    self.layout.menu("VIEW3D_MT_sweep_add", icon="MOD_SCREW")

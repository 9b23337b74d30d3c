# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The menu of what can be added, in Add > Mesh and in the sidebar, and the line in Object > Convert."""

import os
from functools import cache

from bpy.types import Menu

from ..operators.add import idname
from ..sweep_addon.core.declared.names import spelled, title, titled
from ..sweep_addon.core.later import later
from . import previews

kinds, presets = later("core.shapes.kinds"), later("presets")

FOLDER = os.path.join(os.path.dirname(__file__), "..", "sweep_addon", "presets")  # its files are read later
GROUPS = sorted({entry.name for entry in os.scandir(FOLDER) if entry.is_dir()} - {"l_system", "__pycache__"})
ROWS = 20  # presets one below the other: all are in sight on a screen of 900 pixels


class VIEW3D_MT_sweep_add(Menu):
    """Shapes made by moving a contour along a trajectory, and presets of them"""

    bl_label = "Sweep"

    def draw(self, context):
        self.layout.operator_context = "INVOKE_REGION_WIN"
        row = self.layout.row()  # beside each other: one below the other they are higher than a small screen
        column = row.column(align=True)
        for generator, shapes in kinds.CLASSIFICATION.items():
            column.label(text=generator)
            for shape in shapes:
                if shape is kinds.Plant:
                    column.menu("VIEW3D_MT_sweep_l_system_add", icon_value=previews.icon(shape))
                else:
                    column.operator(idname(shape), icon_value=previews.icon(shape))
        column = row.column(align=True)
        column.label(text="Presets")
        others = (preset for preset in presets.PRESETS if preset.group != presets.GROWN)
        for entry in dict.fromkeys(preset.group or preset for preset in others):
            if entry in GROUPS:
                column.menu(menu_name(entry))
            else:
                draw_preset(column, entry, entry.title)


def menu_name(group):
    return f"VIEW3D_MT_sweep_{group}"


def menu_of(group):
    """The menu of the sizes in which a preset is offered."""

    def draw(self, context):
        self.layout.operator_context = "INVOKE_REGION_WIN"
        for preset in presets.PRESETS:
            if preset.group == group:
                draw_preset(self.layout, preset, title(preset.path.stem))

    return type(menu_name(group), (Menu,), {"bl_label": title(group), "draw": draw})


class VIEW3D_MT_sweep_l_system_add(Menu):
    """Plants and fractals that a grammar derives"""

    bl_label = "L-System"

    def draw(self, context):
        self.layout.operator_context = "INVOKE_REGION_WIN"
        self.layout.operator(idname(kinds.Plant), icon_value=previews.icon(kinds.Plant))
        self.layout.separator()
        for menu in GROWN_MENUS:
            self.layout.menu(menu.bl_idname)


def grown_menu(name, label, branching):
    """The menu of the presets that are grammars, of those whose words have branches or of the others."""

    def draw(self, context):
        self.layout.operator_context = "INVOKE_REGION_WIN"
        grown = [preset for preset in presets.PRESETS if preset.group == presets.GROWN]
        offered = [preset for preset in grown if branches(preset) == branching]
        row = self.layout.row()
        for first in range(0, len(offered), ROWS):
            column = row.column(align=True)
            for preset in offered[first : first + ROWS]:
                draw_preset(column, preset, preset.title)

    return type(name, (Menu,), {"bl_idname": name, "bl_label": label, "draw": draw})


@cache
def branches(preset):
    """Whether the words of a preset that is a grammar have branches."""
    lines = preset.path.read_text(encoding="utf-8").splitlines()
    return any("[" in line for line in lines if "->" in line or line.startswith("axiom"))


GROWN_MENUS = (
    grown_menu("VIEW3D_MT_sweep_l_system_plants", "Plants and Branches", True),
    grown_menu("VIEW3D_MT_sweep_l_system_curves", "Curves and Patterns", False),
)


def draw_preset(layout, preset, text):
    layout.operator("mesh.sweep_preset_add", text=text).preset = preset.name.upper()


class VIEW3D_MT_sweep_selected(Menu):
    """What can be made of the selected curves, texts and meshes"""

    bl_label = "Sweep Selected"

    def draw(self, context):
        for shape in kinds.SWEPT:
            if shape is kinds.OffsetSurface:
                self.layout.operator("object.sweep_offset_selected", icon_value=previews.icon(shape))
                continue
            name = spelled(shape, "_").upper()
            chosen = self.layout.operator("object.sweep_selected", text=titled(shape), icon_value=previews.icon(shape))
            chosen.shape = name


MENUS = (
    *map(menu_of, GROUPS),
    *GROWN_MENUS,
    VIEW3D_MT_sweep_l_system_add,
    VIEW3D_MT_sweep_add,
    VIEW3D_MT_sweep_selected,
)


def draw_in_mesh_add(self, context):
    self.layout.separator()
    self.layout.menu("VIEW3D_MT_sweep_add", icon="MOD_SCREW")
    self.layout.menu("VIEW3D_MT_sweep_l_system_add", icon="OUTLINER_OB_FORCE_FIELD")


def draw_in_convert(self, context):
    self.layout.separator()
    self.layout.operator("object.sweep_convert", text="Sweep", icon="MOD_SCREW")

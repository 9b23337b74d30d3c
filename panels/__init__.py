# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a user can see."""

import bpy
from bpy.utils import register_classes_factory

from . import add_menu, csg, frames, previews, sidebar

register_classes, unregister_classes = register_classes_factory(
    (*add_menu.MENUS, csg.VIEW3D_PT_sweep_csg, sidebar.VIEW3D_PT_sweep)
)


def register():
    frames.register()
    register_classes()
    bpy.types.VIEW3D_MT_mesh_add.append(add_menu.draw_in_mesh_add)
    bpy.types.VIEW3D_MT_object_convert.append(add_menu.draw_in_convert)


def unregister():
    bpy.types.VIEW3D_MT_object_convert.remove(add_menu.draw_in_convert)
    bpy.types.VIEW3D_MT_mesh_add.remove(add_menu.draw_in_mesh_add)
    unregister_classes()
    frames.unregister()
    previews.unregister()

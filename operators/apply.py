# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Make a sweep an ordinary mesh."""

from bpy.types import Operator

from ..sweep_addon.core.later import later

objects, let_stand = later("bridge.objects"), later("bridge.standing", "let_stand")


class OBJECT_OT_sweep_apply(Operator):
    """Keep the mesh as it is and forget the parameters, for all selected sweeps"""

    bl_idname = "object.sweep_apply"
    bl_label = "Apply"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if any(map(is_kept, chosen(context))):
            return True
        cls.poll_message_set("Select a sweep whose mesh is not linked from another file")
        return False

    def execute(self, context):
        meshes = {ob.data for ob in filter(is_kept, chosen(context))}
        let_stand(meshes)
        for mesh in meshes:
            objects.forget(mesh)
        return {"FINISHED"}


def is_kept(ob):
    """Whether an object is a sweep whose mesh this file holds; of a library override it holds parameters alone."""
    return objects.is_editable_sweep(ob) and not ob.data.override_library


def chosen(context):
    return {*context.selected_objects, *filter(None, [context.active_object])}

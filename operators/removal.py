# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Find how the active mesh gets out from among others, and what must stay empty for it."""

from bpy.props import BoolProperty, FloatProperty, IntProperty
from bpy.types import Operator

from ..sweep_addon.core.declared.refusals import ShapeError
from ..sweep_addon.core.later import later
from .on_active import can_change

removal = later("bridge.removal")

TICK = 0.05  # seconds in which the window asks how far the search is


class OBJECT_OT_sweep_find_removal_path(Operator):
    """Find a path on which the active mesh gets out from among the other selected meshes, or all visible ones, without
    touching them; animate it, and draw the volume that must stay empty. Esc stops the search"""

    bl_idname = "object.sweep_find_removal_path"
    bl_label = "Find Removal Path"
    bl_options = {"REGISTER", "UNDO"}

    tolerance: FloatProperty(
        name="Tolerance",
        description="How deep parts that touch may be in each other on the way; at 0 a thousandth of the part's size",
        unit="LENGTH",
        min=0.0,
    )
    seed: IntProperty(name="Seed", description="Of the random motions that are tried last", min=0)
    animate: BoolProperty(name="Animate", description="Give the part keyframes on its path", default=True)
    frames: IntProperty(name="Frames", description="Of each leg of the path", default=24, min=1, soft_max=250)

    @classmethod
    def poll(cls, context):
        if not can_change(cls, context):
            return False
        if context.active_object.type == "MESH":
            return True
        cls.poll_message_set("Make the mesh that is to be removed the active object")
        return False

    def execute(self, context):
        """Find it at once: a script goes on when it is there."""
        search = self.begun(context)
        if not search:
            return {"CANCELLED"}
        search.thread.join()
        return self.finished(context, search)

    def invoke(self, context, event):
        self.search = self.begun(context)
        if not self.search:
            return {"CANCELLED"}
        self.timer = context.window_manager.event_timer_add(TICK, window=context.window)
        context.window_manager.progress_begin(0, 1)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC" and event.value == "PRESS":
            self.cancel(context)
            self.report({"INFO"}, "The search was stopped")
            return {"CANCELLED"}
        if event.type != "TIMER":
            return {"RUNNING_MODAL"}  # what is searched among stays as it is
        if not self.search.done:
            context.window_manager.progress_update(self.search.share)
            return {"RUNNING_MODAL"}
        self.cancel(context)
        return self.finished(context, self.search)

    def cancel(self, context):
        """Blender calls this too where it ends an operator itself, as when another file is opened."""
        self.search.stop()
        context.window_manager.event_timer_remove(self.timer)
        context.window_manager.progress_end()

    def begun(self, context):
        """The search, or None after a report."""
        part = context.active_object
        try:
            meshes = removal.assembly(part, others(context, part))
        except ShapeError as error:
            self.report({"ERROR"}, str(error))
            return None
        return removal.Search(*meshes, self.tolerance or None, self.seed)

    def finished(self, context, search):
        """What comes of a search: a volume and keyframes, or a report."""
        part = context.active_object
        if not search.path:
            self.report({"ERROR"}, search.why_not)
            return {"CANCELLED"}
        removal.keep_empty(context, part, search.volume)
        if self.animate:
            removal.animate(part, search.path, context.scene.frame_current, self.frames)
        self.report({"INFO"}, str(search.path))
        return {"FINISHED"}


def others(context, part):
    """The other selected meshes, or all visible ones where the part alone is selected."""
    selected = [ob for ob in context.selected_objects if ob.type == "MESH" and ob != part]
    if selected:
        return selected
    return [ob for ob in context.visible_objects if ob.type == "MESH" and ob != part and ob.display_type != "WIRE"]

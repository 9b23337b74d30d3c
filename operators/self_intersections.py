# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Find where a sweep meets itself, select the faces that are there, and make the solid that has none."""

import bpy
from bpy.types import Operator

from ..sweep_addon.core.declared.refusals import ShapeError
from ..sweep_addon.core.later import later

crossings, objects = later("bridge.crossings"), later("bridge.objects")
finding, rendering = later("properties.finding"), later("properties.rendering")
live, solving = later("properties.live"), later("properties.solving")

TICK = 0.05  # seconds in which the window asks how far a solid is


class OBJECT_OT_sweep_find_self_intersections(Operator):
    """Find where the active sweep meets itself, and up to which size it does not"""

    bl_idname = "object.sweep_find_self_intersections"
    bl_label = "Find Self-Intersections"
    bl_options = {"REGISTER"}

    @classmethod
    def poll(cls, context):
        return is_ready(cls, context)

    def execute(self, context):
        told = finding.find(context.active_object.data)
        for sentence in told:
            self.report({"WARNING"}, sentence)
        if not told:
            self.report({"INFO"}, "No self-intersection")
        return {"FINISHED"}


class OBJECT_OT_sweep_select_self_intersections(Operator):
    """Go to Edit Mode with the faces selected at which the active sweep meets itself"""

    bl_idname = "object.sweep_select_self_intersections"
    bl_label = "Select Faces"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if not is_ready(cls, context):
            return False
        if context.active_object.data.sweep.edited:
            cls.poll_message_set("The mesh was changed by hand: its faces are others")
            return False
        return True

    def execute(self, context):
        try:
            count = crossings.select(context.active_object.data)
        except ShapeError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if not count:
            self.report({"INFO"}, "No self-intersection")
            return {"CANCELLED"}
        context.tool_settings.mesh_select_mode = (False, False, True)
        bpy.ops.object.mode_set(mode="EDIT")
        return {"FINISHED"}


class OBJECT_OT_sweep_make_solid(Operator):
    """Make the solid of the active sweep, whose surface stands until then; Esc stops it"""

    bl_idname = "object.sweep_make_solid"
    bl_label = "Make Solid"
    bl_options = {"INTERNAL"}

    running = None  # the work under way, which no .blend remembers

    @classmethod
    def part(cls):
        """How much of the work under way is done, from 0 to 1; None where there is none."""
        return cls.running.part if cls.running else None

    @classmethod
    def poll(cls, context):
        if cls.running:
            cls.poll_message_set("Another solid is being made")
        return not cls.running

    def execute(self, context):
        """Make it at once: a script goes on when it is there."""
        ob = context.active_object
        if not (objects.is_sweep(ob) and ob.data.is_editable and solving.is_wanted(ob.data)):
            self.report({"ERROR"}, "The active object must be a sweep whose Make Solid is on")
            return {"CANCELLED"}
        if ob.data.is_editmode:
            self.report({"ERROR"}, "The mesh is being edited, which its solid would undo: leave Edit Mode first")
            return {"CANCELLED"}
        work = solving.work_of(ob.data)
        if work:
            work.thread.join()
            solving.finish(ob.data, work)
        if ob.data.sweep.solid:
            self.report({"ERROR"}, ob.data.sweep.solid)
            return {"CANCELLED"}
        return {"FINISHED"}

    def invoke(self, context, event):
        ob = context.active_object
        if objects.is_sweep(ob) and ob.data.sweep.solid:
            ob.data.sweep.solid = live.AWAITED
        meshes = solving.awaited()
        work = solving.work_of(meshes[0]) if meshes else None
        if not work:
            return {"CANCELLED"}
        type(self).running, self.mesh = work, meshes[0].session_uid
        self.timer = context.window_manager.event_timer_add(TICK, window=context.window)
        context.window_manager.progress_begin(0, 1)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        work, mesh = self.running, next((m for m in bpy.data.meshes if m.session_uid == self.mesh), None)
        current = mesh and mesh.sweep.made == work.wanted and mesh.sweep.solid == live.AWAITED
        if event.type == "ESC" and event.value == "PRESS" or not current:
            work.stop()
        elif event.type != "TIMER":
            return {"PASS_THROUGH"}
        elif not work.done or rendering.goes_on():
            context.window_manager.progress_update(work.part)
            finding.redraw()
            return {"PASS_THROUGH"}
        if current and not mesh.is_editmode:
            solving.finish(mesh, work)
        self.cancel(context)
        return {"FINISHED"}

    def cancel(self, context):
        """Blender calls this too where it ends an operator itself, as when another file is opened."""
        self.running.stop()
        type(self).running = None
        context.window_manager.event_timer_remove(self.timer)
        context.window_manager.progress_end()
        finding.redraw()
        finding.soon()  # another may wait


def is_ready(operator, context):
    """Whether the active object is a sweep in Object Mode, made as its parameters say; if not, the operator says so."""
    ob = context.active_object
    if not objects.is_editable_sweep(ob):
        operator.poll_message_set("Select a sweep whose mesh is not linked from another file")
    elif not objects.is_swept(ob):
        operator.poll_message_set("The tubes of an L-system begin within each other: nobody asks where they meet")
    elif context.mode != "OBJECT":
        operator.poll_message_set("Go back to Object Mode first")
    elif ob.data.sweep.error:
        operator.poll_message_set("The shape cannot be made: see the sidebar")
    else:
        return True
    return False

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Make the solids that sweeps are to be, while people work on."""

import bpy
from bpy.types import Operator

from ..sweep_addon.core.later import later

is_sweep = later("bridge.objects", "is_sweep")
finding, live, solving = later("properties.finding"), later("properties.live"), later("properties.solving")

TICK = 0.05  # seconds


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
        if not (is_sweep(ob) and ob.data.is_editable and solving.is_wanted(ob.data)):
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
        if is_sweep(ob) and ob.data.sweep.solid:
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
        elif not work.done:
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

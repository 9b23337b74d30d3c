# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes as a render, a bake or an export of a window asks for them, held until it ends; then what is shown comes back.

These evaluate the scene in a thread of their own: they ask for their meshes from there, and one timer in the thread of
the window writes them. In background mode there is one thread, and no timer.
"""

from time import monotonic

import bpy

from ..core.later import later
from . import drawing_thread

inputs, renders_otherwise = later("bridge.objects", "inputs", "renders_otherwise")
rebuild = later("properties.live", "rebuild")

JOBS = ("RENDER", "OBJECT_BAKE")  # exports are not told of
SOON, RARELY = 0.0, 0.05  # seconds between two turns: while one of these runs, or none
QUIET = 5.0  # seconds after which nothing is held for what Blender does not tell of


class Held:
    """The meshes that another thread has had made, by their `session_uid`, and when it asked last."""

    def __init__(self):
        self.meshes, self.asked = set(), 0.0

    def __contains__(self, mesh):
        return mesh.session_uid in self.meshes

    def remake(self, mesh, depsgraph):
        """Make a mesh as another thread asks for it, and hold it if that changed it."""
        made, new = mesh.sweep.made, mesh not in self
        self.meshes.add(mesh.session_uid)  # before it is written: the window sees that at once
        self.asked = monotonic()
        rebuild(mesh, depsgraph)
        if new and mesh.sweep.made == made:
            self.meshes.discard(mesh.session_uid)

    def release(self):
        """Bring back what is shown, of all that a render may have made anew."""
        self.meshes.clear()
        for mesh in sweeps():
            if mesh.animation_data or inputs(mesh) or renders_otherwise(mesh):
                rebuild(mesh)


held = Held()


def sweeps():
    return [mesh for mesh in bpy.data.meshes if mesh.sweep.kind != "NONE"]


def goes_on():
    """Whether meshes may be as a render asks for."""
    return bool(held.meshes) or any(map(bpy.app.is_job_running, JOBS))


def attend():
    """What the timer calls."""
    drawing_thread.window.give()
    if any(map(bpy.app.is_job_running, JOBS)):
        return SOON
    if held.meshes and monotonic() - held.asked > QUIET:
        held.release()
    return RARELY


def begin():
    if not bpy.app.background:
        bpy.app.timers.register(attend, persistent=True)


def stop():
    if bpy.app.timers.is_registered(attend):
        bpy.app.timers.unregister(attend)

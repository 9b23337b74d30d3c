# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Finding self-intersections a moment after the last change, by one timer that ends when nothing is left to look at.

It also begins what makes solids of sweeps that are to be some, and until then show their surface.

What is found stays on the mesh with the digest of what it is true of. In background mode nobody waits for it and
Blender hangs at its end while there is a timer: there is none.
"""

import bpy

from ..core.declared.parameters import ShapeError
from ..core.later import later
from . import rendering, solving
from .live import AWAITED, set_if_other

crossings = later("bridge.crossings")

MOMENT = 0.5  # seconds without a change
NEXT = 0.05  # until the next of several sweeps: in between, people can work


def find(mesh, searched=True):
    """Find where a sweep meets itself as it is now, and keep what is told on the mesh: a tuple of sentences.

    Where the largest safe size takes a search, it is told only on request.
    """
    try:
        told = crossings.told(mesh, searched)
    except ShapeError:
        told = ()  # why it cannot be made is told already
    set_if_other(mesh.sweep, "places", "\n".join(told))
    set_if_other(mesh.sweep, "looked_at", mesh.sweep.made)
    return told


def is_due(mesh):
    """Whether a sweep has changed since it was looked at, or its solid is awaited.

    One in Edit Mode waits, and one of another file stays.
    """
    sweep = mesh.sweep
    if sweep.kind == "NONE" or not mesh.is_editable or mesh.is_editmode:
        return False
    return sweep.looked_at != sweep.made or sweep.solid == AWAITED


def soon(*_):
    """Look a moment from now, later than was meant before."""
    if bpy.app.background:
        return
    stop()
    bpy.app.timers.register(look, first_interval=MOMENT)


def look():
    """What the timer calls: look at one sweep, and say when to look at the next, if there is one."""
    due = [mesh for mesh in bpy.data.meshes if is_due(mesh)]
    if not due:
        return None
    if rendering.goes_on():
        return MOMENT
    unseen = [mesh for mesh in due if mesh.sweep.looked_at != mesh.sweep.made]
    if unseen:
        find(unseen[0], searched=False)  # nobody has asked, and the window waits
        redraw()
        return NEXT if len(due) > 1 or due[0].sweep.solid == AWAITED else None
    solving.begin()
    return None


def redraw():
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                area.tag_redraw()


def stop():
    if bpy.app.timers.is_registered(look):
        bpy.app.timers.unregister(look)

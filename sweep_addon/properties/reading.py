# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading the texts of grammars again a moment after somebody has typed in one, for Blender tells nobody of typing.

One timer looks at the texts that plants are made of, and ends when there are none. In background mode nobody types.
"""

import bpy

from ..bridge.objects import is_grown
from .finding import redraw
from .live import rebuild

PAUSE = 0.25  # seconds between two looks; a text is read when both saw the same


class Watch:
    """The timer, and what it saw last, which no .blend remembers."""

    def __init__(self):
        self.seen = {}

    def __call__(self):
        """Make plants anew whose text has changed and then stood still, and say when to look again."""
        watched = [mesh for mesh in bpy.data.meshes if is_watched(mesh)]
        if bpy.app.is_job_running("RENDER"):
            return PAUSE
        seen, self.seen = self.seen, {}
        for mesh in watched:
            text = mesh.sweep.plant.system_text.as_string()
            if text == mesh.sweep.plant.system:
                continue
            if seen.get(mesh.session_uid) == text:
                rebuild(mesh)
                redraw()
            else:
                self.seen[mesh.session_uid] = text
        return PAUSE if watched else None


watch = Watch()


def is_watched(mesh):
    """Whether a mesh is made of a text that people can edit."""
    return is_grown(mesh) and mesh.is_editable and mesh.sweep.plant.system_text is not None


def begin():
    """Look from now on, where there is a window."""
    if not bpy.app.background and not bpy.app.timers.is_registered(watch):
        bpy.app.timers.register(watch, first_interval=PAUSE)


def stop():
    if bpy.app.timers.is_registered(watch):
        bpy.app.timers.unregister(watch)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading texts of grammars and programs again a moment after somebody has typed in one: Blender tells nobody of it.

One timer looks at the texts that meshes are made of, and ends when there are none. In background mode nobody types.
"""

import bpy

from ..bridge.objects import is_written, text_of
from ..bridge.texts import held_by
from . import rendering
from .finding import redraw
from .live import rebuild

PAUSE = 0.25  # seconds between two looks; a text is read when both saw the same


class Watch:
    """The timer, and what it saw last, which no .blend remembers."""

    def __init__(self):
        self.seen = {}

    def __call__(self):
        """Make meshes anew whose text has changed and then stood still, and say when to look again."""
        watched = [mesh for mesh in bpy.data.meshes if is_watched(mesh)]
        if rendering.goes_on():
            return PAUSE
        seen, self.seen = self.seen, {}
        for mesh in watched:
            group, name = text_of(mesh)
            text = held_by(group, name).as_string()
            if text == getattr(group, name):
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
    return is_written(mesh) and mesh.is_editable and held_by(*text_of(mesh)) is not None


def begin():
    """Look from now on, where there is a window."""
    if not bpy.app.background and not bpy.app.timers.is_registered(watch):
        bpy.app.timers.register(watch, first_interval=PAUSE)


def stop():
    if bpy.app.timers.is_registered(watch):
        bpy.app.timers.unregister(watch)

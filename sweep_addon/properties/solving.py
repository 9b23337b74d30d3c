# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Solving: the solids that sweeps are to be are made in a thread, while their surfaces stand.

The thread knows no Blender: it makes arrays of shapes that were read before, and an operator writes them.
"""

from threading import Thread

import bpy
import numpy as np

from ..bridge import objects
from ..core.declared.parameters import ShapeError
from ..core.later import later
from .live import AWAITED, put, set_if_other, wants_solid

joined, digest = later("core.meshes.joining", "joined"), later("core.declared.digest", "digest")

STOPPED = "The {} was not made: Esc stopped it."
FAILED = "The {} was not made: the terminal shows why."


class StoppedError(Exception):
    """Raised in the thread where it is to end."""


class Work:
    """The solid of some shapes in the making.

    Attributes
    ----------
    wanted : str
        The digest of the shapes.
    part : float
        How much is done, from 0 to 1.
    made : Mesh or None
    why_not : str
        Why there is none.
    """

    def __init__(self, shapes):
        self.shapes, self.wanted = shapes, digest(shapes)
        self.what = "figure" if any(hasattr(shape, "system") for shape in shapes) else "solid"
        self.part, self.made, self.why_not, self.stopping = 0.0, None, FAILED.format(self.what), False
        self.thread = Thread(target=self.run, daemon=True)
        self.thread.start()

    @property
    def done(self):
        return not self.thread.is_alive()

    def run(self):
        try:
            self.made = joined([self.solid(shape) for shape in self.shapes])
        except StoppedError:
            pass
        except ShapeError as refusal:
            self.why_not = str(refusal)

    def solid(self, shape):
        if not wants_solid(shape):
            made = shape.mesh()
        elif hasattr(shape, "follow"):  # open ends have a mesh, and no solid
            shape.follow(self.tell)
            made = shape.mesh()
        else:
            made = shape.solid(self.tell)
        return made.astype(np.float32)

    def tell(self, part):
        if self.stopping:
            raise StoppedError
        self.part = part

    def stop(self):
        """End before the next step."""
        self.stopping = True


def begin():
    """Begin to make the next solid that is awaited, in the window."""
    windows = bpy.context.window_manager.windows
    if windows:
        with bpy.context.temp_override(window=windows[0]):
            bpy.ops.object.sweep_make_solid("INVOKE_DEFAULT")


def awaited():
    """The meshes whose solid is awaited and can be written."""
    meshes = (mesh for mesh in bpy.data.meshes if mesh.sweep.solid == AWAITED)
    return [mesh for mesh in meshes if mesh.is_editable and not mesh.is_editmode]


def is_wanted(mesh):
    """Whether the shapes of a mesh are to be solids."""
    try:
        return any(map(wants_solid, objects.shapes(mesh)))
    except ShapeError:
        return False


def work_of(mesh):
    """Begin the work of a mesh, or say on it why that cannot be: a `Work` or None."""
    try:
        return Work(objects.shapes(mesh))
    except ShapeError as refusal:
        set_if_other(mesh.sweep, "solid", str(refusal))
        return None


def finish(mesh, work):
    """Write what came of the work of a mesh that has not changed since; what was refused since stays told."""
    refused = mesh.sweep.error
    if work.made and not work.stopping:
        put(mesh, work.made, work.wanted)
        set_if_other(mesh.sweep, "error", refused)
    else:
        set_if_other(mesh.sweep, "solid", STOPPED.format(work.what) if work.stopping else work.why_not)

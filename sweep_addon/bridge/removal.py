# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Removal paths in a scene: objects read as an assembly, a path as keyframes, and the volume that must stay empty."""

from threading import Thread

import bpy
import numpy as np
from mathutils import Matrix

from ..core.csg.meshes import transformed
from ..core.declared.parameters import ShapeError, at, require
from ..core.removal import removal_path
from . import meshes, models, placing

FAILED = "The search failed: the terminal shows why"


class StoppedError(Exception):
    """Raised in the thread where it is to end."""


class Search:
    """A removal path in the making, in a thread that knows no Blender.

    Attributes
    ----------
    share : float
        How much is done, from 0 to 1.
    path : RemovalPath or None
    volume : Mesh or None
        What must stay empty for it.
    why_not : str
        Why there is none.
    """

    def __init__(self, part, others, tolerance=None, seed=0):
        self.given = part, others, tolerance, seed
        self.share, self.path, self.volume, self.why_not, self.stopping = 0.0, None, None, FAILED, False
        self.thread = Thread(target=self.run, daemon=True)
        self.thread.start()

    @property
    def done(self):
        return not self.thread.is_alive()

    def run(self):
        part, others, tolerance, seed = self.given
        try:
            path = removal_path(part, others, tolerance=tolerance, seed=seed, progress=self.tell)
            if not path:
                self.why_not = str(path)
                return
            self.volume = path.swept().mesh()
            self.path = path
        except StoppedError:
            pass
        except ShapeError as refusal:
            self.why_not = str(refusal)

    def tell(self, share):
        if self.stopping:
            raise StoppedError
        self.share = share

    def stop(self):
        """End before the next step."""
        self.stopping = True


def assembly(part, others):
    """The meshes of a part and of other objects as they are shown, in the space of the world, the others by full name.

    Raises
    ------
    ShapeError
        For an object without faces.
    """
    depsgraph = bpy.context.evaluated_depsgraph_get()
    require(others, "must have at least one: select the meshes that stay too", 0, "others")
    return in_world(part, depsgraph), {other.name_full: in_world(other, depsgraph) for other in others}


def in_world(ob, depsgraph):
    """The mesh of an object in the space of the world."""
    with at(ob.name):
        mesh = models.triangles(ob, depsgraph, scaled=False).mesh()
        matrix = np.array(ob.evaluated_get(depsgraph).matrix_world, dtype=float)
        require(abs(np.linalg.det(matrix[:3, :3])) > 0, "must not be scaled to nothing", 0.0, "scale")
    return transformed(mesh, matrix[:3, :3], matrix[:3, 3])


def keep_empty(context, part, volume):
    """A new object of the volume that must stay empty, drawn as a wire, with the part's name."""
    made = bpy.data.meshes.new(f"{part.name} Removal")
    meshes.write(made, volume.astype("f4"))
    ob = placing.link(context, made)
    ob.display_type = "WIRE"
    ob.hide_render = True
    return ob


def animate(part, path, start, frames):
    """Keyframes of an object on its path, from a frame on, so many for each leg.

    On a leg that turns each frame has a key: what is between two is no screw.
    """
    here = np.array(part.matrix_world, dtype=float)
    matrices = path.matrices(frames)
    straight = [not leg.turns for leg in path.legs]
    rotated = {"QUATERNION": "rotation_quaternion", "AXIS_ANGLE": "rotation_axis_angle"}
    channels = "location", rotated.get(part.rotation_mode, "rotation_euler")
    for step, matrix in enumerate(matrices):
        if step % frames and straight[step // frames]:
            continue
        part.matrix_world = Matrix((matrix @ here).tolist())
        for channel in channels:
            part.keyframe_insert(channel, frame=start + step)
    part.matrix_world = Matrix(here.tolist())
    for curve in curves(part, channels):
        for key in curve.keyframe_points:
            if start <= key.co.x < start + len(matrices):  # others are the person's own
                key.interpolation = "LINEAR"
    return start + len(matrices) - 1


def curves(ob, channels):
    """The curves of some channels in an object's action."""
    data = ob.animation_data
    bags = [strip.channelbag(data.action_slot) for layer in data.action.layers for strip in layer.strips]
    return [curve for bag in bags if bag for curve in bag.fcurves if curve.data_path in channels]

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One function that makes a mesh from its parameters anew, and does nothing where nothing has changed."""

import bpy
import numpy as np

from ..bridge import meshes, objects
from ..core.declared.parameters import ShapeError
from ..core.declared.plain import VERSION
from ..core.later import later
from ..core.shapes.generalized_cylinder import GeneralizedCylinder
from .drawing_thread import in_drawing_thread, is_drawing_thread

solvers, texts, reading = later("bridge.solvers"), later("bridge.texts"), later("properties.reading")
joined = later("core.meshes.joining", "joined")
digest = later("core.declared.digest", "digest")

AWAITED = "AWAITED"
SHAPE_KEYS = "The mesh has shape keys, which a new mesh would lose: remove them, or Apply to keep the mesh as it is"


def rebuild(mesh, depsgraph=None):
    """Make a mesh from its parameters, unless it already is.

    Parameters
    ----------
    mesh : bpy.types.Mesh
        The original. One in Edit Mode is left alone; a linked one follows its keyframes, drivers and inputs too.
    depsgraph : bpy.types.Depsgraph, optional
        Where animated parameters and inputs are read; a render has its own and gives nothing back to the originals.
    """
    sweep = mesh.sweep
    if sweep.kind == "NONE" or mesh.is_editmode:
        return
    if objects.is_written(mesh) and not is_rendered(depsgraph):
        texts.follow(mesh)
        reading.begin()
    source = source_of(mesh, depsgraph)
    try:
        if mesh.shape_keys:
            raise ShapeError(SHAPE_KEYS)
        shapes = objects.shapes(source, depsgraph)
        wanted, later = digest(shapes), waits(depsgraph)
        if wanted == sweep.made and not sweep.error and (later or not sweep.solid):
            return
        room = meshes.room_for_places(mesh) if len(shapes) == 1 and is_drawing_thread() else None
        made = [(surface if later else mesh_of)(shape, room) for shape in shapes]
        if None in made and objects.GOES_ON.get():
            made, later = list(map(mesh_of, shapes)), False
    except ShapeError as error:
        in_drawing_thread(set_if_other, sweep, "error", str(error))
        return
    if None in made:  # there is nothing to see at once: the last mesh stays until this one is made
        sweep.made = wanted
        for name, value in (("error", ""), ("solid", AWAITED)):
            set_if_other(sweep, name, value)
        return
    made = joined(made)
    in_drawing_thread(put, mesh, made, wanted, room, AWAITED if later and any(map(wants_solid, shapes)) else "")


def source_of(mesh, depsgraph):
    """The mesh whose parameters count: the evaluated one, or the original if a text was read since."""
    if not depsgraph:
        return mesh
    evaluated = mesh.evaluated_get(depsgraph)
    if not objects.is_written(mesh):
        return evaluated
    read, now = (getattr(*objects.text_of(each)) for each in (evaluated, mesh))
    return mesh if read != now else evaluated


def put(mesh, made, wanted, room=None, solid=""):
    """Write what was made of a mesh's parameters, whose digest is given, and whether their solid is still awaited.

    Its vertices may have been drawn where there was room for them.
    """
    sweep = mesh.sweep
    if objects.is_grown(mesh):
        for _ in range(len(mesh.materials), int(made.topology.material.max(initial=0)) + 1):
            mesh.materials.append(None)  # a slot of each colour, for people to fill
        if len(made.offsets) == 1:
            solvers.lose_faces(mesh)
    known = ("", "") if sweep.edited else (sweep.topology, sweep.texture)
    sweep.topology, sweep.texture, sweep.mark = meshes.write(mesh, made, *known, room)
    sweep.made, sweep.rings, sweep.version = wanted, made.rings, VERSION
    for name, value in (("error", ""), ("told", "\n".join(made.told)), ("edited", False), ("solid", solid)):
        set_if_other(sweep, name, value)


def is_rendered(depsgraph):
    """Whether a render asks, or another thread, as that of an export."""
    return bool(depsgraph and depsgraph.mode == "RENDER") or not is_drawing_thread()


def waits(depsgraph):
    """Whether somebody sees the surface while a solid is made: there is a window, and this is no render."""
    return not bpy.app.background and not is_rendered(depsgraph)


def wants_solid(shape):
    """Whether a shape is to be a solid; one that never meets itself cannot be asked."""
    return getattr(shape, "make_solid", False)


def surface(shape, room=None):
    """The mesh of a shape, without what takes long; None where nothing can be made at once."""
    return shape.surface(dtype=np.float32) if wants_solid(shape) else mesh_of(shape, room)


def mesh_of(shape, room=None):
    """The mesh of a shape, its vertices where there is room if drawing them is the last that is done."""
    if room and isinstance(shape, GeneralizedCylinder) and not shape.make_solid:
        return shape.surface(np.float32, room)
    return shape.mesh(dtype=np.float32)


def differs(mesh):
    """Whether somebody has changed a mesh since it was made from its parameters."""
    try:
        made = [(surface if mesh.sweep.solid else mesh_of)(shape) for shape in objects.shapes(mesh)]
    except ShapeError:
        return False
    return None in made or not meshes.equal(mesh, joined(made))


def set_if_other(sweep, name, value):
    """Set a property only where it changes: setting one marks the mesh as updated, which calls the handlers again."""
    if getattr(sweep, name) != value:
        setattr(sweep, name, value)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What makes sweeps follow keyframes, drivers and their input objects: handlers that look only at what was updated."""

import bpy
from bpy.app.handlers import persistent

from ..core.later import later
from . import drawing_thread, rendering
from .rendering import held, sweeps

mark = later("bridge.meshes", "mark")
has_fast = later("bridge.solvers", "has_fast")
follow = later("bridge.texts", "follow")
inputs, is_written = later("bridge.objects", "inputs", "is_written")
renders_otherwise = later("bridge.objects", "renders_otherwise")
finding, reading = later("properties.finding"), later("properties.reading")
differs, rebuild, set_if_other = later("properties.live", "differs", "rebuild", "set_if_other")

INPUTS = {"CURVE", "FONT", "EMPTY", "MESH"}


@persistent
def after_update(scene, depsgraph):
    """An input object was edited or moved, a driver's input moved, or a mesh was edited by hand."""
    for mesh in remade(touched(depsgraph.updates), depsgraph):
        if mesh.is_editmode:
            set_if_other(mesh.sweep, "edited", True)
        elif mesh.is_editable:
            changed = differs(mesh) if mesh.sweep.edited else mark(mesh) != mesh.sweep.mark
            set_if_other(mesh.sweep, "edited", changed)
        if finding.is_due(mesh):
            finding.soon()


@persistent
def after_frame(scene, depsgraph):
    """Time has passed, for meshes or input objects that keyframes and drivers move; or a render has begun."""
    rendered = filter(renders_otherwise, sweeps()) if depsgraph.mode == "RENDER" else ()
    for mesh in remade(touched(depsgraph.updates).union(rendered), depsgraph):
        if finding.is_due(mesh):
            finding.soon()


def remade(meshes, depsgraph):
    """Make meshes anew for what evaluates the scene, and yield those that the window may look at."""
    for mesh in meshes:
        if not drawing_thread.is_drawing_thread():
            held.remake(mesh, depsgraph)
        elif mesh not in held:  # else it is as a render asks for, whose end brings back what is shown
            rebuild(mesh, depsgraph)
            yield mesh


@persistent
def after_history(*_):
    """Undo, redo or a file bring meshes that may not have been looked at, and texts that people may edit."""
    if any(map(is_written, sweeps())):
        reading.begin()
    if any(finding.is_due(mesh) for mesh in sweeps()):
        finding.soon()


@persistent
def at_file(*_):
    """A script may have written into a text, of which Blender tells nobody: a file has mesh and text together."""
    for mesh in filter(is_written, sweeps()):
        follow(mesh)


@persistent
def after_load(*_):
    """A file may have trees whose solver this Blender lacks, which then leaves their steps out without a word."""
    modifiers = (modifier for ob in bpy.data.objects for modifier in ob.modifiers)
    if any(modifier.type == "BOOLEAN" and modifier.solver == "MANIFOLD" for modifier in modifiers):
        has_fast()  # the sidebar tells what is known


@persistent
def after_overrides(*_):
    """A file holds the parameters of a library override, and of its mesh nothing: that comes from the library."""
    for mesh in sweeps():
        if mesh.override_library:
            rebuild(mesh)


@persistent
def after_render(scene, *_):
    """A render leaves the mesh of its last frame behind: the frame that is shown comes back."""
    drawing_thread.in_drawing_thread(held.release)


@persistent
def before_evaluation(*_):
    if drawing_thread.is_drawing_thread():
        drawing_thread.window.before_evaluation()


@persistent
def after_evaluation(*_):
    if drawing_thread.is_drawing_thread():
        drawing_thread.window.after_evaluation()


@persistent
def before_close(*_):
    drawing_thread.window.before_close()


def touched(updates):
    """The sweeps that were updated themselves, or whose input objects were."""
    updated = [update.id for update in updates]
    meshes = {each.original for each in updated if isinstance(each, bpy.types.Mesh)}
    return {mesh for mesh in meshes if mesh.sweep.kind != "NONE"} | users_of(changed_inputs(updated))


def changed_inputs(updated):
    """The original objects that may be inputs among the updated data, and the empties whose children they are."""
    found = {each.original for each in updated if isinstance(each, bpy.types.Object) and each.type in INPUTS}
    parents = (ob.parent for ob in found if ob.type == "EMPTY" and ob.parent)
    found |= {ob for ob in parents if ob.type == "EMPTY"}
    return set(filter(is_used, found))


def is_used(ob):
    """Whether anything but collections uses an object: to list these takes as long as they have objects.

    The one user of what is to be seen is a collection.
    """
    alone = ob.users == 1 and ob.visible_get()
    return not alone and ob.users > len(ob.users_collection)


def users_of(changed):
    """The meshes that are made from any of some objects."""
    if not changed:
        return set()
    users = bpy.data.user_map(subset=changed, value_types={"MESH"}).values()
    sweeps = (mesh for mesh in set().union(*users) if mesh.sweep.kind != "NONE")
    return {mesh for mesh in sweeps if not changed.isdisjoint(inputs(mesh).values())}


HANDLERS = (
    (bpy.app.handlers.depsgraph_update_pre, before_evaluation),
    (bpy.app.handlers.frame_change_pre, before_evaluation),
    (bpy.app.handlers.depsgraph_update_post, after_evaluation),
    (bpy.app.handlers.frame_change_post, after_evaluation),
    (bpy.app.handlers.depsgraph_update_post, after_update),
    (bpy.app.handlers.frame_change_post, after_frame),
    (bpy.app.handlers.render_complete, after_render),
    (bpy.app.handlers.render_cancel, after_render),
    (bpy.app.handlers.object_bake_complete, after_render),
    (bpy.app.handlers.object_bake_cancel, after_render),
    (bpy.app.handlers.save_pre, at_file),
    (bpy.app.handlers.undo_post, after_history),
    (bpy.app.handlers.redo_post, after_history),
    (bpy.app.handlers.load_pre, before_close),
    (bpy.app.handlers.load_post, after_history),
    (bpy.app.handlers.load_post, after_load),
    (bpy.app.handlers.load_post, after_overrides),
    (bpy.app.handlers.load_post, at_file),
)


def register():
    for handlers, function in HANDLERS:
        handlers.append(function)
    rendering.begin()


def unregister():
    for handlers, function in HANDLERS:
        handlers.remove(function)
    rendering.stop()
    finding.stop()
    reading.stop()

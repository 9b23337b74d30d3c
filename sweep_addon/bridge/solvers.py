# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Solvers: which of Blender's computes the steps of a tree, and why."""

from functools import cache

import bmesh
import bpy
import numpy as np

from ..core.declared.options import PREFIX
from ..core.declared.parameters import ShapeError
from ..core.later import later
from ..core.meshes import booleans
from . import objects, trees

crossings = later("bridge.crossings")

MISSING = "This Blender has no manifold solver."
FAST, SURE = "MANIFOLD", "EXACT"
NAMES = {FAST: "manifold", SURE: "exact", "FLOAT": "float", "FAST": "float"}  # as Blender writes them


def choose(ob):
    """Give all steps of a tree the solver that suits them.

    Parameters
    ----------
    ob : bpy.types.Object
        The result.

    Returns
    -------
    str
        Why it is not the faster one; nothing where it is.
    """
    why, overlapping = why_not_fast(ob), overlaps(ob)
    for modifier in trees.booleans(ob):
        operand = trees.operand_of(modifier)
        modifier.solver = SURE if why else FAST
        modifier.use_hole_tolerant = bool(why)
        modifier.use_self = overlapping or bool(operand) and overlaps(operand)
    return why


def lose_faces(mesh):
    """Have no step take a mesh that is about to lose all its faces by the manifold solver: it would end Blender 4.5."""
    for ob in bpy.data.objects:
        for modifier in trees.booleans(ob):
            operand = trees.operand_of(modifier)
            if operand and operand.data == mesh and modifier.solver == FAST:
                modifier.solver = SURE


def why_not_fast(ob):
    """Why the manifold solver cannot be used for a tree, as a sentence; nothing where it can."""
    if not has_fast():
        return f"{MISSING} The exact one is used, which is slower."
    mirrored = ob.matrix_world.is_negative
    for each in parts(ob):
        why = why_exact(each, mirrored, is_closed) or crosses(each) and f"{each.name!r} meets itself"
        if why:
            return f"{why}: the exact solver is used, which is slower."
    return ""


def why_exact(part, mirrored, closed):
    """Why a part of a tree needs the exact solver, or nothing.

    Parameters
    ----------
    part : bpy.types.Object
    mirrored : bool
        Whether the result's axes are left-handed, by the matrices that were last evaluated.
    closed : callable
        `is_closed`, or `seems_closed` where there is no time.
    """
    if not (objects.is_united(part) or closed(mesh_of(part))):
        return f"{part.name!r} is not closed and manifold"
    if is_plant(part):
        return f"{part.name!r} overlaps itself where it branches, and the manifold solver would count that twice"
    if part.matrix_world.is_negative != mirrored:
        return f"{part.name!r} is mirrored, which the manifold solver turns inside out"
    return ""


def lacking():
    """What is known of a manifold solver that is not there: nothing before somebody has asked for it."""
    return MISSING if has_fast.cache_info().currsize and not has_fast() else ""


@cache
def has_fast():
    """Whether this Blender's manifold solver does anything: some are built without it, and it is offered all the same.

    Asked once, of two cubes in a scene of their own.
    """
    if FAST not in bpy.types.BooleanModifier.bl_rna.properties["solver"].enum_items:
        return False
    scene, made = bpy.data.scenes.new("Solver"), []
    try:
        for size in (1.0, 2.0):
            mesh = bpy.data.meshes.new("Solver")
            cube = bmesh.new()
            bmesh.ops.create_cube(cube, size=size)
            cube.to_mesh(mesh)
            cube.free()
            made.append(bpy.data.objects.new("Solver", mesh))
            scene.collection.objects.link(made[-1])
        made[0].location.x = 1.0
        modifier = made[1].modifiers.new("Solver", "BOOLEAN")
        modifier.object, modifier.solver = made[0], FAST
        with bpy.context.temp_override(scene=scene, view_layer=scene.view_layers[0]):
            shown = made[1].evaluated_get(bpy.context.evaluated_depsgraph_get()).data
            return len(shown.vertices) != len(made[1].data.vertices)
    finally:
        bpy.data.scenes.remove(scene)
        bpy.data.batch_remove([*made, *(ob.data for ob in made)])


def parts(ob):
    """The objects whose own meshes a tree is of: the result and its operands, and theirs."""
    return parts_of([ob], {})


def parts_of(todo, found):
    """Objects and those whose own meshes they are of, after some that were found before, the keys of a dictionary."""
    while todo:
        new = [other for other in dict.fromkeys(todo) if other not in found]
        found |= dict.fromkeys(new)
        todo = [operand for other in new if len(other.modifiers) for operand in trees.operands(other)]
    return list(found)


def mesh_of(ob):
    """The mesh that an object brings to a tree: its own if it is a tree itself, or as its modifiers leave it."""
    if not len(ob.modifiers) or trees.is_tree(ob):
        return ob.data
    return ob.evaluated_get(bpy.context.evaluated_depsgraph_get()).data


def doubtful(bare, mirrored):
    """Of parts without modifiers those of which there may be something to tell, by one quick look at each.

    Parameters
    ----------
    bare : iterable of bpy.types.Object
    mirrored : bool
        Whether the result's axes are left-handed, by the matrices that were last evaluated.

    Returns
    -------
    list of bpy.types.Object
        What is open, mirrored or a plant, and what was found to meet itself.
    """
    found = []
    for part in bare:
        mesh = part.data
        sweep, edges = mesh.sweep, len(mesh.edges)
        closed = len(mesh.loops) == 2 * edges > 0
        if not closed or sweep.places or sweep.kind == objects.GROWN or part.matrix_world.is_negative != mirrored:
            found.append(part)
    return found


def seen_exact(parts, mirrored):
    """Why a tree needs the exact solver, as far as a draw has time to look at some parts of it, or nothing."""
    return next(filter(None, (why_exact(part, mirrored, seems_closed) for part in parts)), "")


def known_to_cross(parts):
    """The parts of a tree that meet themselves, as far as it has been looked for."""
    return [part for part in parts if PREFIX in part.data.sweep.places and is_known_to_cross(part)]


def seems_closed(mesh):
    """Whether there are as many sides of edges as faces have: all that a draw has time for."""
    return len(mesh.loops) == 2 * len(mesh.edges) > 0


def is_closed(mesh):
    """Whether each edge has two faces that run along it in opposite directions."""
    if not seems_closed(mesh):
        return False
    corners, along = np.empty((2, len(mesh.loops)), np.int32)
    ends = np.empty(2 * len(mesh.edges), np.int32)
    mesh.attributes[".corner_vert"].data.foreach_get("value", corners)
    mesh.attributes[".corner_edge"].data.foreach_get("value", along)
    mesh.attributes[".edge_verts"].data.foreach_get("value", ends)
    forward = corners == ends.reshape(-1, 2)[along, 0]
    count = len(mesh.edges)
    return bool((np.bincount(along[forward], minlength=count) == 1).all() and forward.sum() == count)


def make_solid(ob):
    """Make a sweep that meets itself a solid, since solvers keep the overlap in silence.

    Returns
    -------
    str
        What a person should know of one that cannot be made a solid; nothing for any other.
    """
    if not crosses(ob):
        return ""
    _, group = objects.group_of(ob.data)
    if hasattr(group, "make_solid") and ob.data.is_editable:
        group.make_solid = True
        return ""
    return f"{ob.name!r} meets itself: where it does, what is left of it is undefined."


def unite(operand):
    """Make the tubes of a plant that is an operand one solid, which the faster solver takes, leaves or not.

    Returns
    -------
    str
        What a person should know; nothing for any other, and where there is no manifold3d to unite them.
    """
    if not is_plant(operand) or trees.is_tree(operand) or not operand.data.is_editable:
        return ""
    group = operand.data.sweep.plant
    if group.output != "TUBES" or not booleans.is_there():
        return ""
    without = "" if seems_closed(operand.data) else ", without its leaves"
    group.output_tubes_united = True
    return f"{operand.name!r} is united now, as Output says in the sidebar{without}."


def is_plant(ob):
    """Whether an object is a plant, whose tubes begin in others."""
    return objects.is_sweep(ob) and objects.is_grown(ob.data) and not objects.is_united(ob)


def overlaps(ob):
    """Whether an object's own mesh may overlap itself and is closed: the exact solver unites no other."""
    return (is_plant(ob) or crosses(ob)) and seems_closed(ob.data)


def lost_faces(ob):
    """What a person should know of a plant that no solver takes whole: its leaves; nothing for any other."""
    if seems_closed(ob.data) or not is_plant(ob):
        return ""
    if len(ob.data.polygons) == 0:
        return f"{ob.name!r} is edges alone: it cuts nothing."
    return f"{ob.name!r} has open faces: leaves cut nothing, and where its tubes overlap the result is undefined."


def crosses(ob):
    """Whether an object is a sweep that meets itself and is to be no solid."""
    if not objects.is_sweep(ob) or getattr(objects.group_of(ob.data)[1], "make_solid", False):
        return False
    try:
        return any(sentence.startswith(PREFIX) for sentence in crossings.told(ob.data, searched=False))
    except ShapeError:
        return False  # why it cannot be made is told already


def is_known_to_cross(ob):
    """The same as far as it has been looked for."""
    sweep = ob.data.sweep
    if PREFIX not in sweep.places or sweep.looked_at != sweep.made or not objects.is_sweep(ob):
        return False
    return not getattr(objects.group_of(ob.data)[1], "make_solid", False)

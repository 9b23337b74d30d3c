# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Operands: objects that become part of a tree, which keeps them together, and free again."""

import bpy

from ..core.declared.parameters import ShapeError
from . import sharp_edges, solvers, trees

BLENDERS = {name: identifier for identifier, name in trees.OPERATIONS.items()}
SUFFIX = "Operands"


def combine(result, operands, operation):
    """Make objects the operands of a result, which stays what it is and shows what the operation leaves.

    Parameters
    ----------
    result : bpy.types.Object
        A mesh. Keeps its parameters, if it is a sweep.
    operands : list of bpy.types.Object
        Meshes, in the order of the steps.
    operation : str
        ``union``, ``intersection`` or ``difference``.

    Returns
    -------
    tuple of str
        What a person should know: why the solver is the slower one, which plants became solids, what meets itself, and
        what cuts nothing.

    Raises
    ------
    ShapeError
        Where an operand is made from the result, or has been combined with it so just now; nothing is changed.
    """
    for operand in operands:
        require_apart(result, operand)
        require_new(result, operand, BLENDERS[operation])
    bpy.context.view_layer.update()  # of where they stand
    united = [solvers.unite(operand) for operand in operands]
    parts = [part for ob in (result, *operands) for part in solvers.parts(ob)]
    told = [told_of(part) for told_of in (solvers.make_solid, solvers.lost_faces) for part in parts]
    for operand in operands:
        adopt(result, operand)
        add_step(result, operation, operand)
    sharp_edges.draw(result)
    return tuple(filter(None, (solvers.choose(result), *united, *told)))


def require_apart(result, operand):
    """Refuse an operand that the result could not be made without being made first."""
    if operand == result or result in trees.made_from(operand):
        raise ShapeError(f"{operand.name!r} is made from {result.name!r}: that cannot be made from it in turn")


def require_new(result, operand, operation):
    """Refuse a step that would change nothing: the same one is among the last steps, and these are of one operation."""
    for step in reversed(trees.booleans(result)):
        if step.show_viewport and step.operation != operation:
            return
        if step.operation == operation and trees.operand_of(step) == operand:
            muted = "" if step.show_viewport else ", which is muted"
            said = f"{operand.name!r} is the operand of the step {step.name!r} of {result.name!r} already{muted}"
            raise ShapeError(f"{said}: the same step once more would change nothing")


def add_step(result, operation, operand):
    """One more step of a tree: its modifier."""
    modifier = result.modifiers.new(operation.title(), "BOOLEAN")
    modifier.operand_type, modifier.operation, modifier.object = "OBJECT", BLENDERS[operation], operand
    return modifier


def adopt(result, operand):
    """Draw an operand as wire, keep it out of renders, and let it move with the result; one that has a tree stays."""
    operand.display_type, operand.hide_render = "WIRE", True
    if is_adopted(operand):
        return
    below = top(operand)
    if below != top(result) and not below.constraints:  # which would move it a second time
        place = below.matrix_world.copy()
        below.parent = result
        below.matrix_parent_inverse = result.matrix_world.inverted_safe()
        below.matrix_world = place
    home = collection_of(result)
    for collection in operand.users_collection:
        collection.objects.unlink(operand)
    home.objects.link(operand)


def is_adopted(operand):
    """Whether an object moves with a tree whose operand it is."""
    return any(operand in trees.operands(above) for above in ancestors(operand))


def ancestors(ob):
    """The objects that an object moves with, the nearest first."""
    while ob.parent:
        ob = ob.parent
        yield ob


def top(ob):
    """The last of them, or the object itself: a sweep is carried by its path."""
    return [ob, *ancestors(ob)][-1]


def collection_of(result):
    """The collection in which the operands of a result are, beside the result; made where there is none."""
    homes = set(result.users_collection)
    for operand in trees.operands(result):
        for collection in operand.users_collection:
            if collection not in homes:
                return collection
    made = bpy.data.collections.new(f"{result.name} {SUFFIX}")
    for home in homes or {bpy.context.scene.collection}:
        home.children.link(made)
    return made


def extract(result, modifier):
    """Take a step out of a tree: its modifier goes, and its operand is free where it stands."""
    operand = trees.operand_of(modifier)
    result.modifiers.remove(modifier)
    if not trees.is_tree(result):
        sharp_edges.undraw(result)
    if operand and not users(operand):
        release(result, operand)


def release(result, operand):
    """Let an operand of nothing any more be an object like others, beside what was its result."""
    operand.display_type, operand.hide_render = "TEXTURED", False
    for below in [operand, *ancestors(operand)]:
        if below.parent == result:
            place = below.matrix_world.copy()
            below.parent = None
            below.matrix_world = place
            break
    homes = list(result.users_collection) or [bpy.context.scene.collection]
    for collection in set(operand.users_collection).difference(homes):
        collection.objects.unlink(operand)
        if not collection.all_objects and not collection.children:
            bpy.data.collections.remove(collection)
    for home in homes:
        if operand.name not in home.objects:
            home.objects.link(operand)


def users(operand):
    """The objects whose Boolean modifiers name an object."""
    found = bpy.data.user_map(subset={operand}, value_types={"OBJECT"})[operand]
    return [ob for ob in found if ob != operand and operand in trees.operands(ob)]


def take_apart(result):
    """Make a tree its operands again, those of operands too; what they are is what is left."""
    for modifier in trees.booleans(result):
        operand = trees.operand_of(modifier)
        extract(result, modifier)
        if operand and not users(operand):
            take_apart(operand)


def collapse(result):
    """Make a tree an ordinary mesh, as it is shown, and remove the operands that nothing else is made from."""
    others = [m for m in trees.others(result) if m.show_viewport]
    for modifier in others:
        modifier.show_viewport = False
    depsgraph = bpy.context.evaluated_depsgraph_get()
    depsgraph.update()
    made = bpy.data.meshes.new_from_object(result.evaluated_get(depsgraph), depsgraph=depsgraph)
    for modifier in others:
        modifier.show_viewport = True
    freed = trees.operands(result)
    for modifier in trees.booleans(result):
        result.modifiers.remove(modifier)
    sharp_edges.undraw(result)
    exchange(result, made)
    for operand in freed:
        remove_unused(operand)
    return made


def exchange(ob, mesh):
    """Give an object another mesh, under the name of its own once that is gone, if nobody else uses it."""
    own, name = ob.data, ob.data.name
    ob.data = mesh
    if not own.users:
        bpy.data.meshes.remove(own)
    mesh.name = name


def remove_unused(operand):
    """Remove an operand that nothing is made from, with its mesh, its own operands and a collection that is left."""
    if bpy.data.user_map(subset={operand}, value_types={"OBJECT", "MESH"})[operand] - set(children(operand)):
        return
    inner, mesh, homes = trees.operands(operand), operand.data, operand.users_collection
    for child in children(operand):
        child.parent, child.matrix_world = None, child.matrix_world.copy()
    bpy.data.objects.remove(operand)
    if not mesh.users:
        bpy.data.meshes.remove(mesh)
    for collection in homes:
        if not collection.all_objects and not collection.children and collection.users:
            bpy.data.collections.remove(collection)
    for each in inner:
        remove_unused(each)


def children(ob):
    """The objects that are parented to an object."""
    found = bpy.data.user_map(subset={ob}, value_types={"OBJECT"})[ob]
    return [other for other in found if other.parent == ob]

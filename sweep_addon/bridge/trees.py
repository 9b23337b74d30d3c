# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweep-CSG trees as Blender has them: objects and their Boolean modifiers, in the order of the stack.

Nothing else remembers a tree. One that somebody makes or changes by hand in the modifiers' own panel is read as well.
"""

import bpy
import numpy as np

from ..core.csg import Placed, RigidMotion, Step, SweptSolid, Tree
from ..core.csg.tree import DEEPEST
from ..core.declared.parameters import ShapeError, at, require
from ..core.shapes.general_sweep import GeneralSweep
from ..core.solids import Triangles
from ..core.variation.laws import Constant
from . import models, objects
from .recognizing import booleans, is_tree, operand_of, operands
from .sharp_edges import is_drawer

OPERATIONS = {"UNION": "union", "INTERSECT": "intersection", "DIFFERENCE": "difference"}
ROUNDING = 1e-6  # of matrices, which Blender keeps in single precision
SHAPELESS = {"scale_x": Constant(1.0), "scale_y": Constant(1.0), "scale_z": Constant(1.0)}
SHAPELESS |= {"deform_x": "x", "deform_y": "y", "deform_z": "z"}  # what a motion is that leaves the shape alone


def is_lost(modifier):
    """Whether the operand of a step was deleted, or none is chosen."""
    return modifier.operand_type == "OBJECT" and modifier.object is None


def is_empty(ob):
    """Whether nothing is left of a tree."""
    return len(ob.evaluated_get(bpy.context.evaluated_depsgraph_get()).data.vertices) == 0


def parted(ob):
    """The Boolean modifiers of an object, and those that are no part of the tree, but for one that draws its cuts."""
    taken, rest = [], []
    for modifier in ob.modifiers:
        (taken if modifier.type == "BOOLEAN" else rest).append(modifier)
    return taken, [modifier for modifier in rest if not is_drawer(modifier)]


def others(ob):
    """The modifiers of a tree that are no part of it, but for the one that draws its cuts as edges."""
    return parted(ob)[1]


def steps(ob):
    """The Boolean modifiers of an object that do something: neither muted nor without an operand."""
    return [modifier for modifier in booleans(ob) if modifier.show_viewport and operand_of(modifier)]


def made_from(ob):
    """All objects that an object's shown mesh follows: operands, inputs of sweeps, and what those follow; a set."""
    found, todo = set(), [ob]
    while todo:
        other = todo.pop()
        inputs = objects.inputs(other.data).values() if objects.is_sweep(other) else ()
        new = {each for each in (*operands(other), *inputs) if each and each not in found}
        found |= new
        todo += new
    return found


def picked(ob):
    """The step that a person has picked, with the object that has it: the active modifiers say so; None for the base.

    Of a step whose operand is a tree that may be one of its steps.
    """
    found, seen = None, set()
    while ob and ob not in seen:
        seen.add(ob)
        modifier = getattr(ob, "modifiers", None) and ob.modifiers.active
        if not modifier or modifier.type != "BOOLEAN":
            break
        found, ob = (ob, modifier), operand_of(modifier)
    return found


def pick(ob, owner, step):
    """Pick a step of a tree, of an operand too: make its modifier the active one, and those that lead to it."""
    for above, modifier in path(ob, owner):
        above.modifiers.active = modifier
    owner.modifiers.active = step
    operand = operand_of(step)
    if operand and is_tree(operand):
        operand.modifiers.active = None


def path(ob, owner):
    """The steps, each with its object, that lead from a tree to an object that is made into it: the first such way."""
    todo, seen = [(ob, ())], set()
    while todo:
        ob, above = todo.pop()
        if ob == owner:
            return above
        if ob and ob not in seen:
            seen.add(ob)
            todo += [(operand_of(step), (*above, (ob, step))) for step in reversed(booleans(ob))]
    return ()


def read(ob):
    """What an object shows as a value: a `Tree`, a shape, or the triangles of any other mesh.

    Parameters
    ----------
    ob : bpy.types.Object
        A mesh. Where it has Boolean modifiers, its other modifiers are no part of what is read.

    Returns
    -------
    Operand
        In the space of the object.

    Raises
    ------
    ShapeError
        Where parameters are refused, a modifier takes a collection, or an object is made from itself.
    """
    return node(ob, bpy.context.evaluated_depsgraph_get(), (), {})


def node(ob, depsgraph, above, known):
    """What an object shows, of which those above it are made; what objects show that were read before is known."""
    if ob in above:
        raise ShapeError(f"must not be made from itself, as {ob.name!r} is")
    require(len(above) <= DEEPEST, f"must be at most {DEEPEST} trees deep", len(above))
    if ob not in known:
        known[ob] = (tree if is_tree(ob) else leaf)(ob, depsgraph, (*above, ob), known)
    return known[ob]


def tree(ob, depsgraph, above, known):
    """The tree of an object that has Boolean modifiers."""
    with at("base"):
        base = leaf(ob, depsgraph, above, known)
    made = []
    for number, modifier in enumerate(steps_of_objects(ob), 1):
        with at(f"steps.{number}.operand"):
            operand = node(modifier.object, depsgraph, above, known)
        made.append(Step(OPERATIONS[modifier.operation], placed(operand, between(ob, modifier.object, depsgraph))))
    return Tree(base, made)


def steps_of_objects(ob):
    """The steps of an object, refused where one takes a collection and not an object."""
    for modifier in booleans(ob):
        if modifier.show_viewport and modifier.operand_type != "OBJECT":
            raise ShapeError(f"{modifier.name!r} of {ob.name!r} must take an object, got a collection")
    return steps(ob)


def leaf(ob, depsgraph, above, known):
    """What an object's own mesh is: its shape, or its triangles, those of an object without steps as modifiers leave
    them."""
    if objects.is_sweep(ob) and not objects.is_swept(ob) and (is_tree(ob) or models.is_as_shown(ob)):
        return objects.shapes(ob.data)[0]
    if not objects.is_swept(ob):
        bare = is_tree(ob) and not ob.data.is_editmode
        return of_mesh(ob) if bare else models.triangles(ob, depsgraph, scaled=False)
    found = objects.shapes(ob.data)
    generator = generator_of(ob)
    if generator:
        with at("generator"):
            solid = placed(node(generator, depsgraph, above, known), np.diag((*generator.scale, 1.0)))
        found = [swept(shape, solid) for shape in found]
    return found[0] if len(found) == 1 else Tree(found[0], [Step("union", other) for other in found[1:]])


def of_mesh(ob):
    """The triangles of an object's own mesh, whatever its modifiers make of it."""
    vertices, faces = models.arrays(ob.data, ob)
    return Triangles(vertices.reshape(-1, 3), faces.reshape(-1, 3))


def generator_of(ob):
    """The sweep or the tree that moves in the motion of an object that is a rigid general sweep; None for another."""
    shape, group = objects.group_of(ob.data)
    if shape is not GeneralSweep or group.generator != "OBJECT":
        return None
    generator = group.generator_object
    made = is_tree, objects.is_swept, objects.is_united
    followed = generator and generator.type == "MESH" and any(of_object(generator) for of_object in made)
    return generator if followed and is_rigid(objects.shapes(ob.data)[0]) else None


def is_rigid(sweep):
    """Whether a general sweep leaves the shape of its generator alone."""
    return all(getattr(sweep, name) == value for name, value in SHAPELESS.items())


def swept(sweep, solid):
    """The motion of a general sweep as that of a solid."""
    turns = {f"turn_{axis}": getattr(sweep, f"turn_{axis}") for axis in "xyz"}
    return SweptSolid(solid, RigidMotion(sweep.trajectory, sweep.frame, **turns), sweep.cells)


def between(ob, other, depsgraph):
    """Where another object stands in the space of an object: (4, 4) float array."""
    base, operand = (np.array(each.evaluated_get(depsgraph).matrix_world, dtype=float) for each in (ob, other))
    require_extent(ob, base)
    return np.linalg.solve(base, operand)


def require_extent(ob, matrix):
    """Refuse an object whose matrix scales it to nothing along an axis: nothing has a place in its space."""
    if not np.linalg.det(matrix[:3, :3]):
        raise ShapeError(f"must not be scaled to nothing, as {ob.name!r} is")


def placed(operand, matrix):
    """An operand somewhere else; itself where that is nowhere else, but for single precision."""
    size = max(np.abs(matrix).max(), 1.0)
    return operand if np.abs(matrix - np.eye(4)).max() < ROUNDING * size else Placed(operand, matrix[:3])

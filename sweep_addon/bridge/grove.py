# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trees made objects: a live object for each sweep, a mesh for each other solid, a Boolean modifier for each step."""

from dataclasses import replace

import bpy
import numpy as np
from mathutils import Matrix

from ..core.csg import Placed, SweptSolid, Tree
from ..core.csg.meshes import closed_mesh
from ..core.declared.parameters import ShapeError, at, spelled
from ..core.resolving import OPEN
from ..core.shapes.kinds import SHAPES
from ..core.solids import Triangles
from . import meshes, objects, operands, sharp_edges, solvers, trees

HERE = np.eye(4)


def to_object(operand, name=None, called=None):
    """An operand as a live object of the scene: a tree with its operands in a collection beside it.

    Parameters
    ----------
    operand : Operand
    name : str, optional
    called : callable, optional
        Gives the name of an operand's object; by default what it is.

    Returns
    -------
    bpy.types.Object
        The result, in the scene's collection.

    Raises
    ------
    ShapeError
        Where a part cannot be made; the scene is as it was.
    """
    name = name or objects.title(type(operand))
    grove = Grove(bpy.data.collections.new(f"{name} {operands.SUFFIX}"), called or kind)
    try:
        place = place_of(operand)
        sheared = is_sheared(place)  # which no object without a parent can be
        ob = grove.mesh_object(operand.mesh(), name) if sheared else grove.grown(operand, name)
    except ShapeError:
        grove.fell()
        raise
    ob.matrix_basis = Matrix((HERE if sheared else place).tolist())
    grove.collection.objects.unlink(ob)
    bpy.context.scene.collection.objects.link(ob)
    if grove.collection.objects:
        bpy.context.scene.collection.children.link(grove.collection)
    else:
        bpy.data.collections.remove(grove.collection)
    bpy.context.view_layer.update()  # of matrices, which say what is mirrored
    for part in filter(trees.is_tree, solvers.parts(ob)):
        solvers.choose(part)
        sharp_edges.draw(part)
    return ob


class Grove:
    """The objects that are being made of a tree, in one collection."""

    def __init__(self, collection, called):
        self.collection, self.called = collection, called

    def fell(self):
        """Remove all that was made."""
        made = list(self.collection.objects)
        bpy.data.batch_remove([*made, *{ob.data for ob in made}, self.collection])

    def grown(self, operand, name):
        """The object of an operand, whose place is still to be given to it."""
        if isinstance(operand, Tree):
            return self.tree(operand, name)
        if isinstance(operand, Placed):
            return self.grown(operand.solid, name)
        if isinstance(operand, SweptSolid):
            return self.swept_solid(operand, name)
        if hasattr(operand, "sweep"):
            operand = operand.sweep()
        if isinstance(operand, SHAPES):
            ob = self.linked(objects.new_mesh(solid(operand), name))
            require_closed(ob.data)
            return ob
        return self.mesh_object(operand.mesh(), name)

    def tree(self, tree, name):
        """The object of a tree's base with a modifier for each step."""
        with at("base"):
            sheared = is_sheared(place_of(tree.base))
            result = self.mesh_object(closed_mesh(tree.base), name) if sheared else self.grown(tree.base, name)
        for number, step in enumerate(tree.steps, 1):
            with at(f"steps.{number}.operand"):
                ob = self.grown(step.operand, self.called(step.operand))
            self.attach(ob, result, np.linalg.solve(place_of(tree), place_of(step.operand)))
            operands.add_step(result, spelled(step.operation), ob)
        return result

    def swept_solid(self, node, name):
        """The object of a general sweep whose generator is the object of the solid."""
        with at("solid"):
            moved = not np.array_equal(place_of(node.solid), HERE)  # a generator is read in its own space
            called = self.called(node.solid)
            ob = self.mesh_object(closed_mesh(node.solid), called) if moved else self.grown(node.solid, called)
        sweep = self.linked(objects.new_mesh(node.sweep(Triangles()), name, generator=ob))
        self.attach(ob, sweep, HERE)
        return sweep

    def mesh_object(self, mesh, name):
        """The object of a mesh that has no parameters."""
        made = bpy.data.meshes.new(name)
        meshes.write(made, mesh.astype("f4"))
        return self.linked(made)

    def linked(self, mesh):
        ob = bpy.data.objects.new(mesh.name, mesh)
        self.collection.objects.link(ob)
        return ob

    def attach(self, ob, parent, place):
        """Let an operand move with its result, drawn as wire and not rendered."""
        ob.parent, ob.display_type, ob.hide_render = parent, "WIRE", True
        if is_sheared(place):  # which location, rotation and scale do not say
            ob.matrix_parent_inverse = Matrix(place.tolist())
        else:
            ob.matrix_basis = Matrix(place.tolist())


def place_of(operand):
    """Where the object of an operand stands in the operand's space: (4, 4) float array."""
    if isinstance(operand, Placed):
        return np.vstack((operand.matrix.values, HERE[3])) @ place_of(operand.solid)
    if isinstance(operand, Tree):
        place = place_of(operand.base)
        return HERE if is_sheared(place) else place
    return HERE


def solid(shape):
    """A shape that is to be an operand: one that meets itself is made a solid first, tubes of plants are united."""
    if hasattr(shape, "united"):
        return replace(shape, output=replace(shape.output, united=True))
    if hasattr(type(shape), "__dataclass_fields__") and "make_solid" in type(shape).__dataclass_fields__:
        return replace(shape, make_solid=True) if shape.self_intersections() else shape
    return shape


def require_closed(mesh):
    """Refuse a mesh of which an edge has not two faces: solvers take it, and leave something that is no solid."""
    edges = np.empty(len(mesh.loops), dtype=np.int32)
    mesh.loops.foreach_get("edge_index", edges)
    if (np.bincount(edges, minlength=len(mesh.edges)) != 2).any():
        raise ShapeError(OPEN)


def kind(operand):
    """How an operand's object is called: by what it is, a tree by its base."""
    while isinstance(operand, (Tree, Placed)):
        operand = operand.base if isinstance(operand, Tree) else operand.solid
    return objects.title(type(operand))


def is_sheared(matrix):
    """Whether a matrix is more than a place, a turn and a scale along the axes of what it moves."""
    axes = matrix[:3, :3] / np.linalg.norm(matrix[:3, :3], axis=0)
    return np.abs(axes.T @ axes - np.eye(3)).max() > trees.ROUNDING

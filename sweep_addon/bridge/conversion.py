# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Extruded sweeps of a scene as live trees of primitives, and such trees as sweeps again."""

import dataclasses

import bpy

from ..core.contours import Outline
from ..core.conversion import kind, sweep_to_csg
from ..core.conversion.evaluation import csg_to_sweep
from ..core.csg import Tree
from . import arcs, grove, objects, operands, sharp_edges, trees


def to_tree(ob):
    """Replace an extruded sweep by the live tree of primitives that it is, each named by its kind.

    Parameters
    ----------
    ob : bpy.types.Object
        Keeps its name, its place, its materials and its modifiers, those of the tree before them.

    Raises
    ------
    ShapeError
        For what is no extrusion without draft; nothing is changed.
    """
    value = sweep_to_csg(extrusion(ob))
    made = grove.to_object(value, ob.name, called)
    solver = [modifier.solver for modifier in trees.booleans(made)]
    for number, modifier in enumerate(trees.booleans(made)):
        step = operands.add_step(ob, trees.OPERATIONS[modifier.operation], modifier.object)
        step.solver = solver[number]
        modifier.object.parent = ob
        ob.modifiers.move(list(ob.modifiers).index(step), number)
    home = operands.collection_of(ob) if value.steps else None
    if home and home in list(bpy.context.scene.collection.children):
        bpy.context.scene.collection.children.unlink(home)
        for collection in ob.users_collection:
            collection.children.link(home)
    replace(ob, made.data)
    bpy.data.objects.remove(made)
    if value.steps:
        sharp_edges.draw(ob)


def extrusion(ob):
    """The shape of a sweep; of a contour that a curve or a text stands for, which is flattened, with its arcs."""
    shape = objects.shapes(ob.data)[0]
    drawn = "contour" in objects.inputs(ob.data) and isinstance(shape.contour, Outline) and shape.contour.closed
    if not drawn:
        return shape
    return dataclasses.replace(shape, contour=arcs.recovered(shape.contour))


def primitives(ob):
    """How many meshes an object's tree is made of."""
    return 1 + sum(primitives(trees.operand_of(modifier)) for modifier in trees.steps(ob))


def called(operand):
    """How the object of a primitive is called."""
    while isinstance(operand, Tree):
        operand = operand.base
    return (kind(operand) or "primitive").title()


def to_sweep(ob):
    """Replace a tree of extrusions by the one extruded outline that it is.

    Raises
    ------
    ShapeError
        For a tree of anything else; nothing is changed.
    """
    mesh = objects.new_mesh(csg_to_sweep(trees.read(ob)))
    freed = trees.operands(ob)
    for modifier in trees.booleans(ob):
        ob.modifiers.remove(modifier)
    sharp_edges.undraw(ob)
    replace(ob, mesh)
    for operand in freed:
        operands.remove_unused(operand)


def replace(ob, mesh):
    """Give an object another mesh with the name and the materials of its own."""
    for slot, material in enumerate(ob.data.materials):
        if slot < len(mesh.materials):
            mesh.materials[slot] = material
    operands.exchange(ob, mesh)

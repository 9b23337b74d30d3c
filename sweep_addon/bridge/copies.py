# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Copies of trees: the result with the objects that it is made from, and their meshes and curves.

Actions, materials and what drivers read stay shared, as in Blender's own copies by script.
"""

from ..core.declared.parameters import parameters
from . import objects, operands, rna, trees


def duplicate(result):
    """A copy of a tree, with its operands, the meshes and curves of all of them, and their own modifiers and inputs.

    Returns
    -------
    bpy.types.Object
        The copy of the result, where that is.
    """
    twins = {ob: ob.copy() for ob in (result, *sorted(trees.made_from(result), key=lambda ob: ob.name))}
    data = {each: each.copy() for each in dict.fromkeys(ob.data for ob in twins if ob.data)}
    for ob, twin in twins.items():
        twin.data = data.get(ob.data)
        redirect(twin, twins)
    for mesh in data.values():
        if getattr(getattr(mesh, "sweep", None), "kind", "NONE") != "NONE":
            feed(mesh, twins)
    settle(result, twins)
    return twins[result]


def redirect(twin, twins):
    """Let a copy name the copies of what its original names."""
    twin.parent = twins.get(twin.parent, twin.parent)
    for holder, name in (*((m, "object") for m in twin.modifiers), *((c, "target") for c in twin.constraints)):
        other = getattr(holder, name, None)
        if other in twins:
            setattr(holder, name, twins[other])


def feed(mesh, twins):
    """Let the copy of a sweep's mesh be made from the copies of its inputs."""
    shape, group = objects.group_of(mesh)
    with rna.at_once(mesh.sweep):
        for key, ob in rna.objects(group, parameters(shape)).items():
            if ob in twins:
                held_by, name = rna.holder(group, key)
                setattr(held_by, f"{name}_object", twins[ob])


def settle(result, twins):
    """Put the copies into collections: operands into a new one, all others where their originals are."""
    for home in result.users_collection:
        home.objects.link(twins[result])
    parts = set(trees.operands(result))
    home = operands.collection_of(twins[result])
    for ob, twin in twins.items():
        if ob == result:
            continue
        homes = [home] if ob in parts or ob.display_type == "WIRE" else ob.users_collection
        for each in homes:
            each.objects.link(twin)

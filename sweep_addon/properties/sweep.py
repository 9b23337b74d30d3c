# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The parameters that live on the mesh they make: ``bpy.types.Mesh.sweep``.

Undo brings parameters and mesh back together, Shift-D copies both and Alt-D shares both.
"""

from functools import cache

import bpy

from ..core.later import later
from .kept import table

rebuild = later("properties.live", "rebuild")

TABLE = table()
GROUPS = {}  # by their names, as the table has them
LOCAL = {"LIBRARY_OVERRIDABLE"}


def update(group, context):
    """Make a mesh anew when its parameters change; operators that add shapes have the same properties and no mesh."""
    mesh = group.id_data
    if isinstance(mesh, bpy.types.Mesh) and not mesh.sweep.paused:
        rebuild(mesh)


def annotations(numbers):
    """The properties of a group or an operator, from their numbers in the table."""
    return {name: annotated(number) for name, number in numbers.items()}


@cache
def annotated(number):
    """One of the table's properties, with what of Blender it stands for: its maker, its type, its functions."""
    maker, told = TABLE["properties"][number]
    meant = {name: stands_for(told[name]) for name, stands_for in STANDING.items() if name in told}
    return getattr(bpy.props, maker)(**told | meant)


def only(types):
    return lambda group, ob: ob.type in types


# What the table says of a property that means something of Blender.
STANDING = {
    "poll": only,
    "type": lambda name: GROUPS.get(name) or getattr(bpy.types, name),
    "update": lambda _: update,
}


for group in TABLE["groups"]:
    members = {"__annotations__": annotations(group["properties"]), "__doc__": group["doc"]}
    GROUPS[group["name"]] = type(group["name"], (bpy.types.PropertyGroup,), members)


def of_shape(shape):
    return bpy.props.PointerProperty(type=GROUPS[shape["group"]], override=LOCAL)


def hidden(maker, **keywords):
    """A property that the program keeps for itself."""
    return maker(options={"HIDDEN"}, **keywords)


class SWEEP_PG_sweep(bpy.types.PropertyGroup):
    """The shape that a mesh is made from, and how the last making went"""

    __annotations__ = {
        **{shape["name"]: of_shape(shape) for shape in TABLE["shapes"]},
        "kind": bpy.props.EnumProperty(
            items=[("NONE", "None", "An ordinary mesh", 0), *TABLE["kinds"]],
            options=set(),  # not animated: a mesh that is a sweep in some frames only could not say what it is
            update=update,
            name="Shape",
            description="The shape that the mesh is made from",
        ),
        "paused": hidden(bpy.props.BoolProperty, update=update, description="Whether changes wait to be built"),
        "version": hidden(bpy.props.IntProperty, default=TABLE["version"], description="Version of these parameters"),
        "made": hidden(bpy.props.StringProperty, description="What the mesh was last made from"),
        "topology": hidden(bpy.props.StringProperty, description="Which faces were last written"),
        "texture": hidden(bpy.props.StringProperty, description="Which texture coordinates were last written"),
        "mark": hidden(bpy.props.IntProperty, description="A number by which a change by hand is noticed"),
        "rings": hidden(bpy.props.IntProperty, description="Contours along the trajectory"),
        "error": hidden(bpy.props.StringProperty, description="Why the mesh could not be made anew"),
        "told": hidden(bpy.props.StringProperty, description="What was decided where the parameters left it open"),
        "places": hidden(bpy.props.StringProperty, description="Where the sweep meets itself"),
        "looked_at": hidden(bpy.props.StringProperty, description="What it was made from when that was found"),
        "solid": hidden(bpy.props.StringProperty, description="Whether its solid is awaited, or why there is none"),
        "edited": hidden(bpy.props.BoolProperty, description="Whether the mesh was changed by hand"),
    }


CLASSES = (*GROUPS.values(), SWEEP_PG_sweep)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Mesh.sweep = bpy.props.PointerProperty(type=SWEEP_PG_sweep, override=LOCAL)


def unregister():
    del bpy.types.Mesh.sweep
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)

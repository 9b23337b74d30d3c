# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The parameters that live on the mesh they make: ``bpy.types.Mesh.sweep``.

Undo brings parameters and mesh back together, Shift-D copies both and Alt-D shares both.
"""

import bpy

from ..bridge import rna
from ..core.declared.parameters import parameters, spelled
from ..core.declared.plain import VERSION
from ..core.declared.wording import summary
from ..core.later import later
from ..core.shapes.kinds import SHAPES

rebuild = later("properties.live", "rebuild")


def update(group, context):
    """Make a mesh anew when its parameters change; operators that add shapes have the same properties and no mesh."""
    mesh = group.id_data
    if isinstance(mesh, bpy.types.Mesh) and not mesh.sweep.paused:
        rebuild(mesh)


def shape_group(shape):
    """The property group of one shape."""
    name = spelled(shape, "_")
    made = rna.annotations(parameters(shape), pointers=True, update=update)
    return type(f"SWEEP_PG_{name}", (bpy.types.PropertyGroup,), {"__annotations__": made, "__doc__": summary(shape)})


GROUPS = {spelled(shape, "_"): shape_group(shape) for shape in SHAPES}
ITEMS = {rna.item_group(p.item, update) for shape in SHAPES for p in parameters(shape) if p.item}


def hidden(maker, **keywords):
    """A property that the program keeps for itself."""
    return maker(options={"HIDDEN"}, **keywords)


class SWEEP_PG_sweep(bpy.types.PropertyGroup):
    """The shape that a mesh is made from, and how the last making went"""

    __annotations__ = {
        **{name: bpy.props.PointerProperty(type=group, override=rna.LOCAL) for name, group in GROUPS.items()},
        "kind": bpy.props.EnumProperty(
            items=[("NONE", "None", "An ordinary mesh", 0), *rna.items_of(SHAPES)],
            options=set(),  # not animated: a mesh that is a sweep in some frames only could not say what it is
            update=update,
            name="Shape",
            description="The shape that the mesh is made from",
        ),
        "paused": hidden(bpy.props.BoolProperty, update=update, description="Whether changes wait to be built"),
        "version": hidden(bpy.props.IntProperty, default=VERSION, description="Version of these parameters"),
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


CLASSES = (rna.VALUES, *ITEMS, *GROUPS.values(), SWEEP_PG_sweep)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Mesh.sweep = bpy.props.PointerProperty(type=SWEEP_PG_sweep, override=rna.LOCAL)


def unregister():
    del bpy.types.Mesh.sweep
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)

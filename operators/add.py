# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Add a shape: one operator for each, all made from the shapes' declarations, and one for presets."""

from functools import cache
from typing import get_type_hints

from bpy.props import BoolProperty, EnumProperty
from bpy.types import Operator
from bpy_extras.object_utils import AddObjectHelper, add_object_align_init, object_data_add

from ..sweep_addon.core.declared.names import number_of, spelled
from ..sweep_addon.core.declared.refusals import ShapeError
from ..sweep_addon.core.later import later
from ..sweep_addon.properties.sweep import TABLE, annotations

layout, objects, placing = later("bridge.layout"), later("bridge.objects"), later("bridge.placing")
parameters, read = later("core.declared.parameters", "parameters"), later("bridge.rna", "read")
presets, trajectories = later("presets"), later("core.trajectories")


class AddObject:
    """Where a new object stands, as Blender's own helper has it, whose properties are text: here they are made once"""

    __annotations__ = get_type_hints(AddObjectHelper)
    poll = AddObjectHelper.poll


class AddShape(AddObject):
    """What the operators have in common; each names its shape"""

    bl_options = {"REGISTER", "UNDO", "PRESET"}

    def draw(self, context):
        self.layout.use_property_split = True
        layout.draw(self.layout, self, parameters(objects.SHAPE[self.shape]))
        for name in ("align", "location", "rotation"):
            self.layout.prop(self, name)

    def execute(self, context):
        try:
            mesh = objects.new_mesh(read(self, objects.SHAPE[self.shape]))
        except ShapeError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        object_data_add(context, mesh, operator=self)
        return {"FINISHED"}


def idname(shape):
    """How Blender names the operator that adds a shape."""
    return named(spelled(shape, "_"))


def named(shape):
    """The same, of the shape of a name."""
    return f"mesh.{shape}_add"


def add_operator(shape):
    """The operator that adds one shape of the table."""
    name = shape["name"]
    members = {
        "__doc__": shape["doc"],
        "__annotations__": annotations(shape["properties"]),  # shared with the mesh's own
        "bl_idname": named(name),
        "bl_label": shape["title"],
        "shape": name.upper(),
    }
    return type(f"MESH_OT_{name}_add", (AddShape, Operator), members)


def items(operator, context):
    """The presets, which are not read when Blender starts."""
    return offered()


@cache
def offered():
    # Kept: Blender does not hold on to the texts.
    return [(preset.name.upper(), preset.title, "", number_of(preset.name)) for preset in presets.PRESETS]


class MESH_OT_sweep_preset_add(Operator, AddObject):
    """Add a shape that is set up already; a straight one follows the active curve"""

    bl_idname = "mesh.sweep_preset_add"
    bl_label = "Sweep Preset"
    bl_options = {"REGISTER", "UNDO"}

    preset: EnumProperty(name="Preset", description="What to add", items=items, default=number_of("pipe"))
    follow: BoolProperty(
        name="Follow the Active Curve",
        description="Sweep a preset that is straight along the active curve, if that is selected",
        default=True,
    )

    @classmethod
    def description(cls, context, properties):
        """The tooltip: what the preset's file says of it, which is read then and not when Blender starts."""
        preset = presets.BY_NAME[properties.preset.lower()]
        return preset.doc if preset.group == presets.GROWN else f"{preset.doc}. A straight one follows the active curve"

    def draw(self, context):
        self.layout.use_property_split = True
        for name in ("preset", "follow", "align", "location", "rotation"):
            self.layout.prop(self, name)

    def execute(self, context):
        curve = context.active_object
        try:
            shape, title = presets.shape(self.preset.lower()), presets.BY_NAME[self.preset.lower()].title
            if not isinstance(shape, objects.SHAPES):
                return self.place(context, objects.to_object(shape, title))
            straight = isinstance(getattr(shape, "trajectory", None), trajectories.Line)
            follows = self.follow and straight and curve and curve.type == "CURVE"
            given = {"trajectory": curve} if follows and curve.select_get() else {}
            mesh = objects.new_mesh(shape, title, **given)
        except ShapeError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if given:
            placing.place_along(context, mesh, curve)
        else:
            object_data_add(context, mesh, operator=self)
        return {"FINISHED"}

    def place(self, context, ob):
        """Put a tree, which stands already, where the other presets go."""
        ob.matrix_basis = add_object_align_init(context, self) @ ob.matrix_basis
        for other in context.selected_objects:
            other.select_set(False)
        ob.select_set(True)
        context.view_layer.objects.active = ob
        return {"FINISHED"}


OPERATORS = (*map(add_operator, TABLE["shapes"]), MESH_OT_sweep_preset_add)

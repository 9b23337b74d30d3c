# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Add a shape: one operator for each, all made from the shapes' declarations."""

from typing import get_type_hints

from bpy.types import Operator
from bpy_extras.object_utils import AddObjectHelper, object_data_add

from ..sweep_addon.bridge import rna
from ..sweep_addon.core.declared.parameters import ShapeError, parameters, spelled
from ..sweep_addon.core.declared.wording import summary, titled
from ..sweep_addon.core.later import later
from ..sweep_addon.core.shapes.kinds import SHAPES
from ..sweep_addon.properties.sweep import update

layout, objects = later("bridge.layout"), later("bridge.objects")


class AddObject:
    """Where a new object stands, as Blender's own helper has it, whose properties are text: here they are made once"""

    __annotations__ = get_type_hints(AddObjectHelper)
    poll = AddObjectHelper.poll


class AddShape(AddObject):
    """What the operators have in common; each names its shape"""

    bl_options = {"REGISTER", "UNDO", "PRESET"}

    def draw(self, context):
        self.layout.use_property_split = True
        layout.draw(self.layout, self, parameters(self.shape))
        for name in ("align", "location", "rotation"):
            self.layout.prop(self, name)

    def execute(self, context):
        try:
            mesh = objects.new_mesh(rna.read(self, self.shape))
        except ShapeError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        object_data_add(context, mesh, operator=self)
        return {"FINISHED"}


def idname(shape):
    """How Blender names the operator that adds a shape."""
    return f"mesh.{spelled(shape, '_')}_add"


def add_operator(shape):
    """The operator that adds one shape."""
    name = spelled(shape, "_")
    members = {
        "__doc__": summary(shape),
        "__annotations__": rna.annotations(parameters(shape), update=update),  # shared with the mesh's own
        "bl_idname": idname(shape),
        "bl_label": titled(shape),
        "shape": shape,
    }
    return type(f"MESH_OT_{name}_add", (AddShape, Operator), members)


OPERATORS = tuple(map(add_operator, SHAPES))

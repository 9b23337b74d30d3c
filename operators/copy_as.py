# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Put the active shape on the clipboard as the text that makes it again."""

from bpy.props import EnumProperty
from bpy.types import Operator

from ..sweep_addon.core.declared.refusals import ShapeError
from ..sweep_addon.core.later import later

objects = later("bridge.objects")
dump, python_source = later("core.declared.forms", "dump", "python_source")

FORMS = [
    ("PYTHON", "Python", "A line for Blender's Python console, input curves written into it"),
    ("JOB", "Job", "A job file for the command line and render farms, input curves written into it"),
]


class OBJECT_OT_sweep_copy(Operator):
    """Copy the active sweep or tree to the clipboard as text that makes it again"""

    bl_idname = "object.sweep_copy"
    bl_label = "Copy Sweep"
    bl_options = {"REGISTER"}

    form: EnumProperty(name="Form", description="The language of the text", items=FORMS)

    @classmethod
    def description(cls, context, properties):
        name, does = next((name, does) for form, name, does in FORMS if form == properties.form)
        return f"Copy as {name}. {does}"

    @classmethod
    def poll(cls, context):
        if objects.is_made(context.active_object):
            return True
        cls.poll_message_set("Make a sweep the active object, or a tree")
        return False

    def execute(self, context):
        try:
            shapes = objects.values(context.active_object)
        except ShapeError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if self.form == "PYTHON":
            text = python(shapes)
        else:
            text = dump(shapes[0])
            if len(shapes) > 1:
                self.report({"WARNING"}, f"A job holds one shape: the first of {len(shapes)} splines was copied")
        context.window_manager.clipboard = text
        self.report({"INFO"}, f"Copied {len(text.splitlines())} lines")
        return {"FINISHED"}


def python(shapes):
    """Lines that work in this Blender's console, whatever repository the extension was installed from."""
    repository, _, name = __package__.rpartition(".")[0].rpartition(".")
    lines = [f"from {repository} import {name} as sw"]
    return "\n".join([*lines, *(f"sw.to_object({python_source(shape)})" for shape in shapes)]) + "\n"

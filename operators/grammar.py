# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What people do with the text of an L-system or of a program: edit it, make a new one, take back what they turned."""

import bpy
from bpy.props import IntProperty
from bpy.types import Operator

from ..sweep_addon.core.declared.refusals import ShapeError
from ..sweep_addon.core.later import later

axis_curves, drawn_curves = later("bridge.axis_curves"), later("bridge.drawn_curves")
objects, placing, texts = later("bridge.objects"), later("bridge.placing"), later("bridge.texts")

ABOVE = 8  # lines that stay in sight above one that is gone to
SHARE = 0.4  # of the view's width, that a text editor takes where there is none


class OnGrammar:
    """An operator on a mesh that is made of a grammar"""

    @classmethod
    def poll(cls, context):
        ob = context.active_object
        if objects.is_editable_sweep(ob) and objects.is_grown(ob.data):
            return True
        cls.poll_message_set("Make an L-system the active object whose mesh is not linked from another file")
        return False


class OnText:
    """An operator on a mesh that is made of a text"""

    @classmethod
    def poll(cls, context):
        ob = context.active_object
        if objects.is_editable_sweep(ob) and objects.is_written(ob.data):
            return True
        cls.poll_message_set("Make an L-system or machined stock the active object, not linked from another file")
        return False


class OBJECT_OT_sweep_grammar_edit(OnText, Operator):
    """Show the text in a text editor: one that is open, or else beside the view"""

    bl_idname = "object.sweep_grammar_edit"
    bl_label = "Edit Text"
    bl_options = {"INTERNAL"}

    line: IntProperty(name="Line", description="Where the cursor goes, from 1; 0: where it is", min=0)
    column: IntProperty(name="Column", description="The character of the line, from 1", min=0)

    def execute(self, context):
        held = texts.held_by(*objects.text_of(context.active_object.data))
        if held is None:
            self.report({"ERROR"}, "The text is not there any more: press New")
            return {"CANCELLED"}
        if self.line:
            held.cursor_set(self.line - 1, character=max(self.column - 1, 0))
        area = next(filter(None, (editor(window) for window in context.window_manager.windows)), None)
        area = area or beside(context)
        if area is None:
            self.report({"INFO"}, f"Open a text editor to see {held.name!r}")
            return {"FINISHED"}
        space = area.spaces.active
        space.text, space.show_line_numbers, space.show_syntax_highlight = held, True, False
        if self.line:
            space.top = max(self.line - ABOVE, 0)
        area.tag_redraw()
        return {"FINISHED"}


def editor(window):
    """A text editor of a window, or None."""
    return next((area for area in window.screen.areas if area.type == "TEXT_EDITOR"), None)


def beside(context):
    """A new text editor beside the view, or None where there is no view."""
    view = context.area
    if view is None or view.type != "VIEW_3D":
        return None
    known = set(context.screen.areas)
    bpy.ops.screen.area_split(direction="VERTICAL", factor=SHARE)
    area = next((area for area in context.screen.areas if area not in known), None)
    if area:
        area.type = "TEXT_EDITOR"
    return area


class OBJECT_OT_sweep_grammar_text_new(OnText, Operator):
    """Make a text of the grammar or program that only this mesh has"""

    bl_idname = "object.sweep_grammar_text_new"
    bl_label = "New Text"
    bl_options = {"INTERNAL", "UNDO"}

    def execute(self, context):
        group, name = objects.text_of(context.active_object.data)
        setattr(group, f"{name}_text", None)
        texts.hold(group, name, getattr(group, name))
        return {"FINISHED"}


class OBJECT_OT_sweep_grammar_reset(OnGrammar, Operator):
    """Give constants, steps, angle, lengths and seed the values that the text says"""

    bl_idname = "object.sweep_grammar_reset"
    bl_label = "Reset to Text"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        texts.reset(context.active_object.data)
        return {"FINISHED"}


class OBJECT_OT_sweep_grammar_curves(OnGrammar, Operator):
    """Make a curve object of the L-system's axes as they are now, each a spline with the radii of its tube"""

    bl_idname = "object.sweep_grammar_curves"
    bl_label = "Copy to Curves"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        source = context.active_object
        try:
            plant = objects.shapes(source.data)[0]
            data = drawn_curves.from_axes(*plant.axes(), f"{source.name} Curves")
        except ShapeError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        ob = placing.link(context, data)
        ob.matrix_world = source.matrix_world
        source.select_set(False)
        ob.select_set(True)
        context.view_layer.objects.active = ob
        return {"FINISHED"}


class OBJECT_OT_sweep_grammar_live_curves(OnGrammar, Operator):
    """Make a curve of each axis by a modifier, which follows the L-system; the first of all modifiers"""

    bl_idname = "object.sweep_grammar_live_curves"
    bl_label = "Make Live Curves"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        ob = context.active_object
        if not objects.has_poly_lines(ob.data):
            ob.data.sweep.plant.output = "CURVES"
        axis_curves.show(ob)
        return {"FINISHED"}


OPERATORS = (
    OBJECT_OT_sweep_grammar_curves,
    OBJECT_OT_sweep_grammar_live_curves,
    OBJECT_OT_sweep_grammar_edit,
    OBJECT_OT_sweep_grammar_text_new,
    OBJECT_OT_sweep_grammar_reset,
)

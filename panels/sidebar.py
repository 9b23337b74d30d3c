# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tab Sweep of the sidebar: the active shape's parameters, or what can be added, or why nothing can be done."""

from typing import get_args

from bpy.types import Panel

from ..operators.add import idname
from ..operators.convert import is_tube
from ..operators.edit_as_curve import EDITABLE
from ..operators.self_intersections import OBJECT_OT_sweep_make_solid
from ..sweep_addon.core.declared.names import spelled
from ..sweep_addon.core.later import later
from . import previews

axis_curves, declared_layout = later("bridge.axis_curves"), later("bridge.layout")
live, objects, recognizing = later("properties.live"), later("bridge.objects"), later("bridge.recognizing")
contours, kinds, options = later("core.contours"), later("core.shapes.kinds"), later("core.declared.options")
parameters = later("core.declared.parameters", "parameters")

LOOKED_AT = 100  # selected objects, for another sweep among them: a draw takes no longer however many there are
PREVIEW = 2.6  # times as high as a line
COUNTED = {"PLANT": "segments", "MACHINED_STOCK": "moves"}  # where a sweep has contours
LINKED = "The mesh is linked from another file: make the mesh itself local, or a library override, to change it."


class VIEW3D_PT_sweep(Panel):
    """The active sweep"""

    bl_label = "Sweep"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Sweep"

    def draw(self, context):
        from .sentences import sentences  # starting Blender waits for each file

        layout, ob = self.layout, context.active_object
        row = layout.row(align=True)
        row.menu("VIEW3D_MT_sweep_add", text="Add", icon="ADD")
        row.operator("object.sweep_selected")
        row.menu("VIEW3D_MT_sweep_selected", text="", icon="DOWNARROW_HLT")
        say = sentences(context)
        if not recognizing.is_sweep(ob):
            say(layout, hint(context), "INFO")
            if is_tube(ob):
                layout.operator("object.sweep_convert")
            if context.mode == "OBJECT":
                draw_shapes(layout)
        elif not ob.data.is_editable:
            say(layout, LINKED, "LINKED")
        else:
            draw_sweep(layout, context, ob.data, say)


def draw_shapes(layout):
    """What can be added, with a picture of each."""
    layout.operator_context = "INVOKE_REGION_WIN"
    for generator, shapes in kinds.CLASSIFICATION.items():
        layout.label(text=generator)
        for shape in shapes:
            row = layout.row()
            row.template_icon(previews.icon(shape), scale=PREVIEW)
            button = row.column()
            button.scale_y = PREVIEW
            button.operator(idname(shape))


def hint(context):
    """What a person can do when no sweep is active."""
    if context.mode != "OBJECT":
        return "Go back to Object Mode to add a sweep."
    return "Add a shape, or select a curve and press Sweep Selected for a pipe along it."


def draw_sweep(layout, context, mesh, say):
    from . import l_system, written

    sweep = mesh.sweep
    shape, group = objects.group_of(mesh)
    grown = shape is kinds.Plant
    if sweep.error and not (grown and l_system.problems(group)):  # which have places of their own
        say(layout, sweep.error, "ERROR", alert=True)
    draw_state(layout, mesh, say)
    column = draw_size(layout, sweep, mesh, shape)
    if grown:
        l_system.draw_size(column, mesh, say)
        l_system.draw_text(layout, group, say)
        l_system.draw_constants(layout, group)
    if shape is kinds.MachinedStock:
        written.draw_text(layout, group, "program", say)
    beside = l_system.followed(group) if grown else ()
    declared = [
        p for p in parameters(shape) if p.group != options.MEETING and p.name not in beside
    ]  # they stand elsewhere
    draw_parameters(layout, context, mesh, declared, say)
    if hasattr(shape, "self_intersections"):
        draw_self_intersections(layout, sweep, say)
    if hasattr(group, "make_solid") or sweep.solid:
        draw_solid(layout, sweep, group, say)
    draw_editing(layout, group, declared)
    if shape is kinds.TranslationalSweep:
        layout.operator("object.sweep_convert_to_csg")
    if hasattr(shape, "bend"):
        layout.operator("object.sweep_bend")
    if grown and objects.has_poly_lines(mesh) and not axis_curves.is_shown(context.active_object):
        layout.operator("object.sweep_grammar_live_curves", icon="CURVE_DATA")
    row = layout.row(align=True)
    row.operator("object.sweep_apply")
    row.operator("object.sweep_grammar_curves" if grown else "object.sweep_classify")
    row = layout.row(align=True)
    row.operator("object.sweep_copy", text="Copy as Python").form = "PYTHON"
    row.operator("object.sweep_copy", text="Copy as Job").form = "JOB"


def draw_state(layout, mesh, say):
    """What keeps the mesh from its parameters, and what was decided where they left it open."""
    if mesh.is_editmode:
        say(layout, "The shape follows its parameters again when you leave Edit Mode.", "INFO")
    elif mesh.sweep.edited:
        say(layout, "The mesh was changed by hand: the next change replaces it. Apply to keep it.", "ERROR")
    if objects.group_of(mesh)[0] is kinds.MachinedStock:
        from . import machining

        machining.draw_told(layout, mesh.sweep, say)
        return
    for sentence in mesh.sweep.told.split("\n"):
        if sentence and not sentence.startswith(options.PREFIX):
            say(layout, sentence, "INFO")


def draw_size(layout, sweep, mesh, shape):
    """The name of the shape, and how much its mesh is of; the column that says so."""
    column = layout.column(align=True)
    column.label(text=objects.title(shape), icon_value=previews.icon(shape))
    counted = f"{sweep.rings:,} {COUNTED.get(sweep.kind, 'contours')}, " if sweep.rings else ""
    column.label(text=f"{counted}{len(mesh.polygons):,} faces", icon="BLANK1")
    return column


def draw_parameters(layout, context, mesh, declared, say):
    """The parameters, in the panels of their groups."""
    shape, group = objects.group_of(mesh)
    column = layout.column()
    column.use_property_split = True
    column.use_property_decorate = True
    if any(is_like(other, mesh) for other in context.selected_objects[:LOOKED_AT]):
        say(column, "Hold Alt to change all.", "INFO")
    bodies = declared_layout.draw(column, group, declared)
    frames = bodies.get("Frame") if any(p.group == "Frame" for p in declared) else bodies[""]
    if frames and hasattr(shape, "frames"):
        frames.prop(context.window_manager, "sweep_show_frames")


def draw_editing(layout, group, declared):
    """Buttons for those parameters that may become objects of the scene."""
    names = {p.name for p in declared if p.accepts}
    editable = [name for name in EDITABLE if name in names and (name != "body" or edits_body(group))]
    for some in filter(None, (editable[:2], editable[2:])):
        row = layout.row(align=True)
        for name in some:
            row.operator("object.sweep_edit_as_curve", text=f"Edit {name.title()}").parameter = name


def edits_body(group):
    """Whether the body of an offset is one of the contours, and so may become a curve, or an object to go to."""
    return group.body in {"OBJECT", *(spelled(kind, "_").upper() for kind in get_args(contours.Contour))}


def draw_self_intersections(layout, sweep, say):
    """The folds, and all places where the sweep meets itself once they have been looked for.

    That is a moment after the last change, so this stands below the parameters: nothing moves under the mouse. The
    largest safe size waits for a click where it takes a search.
    """
    found = [sentence for sentence in sweep.told.split("\n") if sentence.startswith(options.PREFIX)]
    if sweep.looked_at == sweep.made:
        found = sweep.places.split("\n") if sweep.places else []
    places = [sentence for sentence in found if sentence.startswith(options.PREFIX)]
    for sentence in places[:1]:
        say(layout, sentence, "ERROR")
    if len(places) > 1:
        say(layout, "There are more places.", "BLANK1")
    for sentence in found[len(places) :]:
        say(layout, sentence, "BLANK1")
    if places and len(places) == len(found) and sweep.looked_at == sweep.made:
        layout.operator("object.sweep_find_self_intersections", text="Find Largest Safe Size")
    if found:
        layout.operator("object.sweep_select_self_intersections", icon="RESTRICT_SELECT_OFF")
    else:
        layout.operator("object.sweep_find_self_intersections")


def draw_solid(layout, sweep, group, say):
    """Whether it is to be a solid, and how far what takes long is."""
    if hasattr(group, "make_solid"):
        layout.prop(group, "make_solid")
    if sweep.solid == live.AWAITED:
        part = OBJECT_OT_sweep_make_solid.part()
        layout.progress(factor=part or 0.0, text="Esc stops it" if part is not None else "In a moment")
    elif sweep.solid:
        say(layout, sweep.solid, "ERROR")
        layout.operator("object.sweep_make_solid", text="Try Again", icon="FILE_REFRESH")


def is_like(other, mesh):
    """Whether an object is another sweep of the same shape, so that Blender changes both where Alt is held."""
    return recognizing.is_sweep(other) and other.data != mesh and other.data.sweep.kind == mesh.sweep.kind

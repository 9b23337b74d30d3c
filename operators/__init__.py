# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a user can do, one verb a file; small ones on the same thing share one, for Blender waits for each file."""

from bpy.utils import register_classes_factory

from . import (
    add_preset,
    add_shape,
    apply,
    bend,
    classify,
    combine,
    convert,
    convert_to_csg,
    copy_as,
    edit_as_curve,
    find_self_intersections,
    grammar,
    list_items,
    make_solid,
    offset_selected,
    sweep_selected,
    tree_steps,
    whole_trees,
)

register, unregister = register_classes_factory(
    (
        *add_shape.OPERATORS,
        add_preset.MESH_OT_sweep_preset_add,
        sweep_selected.OBJECT_OT_sweep_selected,
        convert.OBJECT_OT_sweep_convert,
        apply.OBJECT_OT_sweep_apply,
        bend.OBJECT_OT_sweep_bend,
        copy_as.OBJECT_OT_sweep_copy,
        edit_as_curve.OBJECT_OT_sweep_edit_as_curve,
        list_items.OBJECT_OT_sweep_item_add,
        list_items.OBJECT_OT_sweep_item_remove,
        find_self_intersections.OBJECT_OT_sweep_find_self_intersections,
        find_self_intersections.OBJECT_OT_sweep_select_self_intersections,
        make_solid.OBJECT_OT_sweep_make_solid,
        *grammar.OPERATORS,
        offset_selected.OBJECT_OT_sweep_offset_selected,
        *combine.OPERATORS,
        *tree_steps.OPERATORS,
        *whole_trees.OPERATORS,
        convert_to_csg.OBJECT_OT_sweep_convert_to_csg,
        classify.OBJECT_OT_sweep_classify,
    )
)

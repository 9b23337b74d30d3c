# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a user can do, one verb a file; small ones on the same thing share one, for Blender waits for each file."""

from bpy.utils import register_classes_factory

from . import (
    add,
    apply,
    bend,
    classify,
    combine,
    convert,
    convert_to_csg,
    copy_as,
    edit_as_curve,
    grammar,
    list_items,
    removal,
    selected,
    self_intersections,
    trees,
)

register, unregister = register_classes_factory(
    (
        *add.OPERATORS,
        selected.OBJECT_OT_sweep_selected,
        convert.OBJECT_OT_sweep_convert,
        apply.OBJECT_OT_sweep_apply,
        bend.OBJECT_OT_sweep_bend,
        copy_as.OBJECT_OT_sweep_copy,
        edit_as_curve.OBJECT_OT_sweep_edit_as_curve,
        list_items.OBJECT_OT_sweep_item_add,
        list_items.OBJECT_OT_sweep_item_remove,
        self_intersections.OBJECT_OT_sweep_find_self_intersections,
        self_intersections.OBJECT_OT_sweep_select_self_intersections,
        self_intersections.OBJECT_OT_sweep_make_solid,
        *grammar.OPERATORS,
        selected.OBJECT_OT_sweep_offset_selected,
        *combine.OPERATORS,
        *trees.OPERATORS,
        convert_to_csg.OBJECT_OT_sweep_convert_to_csg,
        classify.OBJECT_OT_sweep_classify,
        removal.OBJECT_OT_sweep_find_removal_path,
    )
)

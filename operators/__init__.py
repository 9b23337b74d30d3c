# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a user can do, one verb a file."""

from bpy.utils import register_classes_factory

from . import (
    add_item,
    add_preset,
    add_shape,
    apply,
    bend,
    choose_solver,
    classify,
    collapse,
    combine,
    convert,
    convert_to_csg,
    copy_as,
    duplicate_tree,
    edit_as_curve,
    evaluate,
    extract,
    find_self_intersections,
    grammar,
    make_solid,
    move_step,
    mute_step,
    offset_selected,
    pick_step,
    remove_item,
    select_operand,
    sweep_selected,
    take_apart,
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
        add_item.OBJECT_OT_sweep_item_add,
        remove_item.OBJECT_OT_sweep_item_remove,
        find_self_intersections.OBJECT_OT_sweep_find_self_intersections,
        find_self_intersections.OBJECT_OT_sweep_select_self_intersections,
        make_solid.OBJECT_OT_sweep_make_solid,
        *grammar.OPERATORS,
        offset_selected.OBJECT_OT_sweep_offset_selected,
        *combine.OPERATORS,
        pick_step.OBJECT_OT_sweep_step_pick,
        move_step.OBJECT_OT_sweep_step_move,
        mute_step.OBJECT_OT_sweep_step_mute,
        select_operand.OBJECT_OT_sweep_step_select,
        extract.OBJECT_OT_sweep_step_extract,
        choose_solver.OBJECT_OT_sweep_tree_choose_solver,
        duplicate_tree.OBJECT_OT_sweep_tree_duplicate,
        collapse.OBJECT_OT_sweep_tree_collapse,
        take_apart.OBJECT_OT_sweep_tree_take_apart,
        convert_to_csg.OBJECT_OT_sweep_convert_to_csg,
        evaluate.OBJECT_OT_sweep_tree_evaluate,
        classify.OBJECT_OT_sweep_classify,
    )
)

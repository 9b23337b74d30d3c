# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Show Frames: e1, e2, e3 and contours along the active and the selected sweeps, drawn over the 3D view.

A way of looking, and no part of the scene: neither saved nor undone. Switched off there is no handler.
"""

import bpy

handles = []  # the one draw handler while frames are shown


def is_shown(_=None):
    return bool(handles)


def show(_, on):
    """Draw frames from now on, or draw them no more."""
    if on == is_shown():
        return
    from . import frame_lines  # starting Blender waits for each file

    if on:
        handles.append(bpy.types.SpaceView3D.draw_handler_add(frame_lines.draw, (), "WINDOW", "POST_VIEW"))
    else:
        bpy.types.SpaceView3D.draw_handler_remove(handles.pop(), "WINDOW")
        frame_lines.batches.clear()
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                area.tag_redraw()


def register():
    bpy.types.WindowManager.sweep_show_frames = bpy.props.BoolProperty(
        name="Show Frames",
        description="Show e1, e2 and e3 in red, green and blue, and contours, along the active and selected sweeps",
        get=is_shown,
        set=show,
    )


def unregister():
    show(None, False)
    del bpy.types.WindowManager.sweep_show_frames

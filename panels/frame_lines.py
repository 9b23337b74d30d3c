# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines of e1, e2, e3 and of contours that `frames` shows, which are loaded when it does.

They are made again only where the digest of a sweep is another.
"""

import bpy
import numpy as np

from ..sweep_addon.core.declared.refusals import ShapeError
from ..sweep_addon.core.later import later

objects = later("bridge.objects")

MOST_SWEEPS, MOST_POINTS = 16, 128  # that are shown; of a loop of a contour
OUT = 2.5  # times the contour's largest distance from the path: how long an axis is
WIDTH = 1.5  # of a line, in pixels at a scale of 1
KEPT = 64  # batches
batches = {}  # what was drawn last


def draw():
    """What Blender calls for each 3D view."""
    import gpu

    context = bpy.context
    if not context.space_data.overlay.show_overlays:
        return
    shader = gpu.shader.from_builtin("POLYLINE_FLAT_COLOR")
    shader.uniform_float("viewportSize", gpu.state.viewport_get()[2:])
    shader.uniform_float("lineWidth", WIDTH * context.preferences.system.ui_scale)
    gpu.state.blend_set("ALPHA")
    for ob in sweeps(context):
        batch = batch_of(ob.data, shader)
        if batch:
            with gpu.matrix.push_pop():
                gpu.matrix.multiply_matrix(ob.matrix_world)
                batch.draw(shader)
    gpu.state.blend_set("NONE")


def sweeps(context):
    """The sweeps whose frames are shown: the active and the selected ones that the view shows."""
    chosen = dict.fromkeys(filter(None, [context.active_object, *context.selected_objects[:MOST_SWEEPS]]))
    return [ob for ob in chosen if objects.is_sweep(ob) and ob.visible_in_viewport_get(context.space_data)]


def batch_of(mesh, shader):
    """The lines of a sweep for the graphics card; None where it cannot be made."""
    from gpu_extras.batch import batch_for_shader

    key = (mesh.sweep.made, mesh.sweep.error)
    if key not in batches:
        while len(batches) >= KEPT:
            batches.pop(next(iter(batches)))
        lines = lines_of(mesh, bpy.context.preferences.themes[0])
        batches[key] = lines and batch_for_shader(shader, "LINES", dict(zip(("pos", "color"), lines, strict=True)))
    return batches[key]


def lines_of(mesh, theme):
    """The ends of all lines of a sweep, (2 n, 3), and their colours, (2 n, 4), in single precision; None if refused."""
    try:
        shown = [shape.frames() for shape in objects.shapes(mesh) if hasattr(shape, "frames")]
    except ShapeError:
        return None
    if not shown:  # nothing moves along a trajectory
        return None
    interface = theme.user_interface
    colours = [(*axis, 1.0) for axis in (interface.axis_x, interface.axis_y, interface.axis_z)]
    colours.append((*theme.view_3d.object_active[:3], 0.6))
    parts = [part for frames in shown for part in zip(segments(frames), colours, strict=True)]
    ends = [lines.reshape(-1, 3) for lines, _ in parts]
    return (
        np.concatenate(ends, dtype=np.float32),
        np.concatenate([np.tile(np.float32(c), (len(e), 1)) for e, (_, c) in zip(ends, parts, strict=True)]),
    )


def segments(frames):
    """The lines (n, 2, 3) of the three axes and of the contours."""
    reach = max(np.linalg.norm(loop - frames.points[:, None], axis=2).max() for loop in frames.contours)
    axes = [
        np.stack((frames.points, frames.points + OUT * reach * e), axis=1) for e in (frames.e1, frames.e2, frames.e3)
    ]
    loops = (loop[:, :: -(-loop.shape[1] // MOST_POINTS)] for loop in frames.contours)
    rings = [np.stack((loop, np.roll(loop, -1, axis=1)), axis=2).reshape(-1, 2, 3) for loop in loops]
    return *axes, np.concatenate(rings)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Show Frames, clicked in the sidebar: lines appear in the view, follow the sweep, and are gone when switched off.

The pixels are those of the view in pictures of the window: as many red, green and blue ones as lines ask for.
"""

import sys
import timeit

import bpy
import numpy as np
from _window import PICTURES, run
from mathutils import Vector

FRAME, SHOW = (0.1, 360), (0.45, 432)  # read off a picture


def colours(person, name):
    """How many pixels of the view are bright red, green and blue."""
    yield from person.over_view()
    yield from person.picture(name)
    image = bpy.data.images.load(str(PICTURES / f"{name}.png"))
    pixels = np.array(image.pixels[:]).reshape(image.size[1], image.size[0], 4)[..., :3]
    view = pixels[person.view.y + 40 : person.view.y + person.view.height - 120, person.view.x + 60 :][:, :700]
    bpy.data.images.remove(image)
    others = np.stack([view[..., [1, 2]].max(axis=2), view[..., [0, 2]].max(axis=2), view[..., [0, 1]].max(axis=2)])
    return [int(count) for count in (np.moveaxis(view, 2, 0) > others + 0.2).sum(axis=(1, 2))]


def near(some, none):
    """Whether there are as few lines as before, but for what smooth edges differ by."""
    return np.abs(np.subtract(some, none)).max() < 60


def frames(person):
    yield 0.5
    bpy.data.batch_remove(list(bpy.data.objects))
    overlay = person.area.spaces.active.overlay
    overlay.show_axis_x = overlay.show_axis_y = overlay.show_floor = overlay.show_cursor = False
    bpy.ops.mesh.generalized_cylinder_add(frame="FRENET", trajectory_helix_turns=1.5, contour_circle_radius=0.15)
    sweep = bpy.context.active_object
    sweep.data.sweep.generalized_cylinder.trajectory_helix_pitch = 1.2
    bpy.ops.ed.undo_push(message="a helix")
    with bpy.context.temp_override(window=person.window, area=person.area, region=person.view):
        bpy.ops.view3d.view_selected()
    view = person.area.spaces.active.region_3d
    view.view_distance *= 1.35
    view.view_location += view.view_rotation @ Vector((0.7, 0, 0))  # away from under the sidebar
    yield from person.open_sidebar("Sweep")
    yield from person.click(*person.top(*FRAME))
    none = yield from colours(person, "f1-off")
    yield from person.click(*person.top(*SHOW))
    shown = yield from colours(person, "f2-frames")
    assert min(np.subtract(shown, none)) > 300, (none, shown)

    sweep.location.x += 0.5
    yield 0.3
    moved = yield from colours(person, "f3-moved")
    assert min(np.subtract(moved, none)) > 300, "the lines go where the object goes"
    group = sweep.data.sweep.generalized_cylinder
    group.trajectory_helix_turns = 0.5
    bpy.ops.ed.undo_push(message="shorter")
    fewer = yield from colours(person, "f4-shorter")
    assert min(np.subtract(moved, fewer)[1:]) > 100, "a shorter path has fewer frames"
    yield from person.undo()
    again = yield from colours(person, "f5-undone")
    assert near(again, shown), (again, shown)

    for ob in bpy.data.objects:
        ob.hide_set(True)
    hidden = yield from colours(person, "f6-hidden")
    assert hidden[1] + hidden[2] < 60, "what is hidden has no frames"
    bpy.data.batch_remove(list(bpy.data.objects))
    gone = yield from colours(person, "f7-deleted")
    assert gone[1] + gone[2] < 60

    bpy.ops.mesh.generalized_cylinder_add()
    again = yield from colours(person, "f8-another")
    assert again[1] + again[2] > 300
    bpy.context.window_manager.sweep_show_frames = False
    off = yield from colours(person, "f9-off")
    assert off[1] + off[2] < 60, off
    yield from costs(person)


def costs(person):
    """Lines are made once however often the view is drawn, and nothing is left when they are not shown."""
    drawn = sys.modules["bl_ext.user_default.sweep_addon.panels.frame_lines"]
    bpy.context.window_manager.sweep_show_frames = True
    yield 0.3
    (batch,) = drawn.batches.values()
    for _ in range(3):
        person.area.tag_redraw()
        yield 0.2
    assert list(drawn.batches.values()) == [batch]
    mesh = bpy.context.active_object.data
    known = min(timeit.repeat(lambda: drawn.batch_of(mesh, None), number=100, repeat=3)) / 100
    made = min(timeit.repeat(lambda: drawn.lines_of(mesh, bpy.context.preferences.themes[0]), number=3, repeat=3)) / 3
    print(f"frames of a sweep: lines made in {made * 1e3:.1f} ms, looked up in {known * 1e6:.1f} us")
    bpy.context.window_manager.sweep_show_frames = False
    assert not bpy.context.window_manager.sweep_show_frames and not drawn.batches


run(frames)

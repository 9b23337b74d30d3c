# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How long the sidebar's own drawing takes, in a real window that redraws again and again."""

import statistics
import time
import traceback

import bpy
from measuring import short, table, tell, verdict

from bl_ext.user_default import sweep_addon as sw

REDRAWS = 60
INTRODUCTION = f"""
### Drawing the sidebar

`draw()` of the tab *Sweep*, and of trees that of its panel *Sweep-CSG*, in a real window; medians of {REDRAWS} redraws.
What Blender then makes of the layout, in C, is not in it.
"""
TITLES = ("the active object", "ms", "target")
SCENES = {
    "none": None,
    "a generalized cylinder, default": sw.GeneralizedCylinder(),
    "one with formulas, a polyline and an outline": sw.GeneralizedCylinder(
        contour=sw.contours.Outline(loops=[[(0, 0), (1, 0), (1, 1), (0, 1)]]),
        trajectory=sw.trajectories.Polyline([(0, 0, 0), (1, 0, 0), (1, 1, 0)]),
        scale_x="1 + t",
        scale_y="1 + t",
        twist="t",
    ),
}


def drilled(count):
    """A plate from which so many cylinders are taken."""
    tree, drill = sw.solids.Block(10.0, 5.0, 0.5), sw.solids.Cylinder(0.3, 2.0, 32)
    for number in range(count):
        tree = tree - drill.moved(x=number % 10 - 4.5, y=number // 10 - 2.0)
    return tree


TREES = {f"a tree of {count} operands": drilled(count) for count in (3, 50)}


def sidebar():
    """The window, its 3D view, and the view's sidebar, opened."""
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == "VIEW_3D")
    area.spaces.active.show_region_ui = True
    return {"window": window, "area": area, "region": next(part for part in area.regions if part.type == "UI")}


def main(place):
    place["region"].active_panel_category = "Sweep"
    with bpy.context.temp_override(**place):
        times = {name: drawn(shape, bpy.types.VIEW3D_PT_sweep) for name, shape in SCENES.items()}
        times |= {name: drawn(tree, bpy.types.VIEW3D_PT_sweep_csg) for name, tree in TREES.items()}
    rows = [(name, short(taken), verdict(taken, 1, " ms")) for name, taken in times.items()]
    tell(INTRODUCTION + "\n" + table(TITLES, rows))


def drawn(shape, panel):
    """The median milliseconds of a panel's draw() with that shape active."""
    active = sw.to_object(shape) if shape else None
    bpy.context.view_layer.objects.active = active
    taken, draw = [], panel.draw

    def timed(self, context):
        start = time.perf_counter()
        draw(self, context)
        taken.append(1000 * (time.perf_counter() - start))

    panel.draw = timed
    redraw(REDRAWS)
    panel.draw = draw
    assert len(taken) >= REDRAWS, f"drawn {len(taken)} times"
    return statistics.median(taken)


def redraw(times):
    bpy.ops.wm.redraw_timer(type="DRAW_WIN_SWAP", iterations=times)


def when_open():
    """Measure as soon as the sidebar has been drawn for the first time, and end Blender."""
    place = sidebar()
    if place["region"].active_panel_category == "UNSUPPORTED":
        return 0.2
    try:
        main(place)
    except Exception:
        traceback.print_exc()  # the runner finds no page
    bpy.ops.wm.quit_blender()


bpy.app.timers.register(when_open, first_interval=1.0)

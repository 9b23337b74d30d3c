# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What Show Frames draws, without a window: the lines, and the handler that is there only while they are shown."""

from importlib import import_module

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import curve, parameters_of, square, sweep

EXTENSION = "bl_ext.user_default.sweep_addon"


@pytest.fixture
def shown():
    module = import_module(f"{EXTENSION}.panels.frames")
    yield module
    bpy.context.window_manager.sweep_show_frames = False


def lines(ob):
    frame_lines = import_module(f"{EXTENSION}.panels.frame_lines")
    return frame_lines.lines_of(ob.data, bpy.context.preferences.themes[0])


def test_there_is_a_handler_only_while_frames_are_shown(scene, shown):
    manager = bpy.context.window_manager
    assert not manager.sweep_show_frames and not shown.handles
    manager.sweep_show_frames = True
    manager.sweep_show_frames = True
    assert manager.sweep_show_frames and len(shown.handles) == 1
    manager.sweep_show_frames = False
    assert not manager.sweep_show_frames and not shown.handles


def test_opening_a_file_keeps_what_the_switch_says_true(scene, shown):
    bpy.context.window_manager.sweep_show_frames = True
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    assert bpy.context.window_manager.sweep_show_frames == bool(shown.handles)


def test_axes_start_on_the_path_and_contours_are_closed(scene):
    """2 m along a circle of 0.5 m: five frames, three axes at each, and as many lines as points round each contour."""
    ends, colours = lines(sweep())
    assert ends.dtype == colours.dtype == np.float32 and len(ends) == len(colours) == 2 * (3 * 5 + 5 * 64)
    starts, tips = ends[: 2 * 15].reshape(-1, 2, 3).swapaxes(0, 1)
    assert starts[:5] == pytest.approx(np.array([(0, 0, z) for z in (0, 0.5, 1, 1.5, 2)]))
    assert tips - starts == pytest.approx(np.repeat([(0, 0, 1.25), (1.25, 0, 0), (0, 1.25, 0)], 5, axis=0), abs=1e-6)
    rings = ends[30:].reshape(5, 64, 2, 3)
    assert np.array_equal(rings[:, :, 1], np.roll(rings[:, :, 0], -1, axis=1))
    assert colours[0, 0] > colours[0, 1:3].max() and colours[10, 1] > colours[10, [0, 2]].max()


def test_every_spline_and_an_object_as_contour_are_shown(scene):
    path = curve("POLY", [(0, 0, 0), (0, 0, 2)], [(5, 0, 0), (5, 0, 2)])
    ends, _ = lines(sweep(trajectory=path, contour=square()))
    assert np.ptp(ends, axis=0)[0] > 5


def test_large_contours_are_thinned(scene):
    ob = sweep()
    parameters_of(ob).contour_circle_points = 4000
    ends, _ = lines(ob)
    assert len(ends) < 2 * (3 * 5 + 5 * 130)


def test_what_is_refused_is_not_shown(scene):
    ob = sweep()
    parameters_of(ob).contour_circle_radius = 0
    assert lines(ob) is None

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the files of a format hold, and how they were made, in the oldest supported Blender.

When the version of the format changes, write the new one's files before anything else, by ``pytest`` with the name of
this file, and keep those of the older ones as they are. A change of the format without one is only for formats that
nobody has files of yet.
"""

from pathlib import Path

import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import parameters_of, square, straight, sweep

import sweep_addon as sw
from sweep_addon.core.declared.forms import VERSION

DATA = Path(__file__).parents[1] / "data"

# No number is its default.
SHAPE = sw.GeneralizedCylinder(
    contour=sw.contours.Rectangle(width=0.5, height=0.25, rounding=0.05, corner_points=3),
    trajectory=sw.trajectories.Helix(radius=1.5, pitch=0.75, turns=2.5),
    samples=sw.sampling.Count(96),
    frame=sw.frames.FixedUp((0, 1, 1)),
    scale_x="1 + t*(1 - t)",
    scale_y=[(0, 0.75), (0.5, 1.25), (1, 0.75)],
    twist=0.5,
    start="open",
    end=sw.ends.Taper(0.75),
)


def test_write_files_of_this_format(scene):
    (DATA / f"format_{VERSION}.toml").write_text(sw.dump(SHAPE))
    scene = bpy.context.window.scene = bpy.data.scenes.new("kept")  # without the many brushes of a first one
    sw.to_object(SHAPE, "numbers")
    ob = sweep(trajectory=straight(), contour=square())
    ob.name = "curves"
    for frame, twist in ((1, 0.0), (11, 3.0)):
        parameters_of(ob).twist_constant_value = twist
        parameters_of(ob).keyframe_insert("twist_constant_value", frame=frame)
    scene.frame_set(1)
    # unlike a saved file, one written so names no folder of the machine
    bpy.data.libraries.write(str(DATA / f"format_{VERSION}.blend"), {scene}, compress=True)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the extension costs while nobody uses it: when Blender starts, and while a scene plays."""

import os
import statistics
import subprocess
import sys
import time
from pathlib import Path

import bpy
from measuring import short, table, tell, verdict

import addon_utils
from bl_ext.user_default import sweep_addon as sw

NAME = "bl_ext.user_default.sweep_addon"
STARTS, ROUNDS, FRAMES, SWEEPS = 15, 41, 25, 200
INTRODUCTION = f"""
### Overhead

What the extension costs while nobody uses it. Enabling: medians of {STARTS} Blenders just started. It imports no
NumPy, as the first sweep does: that is measured after it; of the wheel, which has it, in a Python of its own. Playing:
{SWEEPS} sweeps in the scene and an animation of an empty, milliseconds a frame, the extension enabled and disabled in
turns of {FRAMES} frames; medians of {ROUNDS} turns.
"""


def enabling(blender):
    """Milliseconds for enabling the extension, and for NumPy's import after it; Python keeps what it has compiled."""
    script = Path(__file__).with_name("enabling.py")
    options = ("--background", "--factory-startup", "--python-use-system-env", "--python-exit-code", "1")
    command, taken = [*blender, *options, "--python", script], []
    variables = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    for _ in range(STARTS):
        started = subprocess.run(command, env=variables, capture_output=True, text=True, check=True)
        line = next(line for line in started.stdout.splitlines() if line.startswith("measured: "))
        taken.append(line.split()[1:])
    *times, brought = zip(*taken[1:], strict=True)  # the first compiles, and makes the table
    assert set(brought) == {"False"}, "enabling imported NumPy"
    return [statistics.median(map(float, each)) for each in times]


def playing():
    """Milliseconds a frame, the extension enabled and disabled."""
    for number in range(SWEEPS):
        ob = sw.to_object(sw.GeneralizedCylinder())
        ob.location.x = number
    empty = bpy.data.objects.new("Empty", None)
    bpy.context.scene.collection.objects.link(empty)
    for frame, height in ((1, 0.0), (250, 10.0)):
        empty.location.z = height
        empty.keyframe_insert("location", frame=frame)
    took = {True: [], False: []}
    for _ in range(ROUNDS):
        for enabled in (True, False):
            (addon_utils.enable if enabled else addon_utils.disable)(NAME)
            took[enabled].append(frames())
    addon_utils.enable(NAME)
    assert sum(mesh.sweep.kind != "NONE" for mesh in bpy.data.meshes) == SWEEPS
    return statistics.median(took[True]), statistics.median(took[False])


def frames():
    scene = bpy.context.scene
    scene.frame_set(1)
    start = time.perf_counter()
    for frame in range(2, 2 + FRAMES):
        scene.frame_set(frame)
    return 1000 * (time.perf_counter() - start) / FRAMES


def main():
    enabled, imported = enabling(sys.argv[sys.argv.index("--") + 2 :])
    on, off = playing()
    rows = [
        ["enabling the extension", short(enabled), f"{enabled / imported:.2f} times NumPy's own import"],
        ["NumPy's own import", short(imported), ""],
        ["enabling, beyond that", f"{enabled - imported:+.1f}", verdict(enabled - imported, 30, " ms")],
        [f"a frame of a scene with {SWEEPS} sweeps, disabled", short(off), ""],
        ["the same, enabled", short(on), f"{on - off:+.3f} ms: {2.4 * (on - off):+.2f} % of a frame at 24 a second"],
    ]
    tell(INTRODUCTION + "\n" + table(("", "ms", "target"), rows))


main()

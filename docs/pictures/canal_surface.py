# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of a canal surface: some of its balls, and from the middle on the surface that touches all of them.

Run by `scripts/gallery` in Blender: canal_surface.py -- PICTURE.
"""

import sys
from pathlib import Path

import numpy as np

from bl_ext.user_default import sweep_addon as sw
from bl_ext.user_default.sweep_addon.sweep_addon.batch import scene, studio
from bl_ext.user_default.sweep_addon.sweep_addon.batch.job import Render

RENDER = Render(width=800, height=450, azimuth=-1.35, elevation=0.45, samples=32, margin=0.03)
BALL = Render(side=(0.95, 0.78, 0.55), caps=(0.95, 0.78, 0.55))
PATH = "u", "0.55*sin(1.1*u)", "0.3*cos(0.8*u)"
RADIUS = "0.42 + 0.2*sin(2.1*{} - 0.6)"
START, MIDDLE, END = 0.0, 3.0, 6.0
FINE = sw.sampling.Tolerance(0.0005)


def main(picture):
    scene.empty()
    surface = path(MIDDLE, END)
    shapes = [(sw.CanalSurface(surface, RADIUS.format("u"), samples=FINE, start="open", points=128), RENDER)]
    balls = path(START, END)
    for u in np.arange(START, MIDDLE + 0.01, 0.3):
        place = balls.evaluate([u])[0]
        radius = 0.42 + 0.2 * np.sin(2.1 * u - 0.6)
        line = sw.trajectories.Line(place, place + (0, 0, 1e-4))
        shapes.append((sw.CanalSurface(line, float(radius), samples=FINE, points=64), BALL))
    shown = []
    for shape, look in shapes:
        shown.append(sw.to_object(shape))
        studio.paint(shown[-1].data, look)
    scene.stage(shown, RENDER)
    scene.render_picture(RENDER, picture)


def path(start, end):
    return sw.trajectories.Formula(*PATH, start=start, end=end)


main(Path(sys.argv[sys.argv.index("--") + 1]))

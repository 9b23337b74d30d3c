# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of rails: a bar that two rails turn and widen, the rails drawn beside it as wires.

Run by `scripts/gallery` in Blender: rails.py -- PICTURE.
"""

import sys
from pathlib import Path

from bl_ext.user_default import sweep_addon as sw
from bl_ext.user_default.sweep_addon.sweep_addon.batch import scene, studio
from bl_ext.user_default.sweep_addon.sweep_addon.batch.job import Render

RENDER = Render(width=640, height=400, azimuth=-0.35, elevation=0.5, samples=64)
WIRES = Render(side=(0.12, 0.13, 0.15))
MIDDLE = sw.trajectories.Line((-0.2, 0, 0.4), (4.2, 0, 0.4))
RAILS = (
    sw.trajectories.Formula("u", "0.5 + 0.2*cos(3*u)", "0.4 + 0.25*sin(1.5*u)", start=-0.3, end=4.3),
    sw.trajectories.Formula("u", "-0.45 - 0.2*sin(2*u)", "0.4 - 0.25*sin(1.5*u)", start=-0.3, end=4.3),
)
FINE = sw.sampling.Tolerance(0.0003)


def main(picture):
    contour = sw.contours.Superellipse(1.0, 0.3, exponent=3.0)
    body = sw.GeneralizedCylinder(contour, MIDDLE, FINE, rails=RAILS)
    wires = [sw.GeneralizedCylinder(sw.contours.Circle(0.022, 24), rail, FINE) for rail in RAILS]
    scene.empty()
    shown = []
    for shape, look in ((body, RENDER), *((wire, WIRES) for wire in wires)):
        shown.append(sw.to_object(shape))
        studio.paint(shown[-1].data, look)
    scene.stage(shown, RENDER)
    scene.render_picture(RENDER, picture)


main(Path(sys.argv[sys.argv.index("--") + 1]))

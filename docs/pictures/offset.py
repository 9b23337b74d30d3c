# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of an offset: a wire that winds six times about a ring, both along the same circle.

Run by `scripts/gallery` in Blender: offset.py -- PICTURE.
"""

import sys
from math import tau
from pathlib import Path

from bl_ext.user_default import sweep_addon as sw
from bl_ext.user_default.sweep_addon.sweep_addon.batch import scene, studio
from bl_ext.user_default.sweep_addon.sweep_addon.batch.job import Render

RENDER = Render(width=640, height=480, elevation=0.75, samples=64)
RING = Render(side=(0.45, 0.47, 0.5))
CIRCLE = sw.trajectories.Arc(1.0, tau)
FINE = sw.sampling.Tolerance(0.0002)


def main(picture):
    ring = sw.GeneralizedCylinder(sw.contours.Circle(0.085), CIRCLE, FINE)
    wire = sw.GeneralizedCylinder(sw.contours.Circle(0.052, 48), CIRCLE, FINE, offset_x=0.14, twist="12*pi*t")
    scene.empty()
    shown = []
    for shape, look in ((wire, RENDER), (ring, RING)):
        shown.append(sw.to_object(shape))
        studio.paint(shown[-1].data, look)
    scene.stage(shown, RENDER)
    scene.render_picture(RENDER, picture)


main(Path(sys.argv[sys.argv.index("--") + 1]))

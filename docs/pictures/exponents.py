# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of the superellipse's exponents: 0.6, 1, 2, 3 and 8, each a short bar that stands.

Run by `scripts/gallery` in Blender: exponents.py -- PICTURE.
"""

import sys
from math import pi
from pathlib import Path

from bl_ext.user_default import sweep_addon as sw
from bl_ext.user_default.sweep_addon.sweep_addon.batch import scene, studio
from bl_ext.user_default.sweep_addon.sweep_addon.batch.job import Render

RENDER = Render(width=1200, height=360, azimuth=-pi / 2, elevation=0.95, margin=0.02, samples=48)
EXPONENTS = (0.6, 1, 2, 3, 8)


def main(picture):
    scene.empty()
    shown = []
    for place, exponent in enumerate(EXPONENTS):
        contour = sw.contours.Superellipse(1.0, 1.0, exponent, quarter_points=48)
        ob = sw.to_object(sw.GeneralizedCylinder(contour, sw.trajectories.Line(end=(0, 0, 0.5))))
        studio.paint(ob.data, RENDER)
        ob.location.x = 1.25 * place
        shown.append(ob)
    scene.stage(shown, RENDER)
    scene.render_picture(RENDER, picture)


main(Path(sys.argv[sys.argv.index("--") + 1]))

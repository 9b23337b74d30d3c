# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of the fits: a coarse tube, inscribed, area-true and circumscribed, and half of the true one in it.

Run by `scripts/gallery` in Blender: fits.py -- PICTURE.
"""

import sys
from math import pi
from pathlib import Path

import numpy as np

from bl_ext.user_default import sweep_addon as sw
from bl_ext.user_default.sweep_addon.sweep_addon.batch import scene, studio
from bl_ext.user_default.sweep_addon.sweep_addon.batch.job import Render

RENDER = Render(width=1200, height=420, azimuth=-pi / 2, elevation=0.9, margin=0.02, samples=64)
TRUE = Render(side=(0.16, 0.42, 0.66), caps=(0.55, 0.75, 0.88))
APART = 3.1


def coarse(fit):
    samples = {"kind": "count", "contours": 6}
    return sw.GeneralizedCylinder(sw.contours.Circle(0.36, 7), sw.trajectories.Arc(1.0, pi), samples, fit=fit)


def true():
    half = sw.trajectories.Formula("cos(u)", "sin(u)", "0", start=pi / 2, end=0.93 * pi)
    return sw.GeneralizedCylinder(sw.contours.Circle(0.36, 128), half, {"kind": "tolerance", "chord": 1e-4})


def main(picture):
    scene.empty()
    shown = []
    for place, fit in enumerate(("inscribed", "area-true", "circumscribed")):
        tube, inner = sw.to_object(coarse(fit), fit), sw.to_object(true(), f"true {fit}")
        tube.data.polygons.foreach_set("use_smooth", np.zeros(len(tube.data.polygons), bool))
        for part, look in ((tube, RENDER), (inner, TRUE)):
            studio.paint(part.data, look)
            part.location.x = place * APART
            shown.append(part)
    scene.stage(shown, RENDER)
    scene.render_picture(RENDER, picture)


main(Path(sys.argv[sys.argv.index("--") + 1]))

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The shapes beside the generalized cylinder, at as many vertices."""

from dataclasses import replace
from math import pi, tau

import numpy as np
from measuring import medians, short, table, tell, verdict

from bl_ext.user_default import sweep_addon as sw

CONTOURS, POINTS, ROUNDS = 4000, 64, 15
CUTS = 2  # contours that planes add: shapes are compared at the same number of vertices
CIRCLE = sw.contours.Circle(0.1, POINTS)
CYLINDER = "generalized cylinder"
INTRODUCTION = f"""
### Shapes

From parameters that are new to arrays of places, faces and texture coordinates, no Blender in it: milliseconds for
{CONTOURS:,} contours of {POINTS} points, and how many times those of the generalized cylinder in the same run;
medians of {ROUNDS} rounds. The oblique planes of the PD curve sweep lean many of its contours.

"""


def swept(shape, **changed):
    """Makes a shape with values that are new, given by functions of the round."""

    def action(number):
        mesh = replace(shape, **{name: value(number) for name, value in changed.items()}).mesh(np.float32)
        mesh.chart.uv(np.float32)
        return mesh

    return action


def shapes():
    """The actions that make one shape each, by their names."""
    count, line = sw.sampling.Count(CONTOURS), sw.trajectories.Line(end=(0, 0, 9))
    arc, up = sw.trajectories.Arc(2.0, pi / 2), sw.directions.Arrows([(0, 0, 0, 1)])
    oblique = sw.limits.Plane((2.0, 0.0, 0.0), (1.0, 3.0, 1.0)), sw.limits.Plane((0.0, 2.0, 0.0), (-3.0, 1.0, 1.0))
    pd_curve = sw.PDCurveSweep(CIRCLE, arc, up, samples=count)
    cut = replace(pd_curve, start=oblique[0], end=oblique[1], samples=sw.sampling.Count(CONTOURS - CUTS))

    def tall(number):
        return 1 + 0.01 * number

    def turned(number):
        return tau * (0.9 - 0.001 * number)

    def thick(number):
        return sw.contours.Circle(0.1 + 0.0001 * number, POINTS)

    beside = sw.RotationalSweep(CIRCLE, axis_point=(-1.0, 0.0), samples=count)
    return {
        CYLINDER: swept(sw.GeneralizedCylinder(CIRCLE, line, count), contour=thick),
        "translational sweep": swept(sw.TranslationalSweep(CIRCLE, steps=CONTOURS - 1), height=tall),
        "the same, drafted": swept(sw.TranslationalSweep(CIRCLE, steps=CONTOURS - 1, taper=0.01), height=tall),
        "rotational sweep": swept(beside, angle=turned),
        "the same, a screw": swept(replace(beside, pitch=0.3), angle=lambda number: 10 * turned(number)),
        "PD curve sweep": swept(pd_curve, contour=thick),
        "the same, between oblique planes": swept(cut, contour=thick),
    }


def main():
    actions = shapes()
    sizes = {name: len(action(0).vertices) for name, action in actions.items()}
    if set(sizes.values()) != {CONTOURS * POINTS}:
        raise ValueError(f"the shapes must have {CONTOURS * POINTS:,} vertices each, got {sizes}")
    made = medians(actions, ROUNDS)[0]
    rows = [[name, short(taken), short(taken / made[CYLINDER])] for name, taken in made.items()]
    page = [INTRODUCTION + table(["", "ms", "to the generalized cylinder"], rows), ""]
    page += [f"- {name}: {verdict(t / made[CYLINDER], 1.5)}" for name, t in made.items() if name != CYLINDER]
    tell("\n".join(page))


main()

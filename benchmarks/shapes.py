# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The shapes beside the generalized cylinder, at as many vertices; and how long it takes to find where they meet."""

from dataclasses import replace
from math import pi, tau

import numpy as np
from measuring import medians, short, table, tell, verdict

from bl_ext.user_default import sweep_addon as sw

CONTOURS, POINTS, ROUNDS = 4000, 64, 15
SAMPLES, DETECTIONS = 10_000, 9
CIRCLE = sw.contours.Circle(0.1, POINTS)
CYLINDER = "generalized cylinder"
INTRODUCTION = f"""
### Shapes

From parameters that are new to arrays of places, faces and texture coordinates, no Blender in it: milliseconds for
{CONTOURS:,} contours of {POINTS} points, and how many times those of the generalized cylinder in the same run;
medians of {ROUNDS} rounds. The oblique planes of the PD curve sweep lean many of its contours.

"""
DETECTION = f"""
Finding where a sweep of {SAMPLES:,} contours meets itself, each time on a trajectory that is new; medians of
{DETECTIONS} rounds. A round tube is decided by the reach of its trajectory, others by their triangles.

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
        "the same, between oblique planes": swept(replace(pd_curve, start=oblique[0], end=oblique[1]), contour=thick),
    }


def detections():
    """The actions that look for self-intersections, by what they look at."""

    def look(shape, trajectory):
        return lambda number: replace(shape, trajectory=trajectory(1 + 1e-5 * number)).self_intersections()

    round_one = sw.GeneralizedCylinder(CIRCLE, samples=sw.sampling.Count(SAMPLES))
    square = replace(round_one, contour=sw.contours.Rectangle(0.15, 0.15))
    too_thick = replace(round_one, contour=sw.contours.Circle(0.5, POINTS))

    def knot(size):
        return sw.trajectories.TorusKnot(2, 3, size, 0.4)

    def helix(size):
        return sw.trajectories.Helix(size)

    return {
        "round tube on a knot, clean": look(round_one, knot),
        "round tube on a helix, clean": look(round_one, helix),
        "square on a knot, clean": look(square, knot),
        "square on a helix, clean": look(square, helix),
        "round tube on a knot, crossing: all places": look(too_thick, knot),
    }


def main():
    made = medians(shapes(), ROUNDS)[0]
    rows = [[name, short(taken), short(taken / made[CYLINDER])] for name, taken in made.items()]
    page = [INTRODUCTION + table(["", "ms", "to the generalized cylinder"], rows), ""]
    page += [f"- {name}: {verdict(t / made[CYLINDER], 1.5)}" for name, t in made.items() if name != CYLINDER]
    found = medians(detections(), DETECTIONS)[0]
    page.append(DETECTION + table(["", "ms"], [[name, short(taken)] for name, taken in found.items()]) + "\n")
    page += [f"- {name}: {verdict(taken, 50, ' ms')}" for name, taken in found.items()]
    tell("\n".join(page))


main()

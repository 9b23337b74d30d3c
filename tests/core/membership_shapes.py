# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes of all kinds, about a metre large, for tests of point membership; their meshes are 4 mm from them at most."""

from functools import cache
from math import pi

import sweep_addon as sw
from sweep_addon.core.csg.meshes import closed_mesh
from sweep_addon.core.membership.sets.bodies import MeshBody

CHORD = 4e-3  # metres
FINE = sw.sampling.Tolerance(5e-4)
MANY = sw.sampling.Count(200)  # where faces are warped, which no chord tells
TURN = sw.trajectories.Arc(0.5, 2 * pi)
UP, CURVED = sw.trajectories.Line(), sw.trajectories.Bezier([(0, 0, 0), (0, 0, 0.6), (0, 0.5, 0.8), (0.3, 1, 0.8)])
WAVE = sw.trajectories.Formula("0.9*u", "0.2*sin(6*u)", "0.1*u", 0, 1)
EIGHT = sw.trajectories.Formula("0.7*sin(u)", "0.35*sin(2*u)", "0", 0, 2 * pi)
ZIGZAG = [(0, 0, 0), (0.7, 0, 0), (0.7, 0.6, 0), (0.2, 0.6, 0.4)]
HAIRPIN = [(0, 0, 0), (1, 0, 0), (0, 0.35, 0)]
SQUARE = [(0, 0, 0), (0.8, 0, 0), (0.8, 0.8, 0.2), (0, 0.8, 0)]
HALF_DISC = sw.contours.Outline([[(0, -0.5), (0, 0.5)]], bulges=[[1, 0]], tolerance=2e-4)
WASHER = sw.contours.Outline([[(0.2, 0), (-0.2, 0)], [(0.1, 0), (-0.1, 0)]], bulges=[[1, 1], [1, 1]], tolerance=2e-4)
BAR, DISC, STAR = sw.contours.Rectangle(0.2, 0.1), sw.contours.Circle(0.15), sw.contours.Star(5, 0.2, 0.1)
SOFT = sw.contours.Rectangle(0.3, 0.2, rounding=0.06)
ASIDE = sw.contours.Outline([[(0.3, -0.2), (0.7, -0.1), (0.5, 0.3)]])
SIDES = [
    sw.trajectories.Bezier([(0.1, 0, 0), (0.3, 0, 0.3), (0.3, 0, 0.7), (0.2, 0.1, 1)]),
    sw.trajectories.Bezier([(-0.1, 0, 0), (-0.2, 0, 0.3), (-0.3, 0, 0.7), (-0.2, -0.1, 1)]),
]
BLOCK, ROD = sw.solids.Block(0.5, 0.3, 0.2), sw.solids.Cylinder(0.1, 1.0)


def tube(contour, trajectory, **others):
    return sw.GeneralizedCylinder(contour, trajectory, **({"samples": FINE} | others))


def path(points, corner=None, closed=False):
    return sw.trajectories.Polyline(points, closed, **({"corner": corner} if corner else {}))


CORNERS = {
    "mitres": tube(BAR, path(ZIGZAG)),
    "mitres of a star": tube(STAR, path(ZIGZAG), twist="pi*t", samples=MANY),
    "round corners": tube(BAR, path(ZIGZAG, sw.corners.Round(0.15))),
    "bevels": tube(DISC, path(ZIGZAG, sw.corners.Bevel(0.1))),
    "a long mitre": tube(sw.contours.Circle(0.06), path(HAIRPIN)),
    "a mitre beyond its limit": tube(BAR, path(HAIRPIN, sw.corners.Mitre(1.5))),
    "a round tube's mitre beyond its limit": tube(sw.contours.Circle(0.06), path(HAIRPIN, sw.corners.Mitre(1.5))),
    "closed mitres": tube(BAR, path(SQUARE, closed=True)),
    "closed mitres that turn": tube(STAR, path(SQUARE, closed=True), samples=MANY),
    "closed mitres, twisted": tube(
        BAR, path(SQUARE, closed=True), frame=sw.frames.RotationMinimizing(1, 1), samples=MANY
    ),
    "mitres that taper": tube(DISC, path(ZIGZAG), start=sw.ends.Taper(0.6), end=sw.ends.Taper(0.6), samples=MANY),
    "mitres that shrink": tube(DISC, path(ZIGZAG), scale_x="1 - 0.6*t", scale_y="1 - 0.6*t", samples=MANY),
}
LAWS = {
    "twist": tube(BAR, CURVED, twist="2*pi*t", samples=MANY),
    "one scale": tube(STAR, CURVED, scale_x="1 + 0.5*sin(2*pi*t)"),
    "offset": tube(DISC, UP, offset_x="0.2*sin(2*pi*t)", offset_y="0.2*t"),
    "points": tube(BAR, CURVED, scale_x=[(0, 1), (0.5, 0.3), (1, 1.2)], scale_y=[(0, 1), (0.5, 1.3), (1, 0.5)]),
    "mirrored": tube(STAR, CURVED, scale_x=-1.0),
    "tapered ends": tube(STAR, CURVED, start=sw.ends.Taper(0.2), end=sw.ends.Taper(0.4)),
    "round ends": tube(DISC, CURVED, start="round", end=sw.ends.Round(0.5)),
    "round ends of a bar": tube(SOFT, CURVED, start="round", end="round"),
    "to a point": tube(STAR, CURVED, scale_x="1 - t", scale_y="1 - t"),
    "to a point, rounded": tube(DISC, UP, scale_x="sqrt(1 - t^2)", scale_y="sqrt(1 - t^2)"),
}
FRAMES = {
    "frenet": tube(BAR, WAVE, frame="frenet"),
    "frenet on a helix": tube(BAR, sw.trajectories.Helix(0.4, 0.3, 2.0), frame="frenet"),
    "fixed up": tube(BAR, CURVED, frame=sw.frames.FixedUp((1, 0, 0.2))),
    "closed with a quarter of a turn": tube(
        sw.contours.RegularPolygon(4, 0.15), TURN, frame=sw.frames.RotationMinimizing(0, 1)
    ),
    "closed with half a turn": tube(BAR, TURN, frame=sw.frames.RotationMinimizing(1, 1), samples=MANY),
    "knot": tube(DISC, sw.trajectories.TorusKnot(2, 3, 0.5, 0.25)),
    "sampled": tube(BAR, sw.trajectories.Sampled([(0, 0, 0), (0.3, 0.4, 0), (0.7, 0.2, 0.3), (0.9, 0.6, 0.5)])),
    "a rail": tube(BAR, UP, rails=SIDES[:1], samples=MANY),
    "two rails": tube(BAR, UP, rails=SIDES, samples=MANY),
    "two rails in width": tube(STAR, UP, rails=SIDES, guided="in-width"),
}
CONTOURS = {
    "superellipse": tube(sw.contours.Superellipse(0.4, 0.3, 3.0, 32), CURVED),
    "ellipse": tube(sw.contours.Ellipse(0.2, 0.1), CURVED, twist="pi*t"),
    "washer": tube(WASHER, CURVED, samples=sw.sampling.Tolerance(2e-4)),
    "aerofoil": tube(sw.contours.Aerofoil("4412", 0.6, 0.4, side_points=65), CURVED),
    "soft": tube(SOFT, CURVED),
    "morph": tube(
        DISC,
        CURVED,
        samples=sw.sampling.Tolerance(2e-4),
        morph=[{"t": 0.5, "contour": STAR}, {"t": 1.0, "contour": BAR}],
    ),
}
MEETING = {
    "figure-eight": tube(DISC, EIGHT),
    "spindle": tube(sw.contours.Circle(0.3, 128), sw.trajectories.Arc(0.2, 2 * pi)),
    "knot that overlaps": tube(sw.contours.Circle(0.3), sw.trajectories.TorusKnot(2, 3, 0.5, 0.25)),
    "helix that overlaps": tube(DISC, sw.trajectories.Helix(0.4, 0.2, 2.0)),
    "screw that overlaps": sw.RotationalSweep(ASIDE, 3 * pi, pitch=0.2, samples=FINE),
    "too tight a bend": tube(sw.contours.Circle(0.2), sw.trajectories.Formula("u", "0.6 - 3*u^2", "0", -0.5, 0.5)),
}
TRANSLATED = {
    "upright": sw.TranslationalSweep(WASHER, 0.8),
    "oblique": sw.TranslationalSweep(STAR, 0.8, direction=(0.4, 0.2, 1)),
    "symmetric": sw.TranslationalSweep(SOFT, 0.6, "symmetric"),
    "drafted": sw.TranslationalSweep(sw.contours.Star(5, 0.5, 0.3), 0.3, taper=0.2),
    "drafted both ways": sw.TranslationalSweep(SOFT, 0.3, "symmetric", taper=0.2),
}
ROTATED = {
    "full turn": sw.RotationalSweep(ASIDE, samples=FINE),
    "half disc": sw.RotationalSweep(HALF_DISC, samples=FINE),
    "part of a turn": sw.RotationalSweep(ASIDE, 2.0, samples=FINE),
    "backwards": sw.RotationalSweep(ASIDE, -4.0, samples=FINE),
    "oblique axis": sw.RotationalSweep(ASIDE, 5.0, samples=FINE, axis_point=(-0.1, 0.2), axis_direction=(0.3, 1)),
    "screw": sw.RotationalSweep(ASIDE, 3 * pi, pitch=0.7, samples=FINE),
    "across the axis": sw.RotationalSweep(
        sw.contours.Outline([[(-0.2, -0.3), (0.5, -0.1), (0.4, 0.3)]]), 2.0, samples=FINE, crossing="split"
    ),
}
BENT = {
    "PD": sw.PDCurveSweep(BAR, CURVED, sw.directions.Cubic([(1, 0, 0), (1, 0, 0), (0, 0, 1), (0, 0, 1)]), samples=MANY),
    "PD between planes": sw.PDCurveSweep(
        BAR,
        CURVED,
        sw.directions.Arrows(),
        sw.limits.Plane((0, 0, 0.1), (0.3, 0.2, 1)),
        sw.limits.Plane((0.2, 0.9, 0.8), (1, 1, 0.3)),
        samples=FINE,
    ),
    "PD beyond its ends": sw.PDCurveSweep(
        SOFT,
        CURVED,
        sw.directions.Arrows(),
        sw.limits.Plane((0, 0, -0.2), (0.3, 0, 1)),
        sw.limits.Plane((0.5, 1.2, 0.8), (1, 1, 0)),
        samples=FINE,
    ),
}
BALLS = {
    "canal": sw.CanalSurface(CURVED, 0.2, samples=FINE),
    "canal that grows": sw.CanalSurface(UP, "0.1 + 0.3*t", samples=FINE),
    "canal that swallows balls": sw.CanalSurface(UP, "0.1 + 1.2*t^3", samples=FINE),
    "canal with flat ends": sw.CanalSurface(CURVED, "0.1 + 0.15*t", samples=FINE, start="flat", end="flat"),
    "canal with a flat end": sw.CanalSurface(path(ZIGZAG), 0.1, samples=FINE, start="flat"),
    "canal that begins within a ball": sw.CanalSurface(
        UP, "0.1 + 0.8*(1 - t)^3", points=128, samples=sw.sampling.Tolerance(2e-5), start="flat"
    ),
    "closed canal": sw.CanalSurface(TURN, "0.15 + 0.05*sin(4*pi*t)", samples=FINE),
    "offset outside": sw.OffsetSurface(sw.solids.Bracket(), 0.08, tolerance=1e-3),
    "offset inside": sw.OffsetSurface(sw.solids.Block(0.6, 0.5, 0.4), 0.05, "inside"),
}
MOVED = {
    "parallel contour": sw.GeneralSweep(DISC, WAVE, samples=FINE, turn_y=pi / 2),
    "scaled contour": sw.GeneralSweep(STAR, WAVE, turn_y=1.0, samples=FINE, scale_x="1 + t", scale_y="1 - 0.5*t"),
    "turning contour": sw.GeneralSweep(BAR, UP, samples=MANY, turn_z="2*pi*t", turn_x="0.3*t"),
    "deformed contour": sw.GeneralSweep(BAR, UP, samples=MANY, deform_x="x*(1 + 0.5*sin(3*t + y))"),
    "bent contour": sw.GeneralSweep(
        STAR,
        CURVED,
        samples=MANY,
        frame="rotation-minimizing",
        deform_x="x*cos(2*t) - y*sin(2*t)",
        deform_y="x*sin(2*t) + y*cos(2*t)",
    ),
    "deformed on a corner": sw.GeneralSweep(BAR, path([(0, 0, 0), (0, 0, 0.5), (0.5, 0, 1)]), deform_x="x + 0.3*t^2"),
    "deformed and closed": sw.GeneralSweep(
        DISC, TURN, frame="rotation-minimizing", samples=MANY, deform_x="x*(1 + 0.3*sin(2*pi*t))"
    ),
    "moved block": sw.SweptSolid(BLOCK, sw.trajectories.Line(end=(0.4, 0.2, 0.5))),
}
SOLIDS = {
    "block": BLOCK,
    "cylinder": ROD,
    "bracket": sw.solids.Bracket(),
    "drilled block": sw.solids.DrilledBlock(),
    "ball": sw.solids.Ball(0.4, 96),
    "triangles": sw.solids.Triangles(),
    "sheared": sw.Placed(sw.solids.Bracket(), [(2, 0.3, 0, 0), (0, 1, 0.5, 0), (0, 0, 2, 0.1)]),
    "mirrored ": sw.Placed(tube(STAR, CURVED), [(-1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0)]),
}
APART = (CORNERS, LAWS, FRAMES, CONTOURS, TRANSLATED, ROTATED, BENT, BALLS, MOVED, SOLIDS)
SHAPES = {name: shape for kinds in (*APART, MEETING) for name, shape in kinds.items()}


@cache
def closed(name):
    """The mesh that bounds the solid of a shape: it is made once for all tests."""
    return closed_mesh(SHAPES[name])


@cache
def body(name):
    """What tells the distance from that mesh, and on which side a point is."""
    return MeshBody(closed(name))

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random sweeps of a contour, of every kind whose membership is told from the motion itself, about a metre large.

What no mesh can have exactly is not among them: kinks between curved legs, whose contours run through each other's, and
planes that cut smooth contours, which are followed between the points of these.
"""

from math import pi

import numpy as np

import sweep_addon as sw
from sweep_addon.core.stations.sampling import Count

COUNTS = 2, 3, 7, 41, 401


def one_of(random, *choices):
    """One of several values, or what one of several functions of the random numbers makes."""
    chosen = choices[random.integers(len(choices))]
    return chosen(random) if callable(chosen) else chosen


def wandering(random, low, high, flat=False):
    """Points each a random way from the one before."""
    ways = random.normal(size=(int(random.integers(low, high)), 3)) * (1, 1, 0 if flat else 1)
    return np.cumsum(ways, axis=0)


def polyline(random, closed=False, flat=False):
    corners = sw.corners.Mitre(), sw.corners.Mitre(1.5), sw.corners.Round(0.02), sw.corners.Bevel(0.02)
    return sw.trajectories.Polyline(wandering(random, 3, 8, flat), closed, corner=one_of(random, *corners))


def smooth_bezier(random):
    points = random.uniform(-1, 1, (7, 3))
    points[4] = 2 * points[3] - points[2]  # the handles of a knot lie on one line
    return sw.trajectories.Bezier(points)


def harmonics(random):
    """A closed curve."""
    waves = random.normal(size=(3, 2, 3)) / (1, 2, 3)
    terms = (
        "+".join(f"{a:.4f}*cos({n}*u)+{b:.4f}*sin({n}*u)" for n, (a, b) in enumerate(zip(*part, strict=True), 1))
        for part in waves
    )
    return sw.trajectories.Formula(*terms, 0.0, 2 * pi)


def formula(x, y, z, start, end):
    return lambda random: sw.trajectories.Formula(
        *(text.format(a=random.uniform(0.3, 1.5)) for text in (x, y, z)), start, end
    )


STRAIGHT_IN_PART = [(0, 0, 0), (0, 0, 0.3), (0, 0, 0.6), (0, 0, 1), (0, 0, 1.4), (0.5, 0.3, 1.8), (1, 0.3, 1.8)]
SMOOTH = {
    "line": lambda random: sw.trajectories.Line(random.normal(size=3), random.normal(size=3)),
    "up": lambda random: sw.trajectories.Line(),
    "arc": lambda random: sw.trajectories.Arc(random.uniform(0.4, 1.5), random.uniform(0.3, 6)),
    "turn": lambda random: sw.trajectories.Arc(random.uniform(0.6, 1.5), 2 * pi),
    "helix": lambda random: sw.trajectories.Helix(*random.uniform((0.4, 0.3, 0.5), (1.2, 0.9, 4))),
    "knot": lambda random: sw.trajectories.TorusKnot(*one_of(random, (2, 3), (3, 2), (1, 4)), 1.0, 0.4),
    "bezier": lambda random: smooth_bezier(random),
    "nurbs": lambda random: sw.trajectories.Nurbs(random.uniform(-1, 1, (int(random.integers(4, 9)), 3))),
    "sampled": lambda random: sw.trajectories.Sampled(0.4 * wandering(random, 3, 12)),
    "closed sampled": lambda random: sw.trajectories.Sampled(0.4 * wandering(random, 4, 9), True),
    "harmonics": harmonics,
    "inflection": formula("u", "{a}*u^3", "0", -1.0, 1.0),
    "nearly straight": formula("u", "{a}*u^5", "0.3*u^4", -1.0, 1.0),
    "straight in part": lambda random: sw.trajectories.Bezier(STRAIGHT_IN_PART),
    "loop": formula("sin(u)", "0.2*u", "{a}*cos(u)", 0.0, 8.0),
    "through the vertical": formula("0.3*sin(u)", "0.1*u^2", "u", -2.0, 2.0),
    "wave": formula("0.9*u", "0.2*sin(6*u)", "{a}*u", 0.0, 2.0),
    "eight": formula("0.7*sin(u)", "0.35*sin(2*u)", "{a}*cos(u)", 0.0, 2 * pi),
    "flat eight": formula("0.7*sin(u)", "0.35*sin(2*u)", "0", 0.0, 2 * pi),
}
TRAJECTORIES = SMOOTH | {
    "polyline": polyline,
    "closed polyline": lambda random: polyline(random, closed=True),
    "flat polyline": lambda random: polyline(random, bool(random.integers(2)), flat=True),
    "straight on": lambda random: sw.trajectories.Polyline([(0, 0, 0), (1, 0, 0), (2, 0, 0), (2, 1, 0), (2, 1, 1)]),
}
FRAMES = {
    "rotation-minimizing": lambda random: sw.frames.RotationMinimizing(),
    "turning": lambda random: sw.frames.RotationMinimizing(*(int(each) for each in random.integers(-2, 3, 2))),
    "frenet": lambda random: sw.frames.Frenet(),
    "exact": lambda random: sw.frames.Frenet("exact"),
    "up": lambda random: sw.frames.FixedUp(),
    "up aside": lambda random: sw.frames.FixedUp(random.normal(size=3)),
}


def straight_edged(random, size):
    return one_of(
        random,
        sw.contours.Rectangle(size, size * random.uniform(0.3, 2)),
        sw.contours.RegularPolygon(int(random.integers(3, 7)), size),
        sw.contours.Star(int(random.integers(3, 8)), size, size * random.uniform(0.3, 0.8)),
        sw.contours.Outline([size * np.array([(0.1, 0.1), (1, 0.2), (0.3, 0.9)])]),
    )


def contour(random, size):
    square = size * np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    return one_of(
        random,
        straight_edged(random, size),
        sw.contours.Circle(size, points=12),
        sw.contours.Ellipse(size, size / 2, points=12),
        sw.contours.Superellipse(size, size * 1.2, 3.0, 12),
        sw.contours.Rectangle(size, size, rounding=size / 4),
        sw.contours.Aerofoil("2412", size, 0.4, side_points=9),
        sw.contours.Outline([square], [random.uniform(-0.4, 0.4, 4)], tolerance=size / 50),
        sw.contours.Outline([[(size, 0), (-size, 0)], [(size / 2, 0), (-size / 2, 0)]], [[1, 1]] * 2, size / 50),
    )


def laws(random, closed):
    """Scales, twist, offsets, ends and a morph, some of each."""
    found, size = {}, random.uniform(0.2, 0.6)
    scale = one_of(random, 1.0, -1.0, random.uniform(0.5, 1.5), f"1+{size}*sin(2*pi*t)")
    if not closed:
        scale = one_of(random, scale, f"1-{size}*t", "1-t", "sqrt(1-t^2)", [(0, 1), (0.4, 0.5), (1, 1.2)])
    if random.random() < 0.5:
        found |= {"scale_x": scale, "scale_y": scale}
    if random.random() < 0.4:
        found["twist"] = one_of(random, 0.7, "2*pi*t", "sin(2*pi*t)", [(0, 0), (0.5, 1), (1, 0)])
    if random.random() < 0.3:
        found |= {"offset_x": one_of(random, 0.1, "0.1*sin(2*pi*t)"), "offset_y": one_of(random, 0.05, 0.0)}
    ends = "flat", "open", sw.ends.Taper(0.2), "round", sw.ends.Round(0.5)
    found |= {"start": one_of(random, *ends), "end": one_of(random, *ends)}
    if random.random() < 0.1:
        found["morph"] = [{"t": 0.5, "contour": straight_edged(random, 0.1)}]
    return found


def cylinder(random, trajectory, frame):
    path = TRAJECTORIES[trajectory](random)
    figure = contour(random, random.uniform(0.02, 0.15))
    others = laws(random, bool(path.closed))
    return sw.GeneralizedCylinder(figure, path, Count(int(random.choice(COUNTS))), FRAMES[frame](random), **others)


def caps(random):
    return {"start": one_of(random, "flat", "open"), "end": one_of(random, "flat", "open")}


def translation(random):
    others = caps(random) | {"directions": one_of(random, "up", "symmetric", "both")}
    if random.random() < 0.5:
        others["direction"] = (*random.uniform(-1, 1, 2), 1)
    if random.random() < 0.4:
        others |= dict(zip(("taper", "hole_taper"), random.uniform(-0.3, 0.2, 2), strict=True))
    others |= {"reference": one_of(random, "origin", "centroid", "point"), "reference_x": 0.1}
    return sw.TranslationalSweep(
        contour(random, random.uniform(0.3, 1)), random.uniform(0.1, 0.4), steps=int(random.integers(1, 5)), **others
    )


ABOUT = {  # contours by where the axis is, and what may become of those
    "beside": ("refuse", [(0.3, -0.2), (0.7, -0.1), (0.6, 0.3)]),
    "along": ("refuse", [(0, -0.5), (0.3, -0.5), (0.4, 0.4), (0, 0.4)]),
    "touched": ("refuse", [(0, 0), (0.4, -0.3), (0.4, 0.3)]),
    "kept": ("keep", [(-0.2, -0.3), (0.5, -0.1), (0.4, 0.3)]),
    "split": ("split", [(-0.2, -0.3), (0.5, -0.1), (0.4, 0.3)]),
}


def rotation(random):
    name = one_of(random, *ABOUT)
    crossing, points = ABOUT[name]
    others = caps(random) | {"crossing": crossing, "upright": bool(random.integers(2))}
    angle = one_of(random, 2 * pi, -2 * pi, random.uniform(0.2, 3), random.uniform(3, 6.2), random.uniform(-6, -0.2))
    if name == "beside" and random.random() < 0.5:
        angle, others["pitch"] = angle * random.uniform(1, 2), random.uniform(0.3, 1.5)
    if name in ("kept", "split"):
        others |= {"axis_point": random.uniform(-0.1, 0.1, 2), "axis_direction": random.normal(size=2)}
    bulges = [[0, 0.2, 0]] if name == "beside" else ()
    return sw.RotationalSweep(
        sw.contours.Outline([points], bulges, tolerance=0.01),
        angle,
        samples=Count(int(random.choice((9, 41)))),
        **others,
    )


def pd_curve(random):
    path = SMOOTH[one_of(random, *SMOOTH)](random)
    arrow = (0, *random.normal(size=3))
    direction = one_of(random, sw.directions.Arrows([arrow]), sw.directions.Tilt())
    figure, others = contour(random, random.uniform(0.02, 0.15)), {}
    if not path.closed:
        arrows = [arrow, (0.6, *random.normal(size=3)), (1, *random.normal(size=3))]
        cubic = sw.directions.Cubic(random.normal(size=(4, 3)))
        direction = one_of(random, direction, sw.directions.Arrows(arrows), cubic)
        others = caps(random)
        for end, place in zip(others, path.domain, strict=True):
            if random.random() < 0.4:
                at, along = path.evaluate(np.array([place]))[0], path.tangents(np.array([place]))[0]
                figure = straight_edged(random, 0.1)
                plane = at + random.uniform(-0.1, 0.1) * along, along + 0.3 * random.normal(size=3)
                others[end] = sw.limits.Plane(*plane)
    return sw.PDCurveSweep(figure, path, direction, samples=Count(int(random.choice(COUNTS))), **others)


def general(random):
    frames = "parallel", "rotation-minimizing", "frenet", "fixed-up"
    turns = {f"turn_{axis}": one_of(random, 0.0, random.uniform(-1, 1), "sin(2*pi*t)") for axis in "xyz"}
    scales = {f"scale_{axis}": one_of(random, 1.0, -1.0, "1+0.4*sin(2*pi*t)") for axis in "xy"}
    return sw.GeneralSweep(
        contour(random, random.uniform(0.02, 0.15)),
        SMOOTH[one_of(random, *SMOOTH)](random),
        Count(int(random.choice(COUNTS))),
        frame=one_of(random, *frames),
        **turns,
        **scales,
        **caps(random),
    )


def canal(random):
    radius = random.uniform(0.03, 0.15)
    waves = radius, f"{radius}*(1+0.5*sin(2*pi*t))", f"{radius}*(1+cos(6*pi*t)^2)"
    ends = {end: one_of(random, "round", "flat", "open") for end in ("start", "end")}
    return sw.CanalSurface(
        SMOOTH[one_of(random, *SMOOTH)](random),
        one_of(random, *waves),
        points=int(random.integers(3, 20)),
        samples=Count(int(random.choice((3, 7, 41)))),
        **ends,
    )


def placed(random):
    """Sheared, but so that no angle becomes too small for the directions in which membership looks around."""
    return sw.Placed(one_of(random, translation, rotation, pd_curve), np.eye(3, 4) + random.uniform(-0.3, 0.3, (3, 4)))


OTHERS = {
    "translation": translation,
    "rotation": rotation,
    "PD curve": pd_curve,
    "general": general,
    "canal": canal,
    "placed": placed,
    "offset": lambda random: sw.OffsetSurface(sw.solids.Block(*random.uniform(0.3, 0.8, 3)), 0.1, "inside"),
}

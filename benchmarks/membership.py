# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Point membership: how many points a second this project and its peers tell, and how many of them wrongly."""

import statistics
import time

import numpy as np
from mathutils.bvhtree import BVHTree
from measuring import short, table, tell

from bl_ext.user_default import sweep_addon as sw

try:
    import igl
except ImportError:
    igl = None

ROUNDS, POINTS, FEW, SLOW = 3, 1_000_000, 20_000, 100_000
TURN, TOLERANCE = 2 * np.pi, 1e-3
RADIUS, PITCH, TURNS = 0.1, 0.5, 5
HELIX = sw.trajectories.Helix(1.0, PITCH, float(TURNS))
TUBE = sw.GeneralizedCylinder(sw.contours.Circle(RADIUS, 64), HELIX, sw.sampling.Count(480))
HALF_DISC = sw.contours.Outline([[(0, -1), (0, 1)]], bulges=[[1, 0]])
INTRODUCTION = f"""
### Point membership

A tube of {TURNS} turns and {POINTS:,} points in a box around it: millions of points a second, by the clock and by the
processors' time, medians of {ROUNDS} turns. This project is asked of the sweep itself, the others of its mesh. Wrong
are those that are said to be on the other side of the true surface; the truth is the distance from the helix, found
turn by turn by Newton's method. This project and libigl take all processors, mathutils one. What is asked is a rate by
the processors' time, and beside libigl the lesser of both ratios.

"""
OTHERS = """

This project alone:

"""


def around_helix(points):
    """How far points are from the true tube, negative inside, as far as the sign goes: (n,)."""
    x, y, z = points.T
    slope = PITCH / TURN
    least = np.full(len(points), np.inf)
    for turn in range(-1, TURNS + 1):
        u = np.arctan2(y, x) + TURN * turn
        for _ in range(8):
            rate = x * np.sin(u) - y * np.cos(u) - slope * (z - slope * u)
            u = u - rate / (x * np.cos(u) + y * np.sin(u) + slope**2)
        far = np.sqrt((x - np.cos(u)) ** 2 + (y - np.sin(u)) ** 2 + (z - slope * u) ** 2)
        least = np.minimum(least, np.where((u >= 0) & (u <= TURN * TURNS), far, np.inf))
    return least - RADIUS


def spindle(p):
    across = np.hypot(p[:, 0], p[:, 1])
    return np.minimum(np.hypot(across - 0.3, p[:, 2]), np.hypot(across + 0.3, p[:, 2])) - 0.45


def box(p, low, high):
    return np.maximum(np.array(low) - p, p - np.array(high)).max(axis=1)


def revolved(radius, trajectory):
    return sw.GeneralizedCylinder(sw.contours.Circle(radius), trajectory)


SHAPES = {
    "torus": (
        revolved(0.5, sw.trajectories.Arc(2.0, TURN)),
        lambda p: np.hypot(np.hypot(p[:, 0], p[:, 1]) - 2, p[:, 2]) - 0.5,
        2.6,
    ),
    "spindle torus": (revolved(0.45, sw.trajectories.Arc(0.3, TURN)), spindle, 0.8),
    "ball as a revolved half disc": (sw.RotationalSweep(HALF_DISC), lambda p: np.linalg.norm(p, axis=1) - 1, 1.2),
    "cone by a taper": (
        sw.GeneralizedCylinder(
            sw.contours.Circle(1.0), sw.trajectories.Line(end=(0, 0, 2)), scale_x="1 - t", scale_y="1 - t"
        ),
        lambda p: np.maximum(np.hypot(p[:, 0], p[:, 1]) - 1 + p[:, 2] / 2, np.maximum(-p[:, 2], p[:, 2] - 2)),
        2.1,
    ),
    "extruded L": (
        sw.TranslationalSweep(sw.contours.Outline(), 2.0),
        lambda p: np.minimum(box(p, (-0.5, -0.5, 0), (0.5, -0.3, 2)), box(p, (-0.5, -0.5, 0), (-0.3, 0.5, 2))),
        2.1,
    ),
}


def triangles(mesh):
    """The triangles of a mesh of convex faces, in fans: (t, 3) int array."""
    faces = np.split(mesh.corners, mesh.offsets[1:-1])
    return np.concatenate([np.stack((np.full(len(f) - 2, f[0]), f[1:-1], f[2:]), axis=1) for f in faces])


def peers():
    """Each way to tell points from the tube, how many it is asked of, and what it is called."""
    mesh = TUBE.mesh()
    faces = triangles(mesh)
    tree = BVHTree.FromPolygons(mesh.vertices.tolist(), faces.tolist())

    def by_normal(points):
        found = (tree.find_nearest(point) for point in points.tolist())
        nearest, normals = map(np.array, zip(*((place, normal) for place, normal, *_ in found), strict=True))
        return ((points - nearest) * normals).sum(axis=1) < 0

    yield "this project", POINTS, lambda points: sw.classify(TUBE, points) > 0
    if igl:
        vertices, wide = np.asarray(mesh.vertices, dtype=float), faces.astype(np.int64)
        name = f"libigl's fast winding number, {len(faces):,} triangles"
        yield name, POINTS, lambda points: igl.fast_winding_number(vertices, wide, points) > 0.5
    yield "mathutils' BVHTree, side of the nearest face", FEW, by_normal


def taken(actions):
    """The median seconds of each action, done in turns, by the clock and by the processors, and what it told last."""
    times, told = {name: [] for name in actions}, {}
    for _ in range(ROUNDS + 1):
        for name, action in actions.items():
            clock, processor = time.perf_counter(), time.process_time()
            told[name] = action()
            times[name].append((time.perf_counter() - clock, time.process_time() - processor))
    return {name: [statistics.median(part) for part in zip(*found[1:], strict=True)]
            for name, found in times.items()}, told  # fmt: skip


def beside_peers():
    """The table of the tube, and whether what was asked is reached."""
    points = np.random.default_rng(0).uniform((-1.2, -1.2, -0.2), (1.2, 1.2, TURNS * PITCH + 0.2), (POINTS, 3))
    distance = around_helix(points)
    asked = {name: (count, tell_of) for name, count, tell_of in peers()}
    times, told = taken({name: lambda c=count, f=tell_of: f(points[:c]) for name, (count, tell_of) in asked.items()})
    rows, rates = [], {}
    for name, (count, _) in asked.items():
        clock, processor = times[name]
        rates[name] = count / clock / 1e6, count / processor / 1e6
        wrong = int(np.count_nonzero(told[name] != (distance[:count] < 0)))
        rows.append([name, f"{count:,}", *map(short, rates[name]), wrong])
    lines = [table(["", "points", "clock", "processors", "wrong"], rows), ""]
    lines.append(f"- this project: {reached(rates['this project'][1], 1.0, ' million points a second')}")
    if igl:
        ours, theirs, *_ = rates.values()
        ratios = [a / b for a, b in zip(ours, theirs, strict=True)]
        lines.append(
            f"- to libigl, by clock {short(ratios[0])}, by processors {short(ratios[1])}: {reached(min(ratios), 5.0)}"
        )
    return "\n".join(lines)


def reached(value, target, unit=""):
    """What was asked for, and whether it was reached, where more is better."""
    return f"{short(value)}{unit}, at least {target:g}{unit} asked: {'reached' if value >= target else 'missed'}"


def alone():
    """The table of other shapes."""
    rows = []
    for name, (shape, formula, reach) in SHAPES.items():
        points = np.random.default_rng(0).uniform(-reach, reach, (POINTS, 3))
        times, told = taken({"": lambda shape=shape, points=points: sw.classify(shape, points)})
        wrong = int(np.count_nonzero(told[""] != np.sign(-formula(points))))
        rows.append([name, f"{POINTS:,}", *(short(POINTS / each / 1e6) for each in times[""]), wrong])
    rows.append(moving())
    lines = table(["", "points", "clock", "processors", "wrong"], rows)
    return f"{lines}\n\n- the moving solid: {reached(float(rows[-1][3]), 0.15, ' million points a second')}"


def moving():
    """The row of a drilled block on a screw, against poses of it so close that none can be missed by more."""
    solid = sw.solids.Block(1.0, 0.4, 0.3) - sw.solids.Cylinder(0.1, 1.0)
    shape = sw.SweptSolid(solid, sw.RigidMotion(sw.trajectories.Line(end=(0, 0, 2)), turn_z="2*pi*t"))
    points = np.random.default_rng(0).uniform((-0.6, -0.6, -0.3), (0.6, 0.6, 2.3), (SLOW, 3))
    times, told = taken({"": lambda: sw.classify(shape, points, TOLERANCE)})
    poses, some = 4001, points[:FEW]
    least = np.full(len(some), np.inf)
    for t in np.linspace(0, 1, poses):
        c, s = np.cos(TURN * t), np.sin(TURN * t)
        x, y, z = some[:, 0] * c + some[:, 1] * s, some[:, 1] * c - some[:, 0] * s, some[:, 2] - 2 * t
        block = np.maximum.reduce([np.abs(x) - 0.5, np.abs(y) - 0.2, np.abs(z) - 0.15])
        least = np.minimum(least, np.maximum(block, 0.1 - np.hypot(x, y)))
    room = TOLERANCE + np.hypot(2, TURN * 0.85) / (poses - 1) / 2  # and what a point moves in half a step
    labels = told[""][:FEW]
    wrong = np.count_nonzero((labels != 1) & (least < -room) | (labels != -1) & (least > room))
    name = f"a drilled block on a screw, tolerance {TOLERANCE:g}; {FEW:,} of them judged"
    return [name, f"{SLOW:,}", *(short(SLOW / each / 1e6) for each in times[""]), int(wrong)]


tell(INTRODUCTION + beside_peers() + OTHERS + alone())

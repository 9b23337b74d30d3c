# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Offsets of solids beside manifold3d's sum of Minkowski and OpenCASCADE's offset of a solid of exact faces."""

import statistics
import time

import manifold3d
import numpy as np
from measuring import short, table, tell, verdict

from bl_ext.user_default import sweep_addon as sw
from bl_ext.user_default.sweep_addon.sweep_addon.core.meshes.booleans import body_of, hull_body, mesh_of
from bl_ext.user_default.sweep_addon.sweep_addon.core.meshes.facets import facets
from bl_ext.user_default.sweep_addon.sweep_addon.core.offsets.around import Around
from bl_ext.user_default.sweep_addon.sweep_addon.core.offsets.level_set import level_set
from bl_ext.user_default.sweep_addon.sweep_addon.core.offsets.offset import Engine, offset
from bl_ext.user_default.sweep_addon.sweep_addon.core.solids import DrilledBlock

try:
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
    from OCP.BRepGProp import BRepGProp
    from OCP.BRepOffset import BRepOffset_Mode
    from OCP.BRepOffsetAPI import BRepOffsetAPI_MakeOffsetShape
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeCylinder
    from OCP.GeomAbs import GeomAbs_JoinType
    from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt
    from OCP.GProp import GProp_GProps
except ImportError:
    BRepOffsetAPI_MakeOffsetShape = None

ROUNDS, SIDES, RADIUS = 5, 16, 0.03
INTRODUCTION = f"""
### Offsets

A ball that moves over a solid: seconds of processor time, medians of {ROUNDS} turns. A block with a hole of 64 sides is
offset outwards by {RADIUS} m with balls of {SIDES} meridians; OpenCASCADE has the true cylinder for the hole.

"""
LEVELS = """

A star along a knot, 100,000 faces, with the cells of the lattice across the whole; what 99 % of the faces, and all of
them, are proved to be within, in radii, and how many pairs of faces cross:

"""


def taken(actions, rounds=ROUNDS):
    """The median seconds of processor time of each action, in turns, and what it made last."""
    times, made = {name: [] for name in actions}, {}
    for _ in range(rounds + 1):
        for name, action in actions.items():
            start = time.process_time()
            made[name] = action()
            times[name].append(time.process_time() - start)
    return {name: statistics.median(found[1:]) for name, found in times.items()}, made


def by_opencascade():
    """The volume of OpenCASCADE's offset of the block with its round hole."""
    block = BRepPrimAPI_MakeBox(gp_Pnt(-0.25, -0.25, -0.15), gp_Pnt(0.25, 0.25, 0.15)).Shape()
    drill = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -1), gp_Dir(0, 0, 1)), 0.15, 2.0).Shape()
    made = BRepOffsetAPI_MakeOffsetShape()
    drilled = BRepAlgoAPI_Cut(block, drill).Shape()
    arc = GeomAbs_JoinType.GeomAbs_Arc
    made.PerformByJoin(drilled, RADIUS, 1e-4, BRepOffset_Mode.BRepOffset_Skin, False, False, arc)
    found = GProp_GProps()
    BRepGProp.VolumeProperties_s(made.Shape(), found)
    return found.Mass()


def beside_peers():
    """A table of ways to offset a block with a hole."""
    solid = DrilledBlock().mesh()
    ball = manifold3d.Manifold.sphere(RADIUS, SIDES)
    actions = {
        "this project, rounded faces": lambda: offset(solid, RADIUS, engine=Engine.ROUNDED_FACES).mesh(RADIUS).volume(),
        "this project, level set": lambda: offset(solid, RADIUS, engine=Engine.LEVEL_SET).mesh(RADIUS).volume(),
        "manifold3d, minkowski_sum": lambda: body_of(solid).minkowski_sum(ball).volume(),
    }
    if BRepOffsetAPI_MakeOffsetShape:
        actions["OpenCASCADE, of true faces"] = by_opencascade
    times, volumes = taken(actions)
    own = times["this project, rounded faces"]
    rows = [[name, short(t), short(t / own), f"{volumes[name]:.6f}"] for name, t in times.items()]
    return table(["", "s", "to rounded faces", "volume in cubic metres"], rows)


def levels():
    """A table of level sets of 100,000 faces, and whether they are as quick as was asked."""
    path = sw.trajectories.TorusKnot(2, 3, major=2.0, minor=0.8)
    mesh = sw.GeneralizedCylinder(sw.contours.Star(20, 0.4, 0.3), path, sw.sampling.Count(1250)).mesh()
    vertices, triangles = mesh.vertices, facets(mesh)[0].astype(np.int64)
    size, rows, told = np.ptp(vertices, axis=0).max(), [], []
    for part in (0.05, 0.2):
        radius = part * size
        for cells, most in ((64, 2.5), (128, 6.0)):
            step = (size + 2 * radius) / cells

            def made(radius=radius, step=step):
                field = Around(vertices, triangles, radius, True, step)
                surface = level_set(field, vertices.min(axis=0) - radius, vertices.max(axis=0) + radius, step)
                return surface, *field.interval(surface)

            times, found = taken({"": made}, 3)
            surface, lower, upper = found[""]
            near = f"{np.quantile(lower, 0.005) / radius:.3f} to {np.quantile(upper, 0.995) / radius:.3f}"
            whole = f"{lower.min() / radius:.3f} to {upper.max() / radius:.3f}"
            faces = f"{len(surface.triangles):,}"
            rows.append([f"{part:.0%} of the size", cells, short(times[""]), faces, near, whole, len(surface.crossing)])
            told.append(f"- {len(triangles):,} faces, {part:.0%}, {cells} cells: {verdict(times[''], most, ' s')}")
            if cells == 128:
                out = 1 - ((lower >= 0.99 * radius) & (upper <= 1.03 * radius)).mean()
                told.append(f"- the part of them that is not proved to be within 0.99 and 1.03: {verdict(out, 0.01)}")
    return table(["radius", "cells", "s", "faces", "99 %", "all", "crossing"], rows) + "\n\n" + "\n".join(told)


def convex():
    """Whether an ellipsoid of 10,000 faces is offset as quickly as was asked."""
    points = np.random.default_rng(0).normal(size=(5002, 3))
    solid = mesh_of(hull_body(points / np.linalg.norm(points, axis=1, keepdims=True) * (1.0, 0.7, 0.5)))
    times, _ = taken({"": lambda: offset(solid, 0.3)})
    return f"\n- an ellipsoid of {len(solid.offsets) - 1:,} faces: {verdict(times[''], 0.1, ' s')}"


tell(INTRODUCTION + beside_peers() + LEVELS + levels() + convex())

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweeps that meet themselves: what each program makes of them, how long it takes, and what it says of its result."""

import statistics
import sys
import time
from pathlib import Path

import bmesh
import bpy
import manifold3d
import numpy as np
import opencascade
from measuring import short, table, tell
from peers import evaluated, linked
from solids import cone

from bl_ext.user_default import sweep_addon as sw

sys.path.append(str(Path(__file__).resolve().parents[1] / "tests" / "core"))
from inverse_sweep import estimate  # noqa: E402

ABSENT = "not installed"
ROUNDS, PLACES = 5, 100_000
EIGHT = sw.trajectories.Formula("2*sin(u)", "sin(2*u)", "0", start=0.0, end=2 * np.pi)
PARABOLA = sw.trajectories.Formula("u", "4*u^2", "0", start=-1.0, end=1.0)
KNOT, TURN = sw.trajectories.TorusKnot(2, 3, 2.0, 0.8), sw.trajectories.Arc(0.3, 2 * np.pi)
COLUMNS = ("", "volume", "edges not of two faces", "what it says", "CPU seconds")
INTRODUCTION = f"""
### Repair

Sweeps that meet themselves, as they are and as each program resolves them. The judge makes no mesh: of {PLACES:,}
places drawn in a box it asks of each whether a contour went through it (`tests/core/inverse_sweep.py`). The surface as
it is counts what is visited twice twice, and what folds back less than once. Every program is given it in triangles, of
which there are two for a bent face, but OpenCASCADE, which sweeps a true circle along a smooth curve. CPU seconds, for
the machine has other work: of this project the median of {ROUNDS} runs, of Blender's EXACT boolean with itself one run.

"""


def tube(radius, trajectory, contours, points=32):
    return sw.GeneralizedCylinder(sw.contours.Circle(radius, points), trajectory, sw.sampling.Count(contours))


CASES = {
    "figure-eight, 1,000 contours of 32 points, radius 0.2": tube(0.2, EIGHT, 1000),
    "(2, 3) torus knot, 400 of 32, radius 0.9 where 0.8 is clear": tube(0.9, KNOT, 400),
    "spindle torus, 64 of 32, radii 0.3 and 0.5": tube(0.5, TURN, 64),
    "parabola y = 4 x^2, 201 of 32, radius 0.3": tube(0.3, PARABOLA, 201),
}


def rows(shape):
    """What each program makes of a shape."""
    surface = shape.surface()
    yield "the judge", "{:.3f} +- {:.3f}".format(*estimate(shape, PLACES)), "-", "-", "-"
    yield "the surface as it is", short4(surface.volume()), loose(surface), "-", "-"
    yield "this project", *ours(shape)
    yield "Blender, EXACT with itself", *exact(surface)
    yield "manifold3d alone", *alone(surface)
    yield "trimesh", *asked(surface)
    yield "OpenCASCADE", *swept(shape)


def ours(shape):
    taken = []
    for _ in range(ROUNDS):
        start = time.process_time()
        solid = shape.solid()
        taken.append(time.process_time() - start)
    return short4(solid.volume()), loose(solid), "-", short(statistics.median(taken))


def exact(surface):
    """The union of a surface with itself, and with something tiny far away that a boolean has to have."""
    mesh, far = (bpy.data.meshes.new(name) for name in ("Surface", "Far"))
    mesh.from_pydata(surface.vertices, [], triangles(surface).tolist())
    corners = np.vstack((np.zeros(3), 1e-3 * np.eye(3))) + 100
    far.from_pydata(corners, [], [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)])
    ob = linked("Surface", mesh)
    boolean = ob.modifiers.new("Union", "BOOLEAN")
    boolean.operation, boolean.solver, boolean.use_self, boolean.object = "UNION", "EXACT", True, linked("Far", far)
    start = time.process_time()
    found = evaluated(ob)
    taken = time.process_time() - start
    solid = bmesh.new()
    solid.from_mesh(found)
    volume, wrong = sum(map(cone, solid.faces)) - 1e-9 / 6, sum(len(edge.link_faces) != 2 for edge in solid.edges)
    solid.free()
    bpy.data.objects.remove(ob)
    return short4(volume), wrong, "-", short(taken)


def alone(surface):
    start = time.process_time()
    mesh = manifold3d.Mesh64(surface.vertices, triangles(surface).astype(np.uint64))
    made = manifold3d.Manifold(mesh)
    made = manifold3d.Manifold.batch_boolean([made, manifold3d.Manifold()], manifold3d.OpType.Add)
    status = made.status().name
    return short4(made.volume()), "-", status, short(time.process_time() - start)


def asked(surface):
    try:
        import trimesh
    except ImportError:
        return ABSENT, "-", "-", "-"
    mesh = trimesh.Trimesh(surface.vertices, triangles(surface), process=False)
    said = f"watertight: {mesh.is_watertight}, a volume: {mesh.is_volume}"
    return short4(mesh.volume), "-", said, "-"


def swept(shape):
    path, closed = shape.trajectory, bool(shape.trajectory.closed)
    u = np.linspace(*path.domain, 400, endpoint=not closed)
    found = opencascade.knot(path.evaluate(u), shape.contour.radius, closed)
    if found == opencascade.ABSENT:
        return found, "-", "-", "-"
    return short4(found[0]), "-", f"valid: {found[1]}", "-"


def triangles(mesh):
    """The triangles of a mesh of convex faces, in fans: (t, 3) int array."""
    faces = np.split(mesh.corners, mesh.offsets[1:-1])
    return np.concatenate([np.stack((np.full(len(f) - 2, f[0]), f[1:-1], f[2:]), axis=1) for f in faces])


def loose(mesh):
    return int((np.bincount(mesh.topology.corner_edges, minlength=len(mesh.edges)) != 2).sum())


def short4(volume):
    return f"{volume:.4f}"


def main():
    page = [INTRODUCTION]
    for name, shape in CASES.items():
        page += [f"**{name}**\n", table(COLUMNS, [list(map(str, row)) for row in rows(shape)]), ""]
    large = tube(0.2, EIGHT, 10_000, 64)
    volume, wrong, _, seconds = ours(large)
    page.append(f"The figure-eight of 10,000 contours of 64 points: {seconds} s, volume {volume}, {wrong} such edges.")
    tell("\n".join(page))


main()

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes whose truth is known, made by this project and by its peers: figures that anybody can check."""

import bmesh
import numpy as np
from measuring import short, table, tell
from peers import Bevel, CurveToMesh, curve, ring, trimesh_sweep

from bl_ext.user_default import sweep_addon as sw

UNEVEN = np.array([(x, 0, 0) for x in (0, 0.1, 0.2, 0.3, 5, 10)], float)
CORNER = np.array([(0, 0, 0), (5, 0, 0), (5, 5, 0)], float)
STRAIGHT = np.array([(0, 0, 0), (0, 0, 5), (0, 0, 10)], float)
SQUARE = np.array([(0.5, 0.5, 0), (-0.5, 0.5, 0), (-0.5, -0.5, 0), (0.5, -0.5, 0)])
ABSENT = "not installed"
COLUMNS = ("truth", "this project", "Curve to Mesh node", "Curve bevel", "trimesh")
INTRODUCTION = """
### Correctness

Shapes whose truth is known. Before a volume is measured the mesh is welded and turned outward, whosever it is. A dash:
the peer has no such thing. The stretch asked for is at most 1.001.
"""


def volumes(*meshes):
    """The volumes of Blender meshes, each first welded and turned outward: the best that can be said of it."""
    return [short(abs(examined(mesh, welded)[0])) for mesh in meshes]


def examined(mesh, repair=None):
    """The volume of a Blender mesh, and its edges of one face."""
    solid = bmesh.new()
    solid.from_mesh(mesh)
    if repair:
        repair(solid)
    found = solid.calc_volume(signed=True), sum(edge.is_boundary for edge in solid.edges)
    solid.free()
    return found


def welded(solid):
    bmesh.ops.remove_doubles(solid, verts=solid.verts, dist=1e-6)
    bmesh.ops.recalc_face_normals(solid, faces=solid.faces)


def stretch(mesh):
    """Of the edges along x, the length over that in texture: the largest to the smallest, and of quads alone."""
    layer = mesh.uv_layers[0].data
    ratios = []
    for face in mesh.polygons:
        if len(face.vertices) != 4:
            continue
        places = np.array([mesh.vertices[v].co for v in face.vertices])
        uv = np.array([layer[i].uv for i in face.loop_indices])
        there, flat = (np.roll(part, -1, axis=0) - part for part in (places, uv))
        along = np.abs(there[:, 0]) > 0.9 * np.linalg.norm(there, axis=1)
        ratios.extend(np.linalg.norm(there[along], axis=1) / np.linalg.norm(flat[along], axis=1))
    return max(ratios) / min(ratios)


def live(**parameters):
    """The mesh of a generalized cylinder as it lies in Blender."""
    return sw.to_object(sw.GeneralizedCylinder(**parameters)).data


def corner(swept):
    """The volume of a square's tube round a sharp corner."""
    ours = live(contour=sw.contours.Rectangle(1, 1), trajectory=sw.trajectories.Polyline(CORNER))
    contour, bevel = curve(SQUARE, closed=True), Bevel(CORNER)
    bevel.object.data.bevel_mode, bevel.object.data.bevel_object = "OBJECT", contour
    cells = volumes(ours, CurveToMesh(curve(CORNER), contour=contour).mesh(), bevel.mesh())
    return [*cells, short(abs(swept(SQUARE, CORNER).volume)) if swept else ABSENT]


def textures():
    """Stretch on a tube along an unevenly spaced polyline."""
    ours = live(contour=sw.contours.Circle(0.1, points=16), trajectory=sw.trajectories.Polyline(UNEVEN))
    return [f"{stretch(ours):.4f}", "-", f"{stretch(Bevel(UNEVEN, 16).mesh()):.4f}", "-"]


def edges(swept):
    """Edges of one face on a capped tube of 16 points."""
    ours = live(contour=sw.contours.Circle(0.1, points=16), trajectory=sw.trajectories.Polyline(STRAIGHT))
    meshes = (ours, CurveToMesh(curve(STRAIGHT), 16).mesh(), Bevel(STRAIGHT, 16).mesh())
    cells = [examined(mesh)[1] for mesh in meshes]
    if not swept:
        return [*cells, ABSENT]
    _, uses = np.unique(swept(ring(0.1, 16), STRAIGHT).edges_sorted, axis=0, return_counts=True)
    return [*cells, np.count_nonzero(uses == 1)]


def annulus(swept):
    """The volume of a pipe of outer radius 0.1 and inner radius 0.06 along 10 m, contours of 64 points."""
    outer, inner = ring(0.1, 64), ring(0.06, 64)
    contour = sw.contours.Outline(loops=[outer[:, :2], inner[:, :2]])
    ours = live(contour=contour, trajectory=sw.trajectories.Polyline(STRAIGHT))
    node = CurveToMesh(curve(STRAIGHT), contour=curve(outer, inner, closed=True))
    swept_volume = short(abs(swept(outer, STRAIGHT, inner).volume)) if swept else ABSENT
    return [*volumes(ours, node.mesh()), "-", swept_volume]


def knot():
    """How evenly twist is spread along a closed (2, 3) torus knot whose samples crowd."""
    trajectory, points = sw.trajectories.TorusKnot(), 16
    u = np.linspace(*trajectory.domain, 400, endpoint=False)
    path = trajectory.evaluate(u + 0.3 * np.sin(u))
    samples = sw.sampling.Tolerance(0.0001)
    ours = live(contour=sw.contours.Circle(0.05, points=points), trajectory=trajectory, samples=samples)
    node = CurveToMesh(curve(path, closed=True), points, 0.05)
    by_columns = vertices(ours).reshape(points, -1, 3).swapaxes(0, 1)
    return [f"{unevenness(rings):.4f}" for rings in (by_columns, vertices(node.mesh()).reshape(-1, points, 3))]


def vertices(mesh):
    return np.array([vertex.co for vertex in mesh.vertices], float)


def unevenness(rings):
    """Twist per length from each ring (n, m, 3) to the next, the last to the first: largest to smallest.

    What turns beyond a normal carried by double reflection is twist.
    """
    centre, spoke = rings.mean(axis=1), rings[:, 0] - rings.mean(axis=1)
    plane = np.cross(spoke, rings[:, rings.shape[1] // 4] - centre)
    e1, e2 = (part / np.linalg.norm(part, axis=1, keepdims=True) for part in (plane, spoke))
    chord = np.roll(centre, -1, axis=0) - centre
    ahead, arrived = np.roll(e1, -1, axis=0), mirrored(e1, chord)
    carried = mirrored(mirrored(e2, chord), ahead - arrived)
    reached = np.roll(e2, -1, axis=0)
    sine = np.einsum("ij,ij->i", np.cross(carried, reached), ahead)
    twist = np.arctan2(sine, np.einsum("ij,ij->i", carried, reached)) / np.linalg.norm(chord, axis=1)
    return np.abs(twist).max() / np.abs(twist).min()


def mirrored(vectors, normals):
    share = np.einsum("ij,ij->i", vectors, normals) / np.einsum("ij,ij->i", normals, normals)
    return vectors - 2 * share[:, None] * normals


def main():
    swept = trimesh_sweep()
    pipe = 0.5 * 64 * np.sin(2 * np.pi / 64) * (0.1**2 - 0.06**2) * 10
    rows = [
        ["UV stretch, tube along x = 0, 0.1, 0.2, 0.3, 5, 10: largest to smallest", 1, *textures()],
        ["twist per length, closed (2, 3) knot, uneven samples: largest to smallest", 1, *knot(), "-", "-"],
        ["volume of a 1 x 1 square round a corner of 90 degrees, legs of 5", 10, *corner(swept)],
        ["volume of a pipe, radii 0.1 and 0.06, length 10, 64 points", short(pipe), *annulus(swept)],
        ["edges of one face, capped tube of 16 points", 0, *edges(swept)],
    ]
    tell(INTRODUCTION + "\n" + table(("", *COLUMNS), rows))


main()

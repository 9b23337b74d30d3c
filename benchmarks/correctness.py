# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes whose truth is known, made by this project and by its peers: figures that anybody can check."""

import bmesh
import numpy as np
import opencascade
from measuring import short, table, tell
from peers import Bevel, CurveToMesh, curve, ring, trimesh_sweep

from bl_ext.user_default import sweep_addon as sw

UNEVEN = np.array([(x, 0, 0) for x in (0, 0.1, 0.2, 0.3, 5, 10)], float)
STRAIGHT = np.array([(0, 0, 0), (0, 0, 5), (0, 0, 10)], float)
SQUARE = np.array([(0.5, 0.5, 0), (-0.5, 0.5, 0), (-0.5, -0.5, 0), (0.5, -0.5, 0)])
ABSENT = "not installed"
COLUMNS = ("truth", "this project", "Curve to Mesh node", "Curve bevel", "trimesh", "OpenCASCADE")
FRAME = "frame, degrees from the true one: 5-turn helix known by {} points"
INTRODUCTION = """
Every peer is given the same contour and the same points of the path, and this project a smooth path through them where
a smooth one is meant; only OpenCASCADE sweeps the exact curves, and its volumes are those of its solids. Before a
volume is measured a mesh is welded and turned outward, whosever it is; bent faces count halfway between the two ways to
split them. This project's volumes are measured in Blender, its frame and twist in the library, in double precision. The
torus and the knot are made by it with the fit `area-true`, which no peer has; with `inscribed`, the default, they are
off as the peers' are. The node closes a pipe inside and outside, as two solids one in the other. A dash: the peer has
no such thing, or was not asked.
"""


def volumes(*meshes):
    """The volumes of Blender meshes, each first welded and turned outward: the best that can be said of it."""
    return [abs(examined(mesh, welded)[0]) for mesh in meshes]


def examined(mesh, repair=None):
    """The volume of a Blender mesh, and its edges of one face."""
    solid = bmesh.new()
    solid.from_mesh(mesh)
    if repair:
        repair(solid)
    found = sum(map(cone, solid.faces)), sum(edge.is_boundary for edge in solid.edges)
    solid.free()
    return found


def cone(face):
    """The volume between a face and the origin, bent quads halfway between the two ways to split them."""
    places = np.array([vertex.co for vertex in face.verts], float)
    middle = places.mean(axis=0)
    sides = places - middle
    return middle @ np.cross(sides, np.roll(sides, -1, axis=0)).sum(axis=0) / 6


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


def corner(swept, degrees):
    """The volume of a square's tube of two legs of 5 m round a sharp corner, its inner angle in degrees."""
    path = bent(degrees)
    ours = live(contour=sw.contours.Rectangle(1, 1), trajectory=sw.trajectories.Polyline(path))
    contour, bevel = curve(SQUARE, closed=True), Bevel(path)
    bevel.object.data.bevel_mode, bevel.object.data.bevel_object = "OBJECT", contour
    found = volumes(ours, CurveToMesh(curve(path), contour=contour).mesh(), bevel.mesh())
    cells = [*found, abs(swept(SQUARE, path).volume) if swept else ABSENT, opencascade.corner(path)]
    return [f"{cell:.3f}" if isinstance(cell, float) else cell for cell in cells]


def bent(degrees):
    """Two legs of 5 m that meet at an angle."""
    angle = np.radians(180 - degrees)
    return np.array([(0, 0, 0), (5, 0, 0), (5 + 5 * np.cos(angle), 5 * np.sin(angle), 0)])


def tube(swept, points, trajectory, radius):
    """By how much of its volume a closed round tube of 16 points is off: area times length of the path."""
    truth = np.pi * radius**2 * trajectory.length()
    ours = live(
        contour=sw.contours.Circle(radius, points=16),
        trajectory=sw.trajectories.Sampled(points, closed=True),
        samples=sw.sampling.Count(len(points)),
        fit="area-true",
    )
    meshes = ours, CurveToMesh(curve(points, closed=True), 16, radius).mesh(), Bevel(points, 16, radius, True).mesh()
    loop = np.concatenate((points, points[:1]))
    found = [*volumes(*meshes), abs(swept(ring(radius, 16), loop).volume) if swept else ABSENT]
    return [f"{volume / truth - 1:+.1e}" if isinstance(volume, float) else volume for volume in found]


def helix(swept, count):
    """How far a frame has turned from the one without spin, at worst: Bishop's theorem says where that is."""
    trajectory, rise = sw.trajectories.Helix(1.0, 0.5, 5.0), 0.5 / (2 * np.pi)
    u = np.linspace(0, 10 * np.pi, count)
    points = trajectory.evaluate(u)
    samples = sw.sampling.Count(count)
    ours = sw.GeneralizedCylinder(sw.contours.Circle(0.1, 16), sw.trajectories.Sampled(points), samples).mesh()
    node, bevel = CurveToMesh(curve(points), 16, 0.1).mesh(), Bevel(points, 16, 0.1).mesh()
    spokes = [ours.vertices.reshape(16, -1, 3)[0] - points]
    spokes += [vertices(mesh)[-16 * count :].reshape(count, 16, 3)[:, 0] - points for mesh in (node, bevel)]
    if swept:
        spokes.append(
            np.array(swept(ring(0.1, 16), points).vertices)[: 16 * count].reshape(count, 16, 3)[:, 0] - points
        )
    principal = np.stack((-np.cos(u), -np.sin(u), 0 * u), axis=1)
    binormal = np.cross(trajectory.tangents(u), principal)
    cells = []
    for spoke in spokes:
        angle = np.arctan2(np.einsum("ij,ij->i", spoke, binormal), np.einsum("ij,ij->i", spoke, principal))
        lag = angle - angle[0] + rise / np.hypot(1.0, rise) * u
        cells.append(f"{np.degrees(np.abs((lag + np.pi) % (2 * np.pi) - np.pi).max()):.1e}")
    return [*cells, *[ABSENT] * (not swept)]


def textures():
    """Stretch on a tube along an unevenly spaced polyline."""
    ours = live(contour=sw.contours.Circle(0.1, points=16), trajectory=sw.trajectories.Polyline(UNEVEN))
    return [f"{stretch(ours):.4f}", "-", f"{stretch(Bevel(UNEVEN, 16).mesh()):.4f}", "-", "-"]


def edges(swept):
    """Edges of one face on a capped tube of 16 points."""
    ours = live(contour=sw.contours.Circle(0.1, points=16), trajectory=sw.trajectories.Polyline(STRAIGHT))
    meshes = (ours, CurveToMesh(curve(STRAIGHT), 16).mesh(), Bevel(STRAIGHT, 16).mesh())
    cells = [examined(mesh)[1] for mesh in meshes]
    if not swept:
        return [*cells, ABSENT, "-"]
    _, uses = np.unique(swept(ring(0.1, 16), STRAIGHT).edges_sorted, axis=0, return_counts=True)
    return [*cells, np.count_nonzero(uses == 1), "-"]


def annulus(swept):
    """The volume of a pipe of outer radius 0.1 and inner radius 0.06 along 10 m, contours of 64 points."""
    outer, inner = ring(0.1, 64), ring(0.06, 64)
    contour = sw.contours.Outline(loops=[outer[:, :2], inner[:, :2]])
    ours = live(contour=contour, trajectory=sw.trajectories.Polyline(STRAIGHT))
    node = CurveToMesh(curve(STRAIGHT), contour=curve(outer, inner, closed=True))
    swept_volume = short(abs(swept(outer, STRAIGHT, inner).volume)) if swept else ABSENT
    return [*map(short, volumes(ours, node.mesh())), "-", swept_volume, "-"]


def knot():
    """How evenly twist is spread along a closed (2, 3) torus knot whose samples crowd."""
    points = 16
    u = np.linspace(0, 2 * np.pi, 400, endpoint=False)
    path = sw.trajectories.TorusKnot().evaluate(u + 0.3 * np.sin(u))
    trajectory, samples = sw.trajectories.Sampled(path, closed=True), sw.sampling.Tolerance(0.0001)
    ours = sw.GeneralizedCylinder(sw.contours.Circle(0.05, points=points), trajectory, samples).mesh()
    node = CurveToMesh(curve(path, closed=True), points, 0.05)
    by_columns = ours.vertices.reshape(points, -1, 3).swapaxes(0, 1)
    return [f"{unevenness(rings):.4f}" for rings in (by_columns, vertices(node.mesh()).reshape(-1, points, 3))]


def vertices(mesh):
    return np.array([vertex.co for vertex in mesh.vertices], float)


def unevenness(rings):
    """Twist per length from each ring (n, m, 3) to the next, the last to the first: largest to smallest.

    What turns beyond a normal carried by double reflection is twist, but for what leads one point to the next.
    """
    centre, spoke = rings.mean(axis=1), rings[:, 0] - rings.mean(axis=1)
    plane = np.cross(spoke, rings[:, rings.shape[1] // 4] - centre)
    e1, e2 = (part / np.linalg.norm(part, axis=1, keepdims=True) for part in (plane, spoke))
    chord = np.roll(centre, -1, axis=0) - centre
    ahead, arrived = np.roll(e1, -1, axis=0), mirrored(e1, chord)
    carried = mirrored(mirrored(e2, chord), ahead - arrived)
    reached = np.roll(e2, -1, axis=0)
    sine = np.einsum("ij,ij->i", np.cross(carried, reached), ahead)
    twist, part = np.arctan2(sine, np.einsum("ij,ij->i", carried, reached)), 2 * np.pi / rings.shape[1]
    twist = ((twist + part / 2) % part - part / 2) / np.linalg.norm(chord, axis=1)
    return np.abs(twist).max() / np.abs(twist).min()


def mirrored(vectors, normals):
    share = np.einsum("ij,ij->i", vectors, normals) / np.einsum("ij,ij->i", normals, normals)
    return vectors - 2 * share[:, None] * normals


def main():
    swept = trimesh_sweep()
    pipe = 0.5 * 64 * np.sin(2 * np.pi / 64) * (0.1**2 - 0.06**2) * 10
    turn, knotted = sw.trajectories.Arc(2.0, 2 * np.pi), sw.trajectories.TorusKnot(2, 3, 2.0, 0.8)
    tori = [
        (name, tube(swept, path.evaluate(np.linspace(0, 2 * np.pi, count, endpoint=False)), path, 0.5))
        for name, path, count in (
            ("a torus, radii 2 and 0.5, 32", turn, 32),
            ("a (2, 3) torus knot, 400", knotted, 400),
        )
    ]
    exact = opencascade.ring(2.0, 0.5)
    exact = f"{exact / turn.length() / np.pi / 0.25 - 1:+.1e}" if isinstance(exact, float) else exact
    pipes = annulus(swept)
    hollow = opencascade.straight(10.0, 0.1, 0.06)
    pipes[-1] = short(hollow) if isinstance(hollow, float) else hollow
    rows = [
        *([FRAME.format(count), 0, *helix(swept, count), "-"] for count in (101, 1001)),
        ["twist per length, closed (2, 3) knot, uneven points: largest to smallest", 1, *knot(), "-", "-", "-"],
        *(
            [f"volume off by: {name} points x 16", 0, *cells, last]
            for (name, cells), last in zip(tori, (exact, "-"), strict=True)
        ),
        *(
            [f"volume of a 1 x 1 square round a corner of {angle} degrees, legs of 5", 10, *corner(swept, angle)]
            for angle in (90, 30)
        ),
        ["volume of a pipe, radii 0.1 and 0.06, length 10, 64 points", short(pipe), *pipes],
        ["edges of one face, capped tube of 16 points", 0, *edges(swept)],
        ["UV stretch, tube along x = 0, 0.1, 0.2, 0.3, 5, 10: largest to smallest", 1, *textures()],
    ]
    tell(INTRODUCTION + "\n" + table(("", *COLUMNS), rows))


main()

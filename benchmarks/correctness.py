# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes whose truth is known, made by this project and by its peers: figures that anybody can check."""

import canals
import chords
import closing
import numpy as np
import opencascade
import turns
from measuring import short, table, tell
from peers import Bevel, CurveToMesh, curve, ring, trimesh_sweep
from solids import live, volumes

from bl_ext.user_default import sweep_addon as sw

UNEVEN = np.array([(x, 0, 0) for x in (0, 0.1, 0.2, 0.3, 5, 10)], float)
STRAIGHT = np.array([(0, 0, 0), (0, 0, 5), (0, 0, 10)], float)
SQUARE = np.array([(0.5, 0.5, 0), (-0.5, 0.5, 0), (-0.5, -0.5, 0), (0.5, -0.5, 0)])
ABSENT = "not installed"
COLUMNS = ("truth", "this project", "Curve to Mesh node", "Curve bevel", "trimesh", "OpenCASCADE")
INTRODUCTION = """
Every peer is given the same contour and the same points of the path, and this project a smooth path through them where
a smooth one is meant; only OpenCASCADE sweeps exact curves, of the knot a smooth one through its points, and its
volumes are those of its solids. Before a volume is measured a mesh is welded and turned outward, whosever it is, but
for a signed volume, which is negative where faces look inward; bent faces count halfway between the two ways to split
them. This project's volumes are measured in Blender, its frame and twist in the library, in double precision. The torus
and the knot are made by it with the fit `area-true`, which no peer has; with `inscribed`, the default, they are off as
the peers' are. The node closes a pipe inside and outside, as two solids one in the other.

How many contours a path needs is what each takes on its own, and for those that take a count the least that keeps the
distance: Blender's node *Resample Curve* and trimesh's `resample_path` spread points evenly by length, a bevel's
resolution evenly by the parameter of its Bezier circle, and OpenCASCADE's mesher by what the curve does. The truth
there is the integral of the square root of curvature over that of eight distances; no even chords can be fewer.

A dash: the peer has no such thing, or was not asked.
"""


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


def textures():
    """Stretch on a tube along an unevenly spaced polyline."""
    ours = live(contour=sw.contours.Circle(0.1, points=16), trajectory=sw.trajectories.Polyline(UNEVEN))
    return [f"{stretch(ours):.4f}", "-", f"{stretch(Bevel(UNEVEN, 16).mesh()):.4f}", "-", "-"]


def annulus(swept):
    """The volume of a pipe of outer radius 0.1 and inner radius 0.06 along 10 m, contours of 64 points."""
    outer, inner = ring(0.1, 64), ring(0.06, 64)
    contour = sw.contours.Outline(loops=[outer[:, :2], inner[:, :2]])
    ours = live(contour=contour, trajectory=sw.trajectories.Polyline(STRAIGHT))
    node = CurveToMesh(curve(STRAIGHT), contour=curve(outer, inner, closed=True))
    swept_volume = short(abs(swept(outer, STRAIGHT, inner).volume)) if swept else ABSENT
    solid = opencascade.straight(10.0, 0.1, 0.06)
    solid = solid if solid == ABSENT else short(solid)
    return [*map(short, volumes(ours, node.mesh())), "-", swept_volume, solid]


def tori(swept):
    """Two closed tubes."""
    ring_of, knotted = sw.trajectories.Arc(2.0, 2 * np.pi), sw.trajectories.TorusKnot(2, 3, 2.0, 0.8)
    for name, path, count in (("a torus, radii 2 and 0.5,", ring_of, 32), ("a (2, 3) torus knot,", knotted, 400)):
        points = path.evaluate(np.linspace(0, 2 * np.pi, count, endpoint=False))
        truth = np.pi * 0.25 * path.length()
        solid = opencascade.ring(2.0, 0.5) if path is ring_of else opencascade.knot(points, 0.5)
        volume, valid = solid if isinstance(solid, tuple) else (solid, True)
        last = f"{volume / truth - 1:+.1e}{'' if valid else ', not a valid solid'}" if volume != ABSENT else ABSENT
        yield [f"volume off by: {name} {count} points x 16", 0, *tube(swept, points, path, 0.5), last]


def main():
    swept = trimesh_sweep()
    pipe = 0.5 * 64 * np.sin(2 * np.pi / 64) * (0.1**2 - 0.06**2) * 10
    rows = [
        *turns.rows(swept),
        *chords.rows(),
        *tori(swept),
        *(
            [f"volume of a 1 x 1 square round a corner of {angle} degrees, legs of 5", 10, *corner(swept, angle)]
            for angle in (90, 30)
        ),
        ["volume of a pipe, radii 0.1 and 0.06, length 10, 64 points", short(pipe), *annulus(swept)],
        *closing.rows(swept),
        *canals.rows(),
        ["UV stretch, tube along x = 0, 0.1, 0.2, 0.3, 5, 10: largest to smallest", 1, *textures()],
    ]
    tell(INTRODUCTION + "\n" + table(("", *COLUMNS), rows))


main()

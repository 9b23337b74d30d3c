# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What closes a tube: its caps, the point it shrinks to, and which side of it is outside."""

import numpy as np
import opencascade
from peers import Bevel, CurveToMesh, curve, places, ring
from solids import examined, live

from bl_ext.user_default import sweep_addon as sw

LENGTH, SIDES, RADIUS = 10.0, 16, 0.1
STRAIGHT = np.array([(0, 0, 0), (0, 0, LENGTH / 2), (0, 0, LENGTH)])
BACK = np.array([(0, 0, 0), (0, 0, 5), (0, 0, 2)], float)
ROUND = sw.contours.Circle(RADIUS, SIDES)
ABSENT = "not installed"


def rows(swept):
    """What this project, the node, the bevel, trimesh and OpenCASCADE close a tube with."""
    yield ["edges of one face, capped tube of 16 points", 0, *edges(swept)]
    tips = [tip(mesh) for mesh in cones()]
    yield [
        f"vertices in the tip of a cone of {SIDES} points",
        1,
        *(count for count, *_ in tips),
        "-",
        opencascade.cone(),
    ]
    flaws = "faces without area and edges of one face, that cone"
    yield [flaws, "0 and 0", *(f"{flat} and {loose}" for _, flat, loose in tips), "-", "-"]
    corners, area = ring(0.5, SIDES), f"{SIDES / 8 * np.sin(2 * np.pi / SIDES):.3f}"
    for name, way in (("counter-clockwise", 1), ("clockwise", -1)):
        yield [f"signed volume of a tube of 1 m, contour {name}", area, *outward(swept, corners[::way]), "-"]
    yield ["volume of a path that turns back on itself: 5 m, then 3 m back", "refused", *reversal(swept), "-"]


def edges(swept):
    """Edges of one face on a capped tube."""
    ours = live(contour=ROUND, trajectory=sw.trajectories.Polyline(STRAIGHT))
    meshes = (ours, CurveToMesh(curve(STRAIGHT), SIDES, RADIUS).mesh(), Bevel(STRAIGHT, SIDES, RADIUS).mesh())
    cells = [examined(mesh)[1] for mesh in meshes]
    if not swept:
        return [*cells, ABSENT, "-"]
    _, uses = np.unique(swept(ring(RADIUS, SIDES), STRAIGHT).edges_sorted, axis=0, return_counts=True)
    return [*cells, np.count_nonzero(uses == 1), "-"]


def cones():
    """A tube whose scale falls evenly to 0, by a law, a field and the radii of points."""
    yield live(contour=ROUND, trajectory=sw.trajectories.Polyline(STRAIGHT), scale_x="1 - t", scale_y="1 - t")
    yield CurveToMesh(curve(STRAIGHT), SIDES, RADIUS, shrinking=True).mesh()
    bevel = Bevel(STRAIGHT, SIDES, RADIUS)
    bevel.object.data.splines[0].points.foreach_set("radius", np.linspace(1, 0, len(STRAIGHT)))
    yield bevel.mesh()


def tip(mesh):
    """How many vertices are where the path ends, faces that have no area, and edges of one face."""
    there = np.linalg.norm(places(mesh) - STRAIGHT[-1], axis=1) < 1e-6
    return np.count_nonzero(there), sum(face.area < 1e-9 for face in mesh.polygons), examined(mesh)[1]


def outward(swept, corners):
    """The signed volume of a tube of 1 m: negative where its faces look inward."""
    path = STRAIGHT / LENGTH
    ours = live(contour=sw.contours.Outline([corners[:, :2]]), trajectory=sw.trajectories.Polyline(path))
    contour, bevel = curve(corners, closed=True), Bevel(path)
    bevel.object.data.bevel_mode, bevel.object.data.bevel_object = "OBJECT", contour
    found = [examined(mesh)[0] for mesh in (ours, CurveToMesh(curve(path), contour=contour).mesh(), bevel.mesh())]
    return [*(f"{volume:.3f}" for volume in found), f"{swept(corners, path).volume:.3f}" if swept else ABSENT]


def reversal(swept):
    """The volume that is made of a path to and fro, or that it is refused."""
    try:
        ours = f"{examined(live(contour=ROUND, trajectory=sw.trajectories.Polyline(BACK)))[0]:.3f}"
    except sw.ShapeError:
        ours = "refused"
    meshes = CurveToMesh(curve(BACK), SIDES, RADIUS).mesh(), Bevel(BACK, SIDES, RADIUS).mesh()
    found = [f"{examined(mesh)[0]:.3f}" for mesh in meshes]
    return [ours, *found, f"{swept(ring(RADIUS, SIDES), BACK).volume:.3f}" if swept else ABSENT]

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Point membership beside the meshes of the same shapes: they agree but for what chords leave out.

The judge of a mesh is the side of its nearest face (`sweep_addon.core.distance`), which knows no sweep.
"""

import numpy as np
import pytest
from membership_shapes import APART, CHORD, SHAPES, body

import sweep_addon as sw
from sweep_addon.core.csg.meshes import closed_mesh
from sweep_addon.core.membership.sets.bodies import MeshBody
from sweep_addon.presets import PRESETS

pytest.importorskip("manifold3d", reason="solids of shapes that meet themselves are asked of manifold3d")
pytestmark = pytest.mark.thorough

QUICK = ("bolt_head", "pipe", "pipe_elbow", "duct", "spring", "steel_arch", "propeller_blade", "wine_glass")
CELLS = "general_sweep"  # their meshes are cut out of cells and follow poses
NO_SOLIDS = ("dangling_edges", "dangling_faces", "every_dimension", "joined_by_an_edge", "singular_point")
MET = {
    "moved block",
    "canal that swallows balls",
    "canal that begins within a ball",
    "canal with a flat end",
    "offset outside",
}  # their meshes have vertices within, or near


def compared(shape, mesh, count, seed=0):
    """The distances from the mesh's surface of points that are told otherwise by it, and how many are in."""
    low, high = mesh.box
    room = 0.02 * (high - low).max()
    points = np.random.default_rng(seed).uniform(low - room, high + room, (count, 3))
    labels, distance = sw.classify(shape, points), mesh.distance(points)
    return np.abs(distance[labels != np.where(distance < 0, 1, -1)]), int((labels == 1).sum())


@pytest.mark.parametrize("count", [2_000, pytest.param(20_000, marks=pytest.mark.large)])
@pytest.mark.parametrize("name", SHAPES)
def test_a_shape_is_where_its_mesh_is(name, count):
    off, inside = compared(SHAPES[name], body(name), count)
    assert off.max(initial=0.0) < CHORD
    assert inside > count / 50


@pytest.mark.parametrize("name", [name for kinds in APART for name in kinds if name not in MET])
def test_vertices_are_on(name):
    """Meshes are inscribed, so that their vertices lie on the true shape, of those that do not meet themselves."""
    shape = SHAPES[name]
    vertices = shape.mesh().vertices
    vertices = vertices[:: max(len(vertices) // 1000, 1)]
    labels = sw.classify(shape, vertices, tolerance=1e-7 * np.ptp(vertices, axis=0).max())
    assert (labels == 0).all()


def presets():
    for preset in PRESETS:
        if not preset.name.endswith(NO_SOLIDS):
            yield pytest.param(preset, id=preset.name, marks=() if preset.name in QUICK else pytest.mark.large)


@pytest.mark.parametrize("preset", list(presets()))
def test_a_preset_is_where_its_solid_is(preset):
    shape = sw.load(preset.path)
    off, inside = compared(shape, MeshBody(closed_mesh(shape)), 20_000)
    mesh = shape.mesh()
    chord = 5e-3 if preset.name.startswith(CELLS) else 2e-3
    assert off.max(initial=0.0) < chord * np.ptp(mesh.vertices, axis=0).max()
    assert len(off) < 200
    assert inside

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bent faces of Blender meshes that are cut before they are exported: all else on the mesh goes on."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

import sweep_addon as sw
from sweep_addon.bridge import objects
from sweep_addon.bridge.bent_faces import cut_about_the_middle

BANDS = 8


def bar(twist):
    shape = sw.GeneralizedCylinder(
        sw.contours.Rectangle(1.0, 1.0),
        sw.trajectories.Line(end=(0, 0, 4)),
        twist=twist,
        samples=sw.sampling.Count(BANDS + 1),
        texture="unit",
    )
    return objects.new_mesh(shape)


def values(data, name, columns=1):
    found = np.empty(len(data) * columns, np.float32)
    data.foreach_get(name, found)
    return found.reshape(-1, columns)


def test_cut_faces_keep_textures_attributes_materials_and_edges(scene):
    mesh = bar("pi * t")
    before, sharp = len(mesh.vertices), sum(edge.use_edge_sharp for edge in mesh.edges)
    cut_about_the_middle(mesh)
    assert len(mesh.vertices) == before + 4 * BANDS and len(mesh.polygons) == 4 * 4 * BANDS + 2
    assert sum(edge.use_edge_sharp for edge in mesh.edges) == sharp
    assert [sum(face.material_index == slot for face in mesh.polygons) for slot in (0, 1)] == [4 * 4 * BANDS, 2]
    assert all(face.use_smooth for face in mesh.polygons)
    corners, uv = values(mesh.loops, "vertex_index").ravel(), values(mesh.uv_layers[0].data, "uv", 2)
    along = values(mesh.attributes["arc_length"].data, "value").ravel()
    middles = np.arange(before, len(mesh.vertices))
    assert np.allclose(along[middles], values(mesh.vertices, "co", 3)[middles, 2], atol=1e-6)
    of_middles = np.unique(np.round(uv[np.isin(corners, middles)], 4), axis=0)
    columns, bands = (np.arange(4) + 0.5) / 4, (np.arange(BANDS) + 0.5) / BANDS
    expected = np.stack(np.meshgrid(bands, columns, indexing="ij"), axis=-1).reshape(-1, 2)
    turned = of_middles[:, ::-1] if len(np.unique(of_middles[:, 0])) == 4 else of_middles
    assert np.allclose(turned[np.lexsort(turned.T[::-1])], expected, atol=1e-3)
    assert not mesh.validate()


def test_flat_faces_stay_as_they_are(scene):
    mesh = bar("0")
    cut_about_the_middle(mesh)
    assert len(mesh.polygons) == 4 * BANDS + 2

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Offset surfaces of mesh objects follow these, and refuse what is not closed."""

import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import add, extent

import sweep_addon as sw
from sweep_addon.bridge import objects

CORNERS = [(x, y, z) for x in (-0.2, 0.2) for y in (-0.2, 0.2) for z in (-0.2, 0.2)]
FACES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def cube(faces):
    mesh = bpy.data.meshes.new("cube")
    mesh.from_pydata(CORNERS, [], faces)
    return add("cube", mesh)


def test_a_mesh_object_is_offset_and_followed(scene):
    model = cube(FACES)
    ob = add("offset", objects.new_mesh(sw.OffsetSurface(radius=0.1), solid=model))
    assert extent(ob) == pytest.approx((0.6, 0.6, 0.6), abs=1e-5)
    ob.data.sweep.offset_surface.radius = 0.2
    assert extent(ob) == pytest.approx((0.8, 0.8, 0.8), abs=1e-5)
    ob.data.sweep.offset_surface.side = "INSIDE"
    assert "must leave something" in ob.data.sweep.error
    for vertex in model.data.vertices:
        vertex.co *= 2
    model.data.update()
    bpy.context.view_layer.update()
    assert extent(ob) == pytest.approx((0.4, 0.4, 0.4), abs=1e-5) and ob.data.sweep.error == ""


def test_an_open_mesh_object_is_refused(scene):
    model = cube(FACES[1:])
    with pytest.raises(sw.ShapeError, match="solid: must be closed, got '4 open edges'"):
        objects.new_mesh(sw.OffsetSurface(), solid=model)

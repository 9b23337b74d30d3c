# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Classify: vertices and the cursor against the active sweep or tree, beside where solids are known to be."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import add, cube, select, sweep

import sweep_addon as sw
from sweep_addon.bridge import membership, operands


def cloud(points, name="cloud"):
    """A mesh object of loose points."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(np.asarray(points, float).tolist(), [], [])
    return add(name, mesh)


def written(ob, name="membership"):
    values = np.empty(len(ob.data.vertices), np.int8)
    ob.data.attributes[name].data.foreach_get("value", values)
    return values


def drilled():
    """A block of 2 x 2 x 1 m on the ground, with a square hole 1 m wide; both sweeps."""
    body = sw.to_object(sw.TranslationalSweep(sw.contours.Rectangle(2.0, 2.0), height=1.0), "body")
    hole = sw.to_object(sw.TranslationalSweep(sw.contours.Rectangle(1.0, 1.0), height=3.0), "hole")
    hole.location.z = -1
    operands.combine(body, [hole], "difference")
    return body


def test_vertices_are_in_on_and_out_of_a_tree_wherever_it_stands(scene):
    body = drilled()
    body.location, body.rotation_euler, body.scale = (3, 0, 0), (0, 0, 0.5), (2, 1, 1)
    bpy.context.view_layer.update()
    local = np.array([(0.75, 0, 0.5), (0.5, 0, 0.5), (0, 0, 0.5), (1, 0.25, 0.5), (0.75, 0, 1.5), (0.75, 0.75, 1.0)])
    matrix = np.array(body.matrix_world)
    points = cloud(local @ matrix[:3, :3].T + matrix[:3, 3])
    select(body, points)
    assert bpy.ops.object.sweep_classify() == {"FINISHED"}
    assert written(points).tolist() == [1, 0, -1, 0, -1, 0]
    kind = points.data.attributes["membership"]
    assert (kind.data_type, kind.domain) == ("INT8", "POINT")
    assert points.data.color_attributes.active_color.name == "membership_colour"


def test_random_points_beside_the_two_boxes(scene):
    body = drilled()
    points = np.random.default_rng(7).uniform(-1.5, 1.5, (2000, 3))
    other = cloud(points)
    select(body, other)
    bpy.ops.object.sweep_classify()
    x, y, z = np.array([vertex.co for vertex in other.data.vertices]).T
    inside = (np.abs(x) < 1) & (np.abs(y) < 1) & (0 < z) & (z < 1) & ((np.abs(x) > 0.5) | (np.abs(y) > 0.5))
    assert (written(other) == np.where(inside, 1, -1)).all() and inside.sum() > 100


def test_tolerance_is_a_distance(scene):
    tube = sweep()
    points = cloud([(0.49, 0, 1), (0.52, 0, 1), (0, 0, 1)])
    select(tube, points)
    bpy.ops.object.sweep_classify(tolerance=0.015)
    assert written(points).tolist() == [0, -1, 1]


def test_without_another_mesh_it_is_the_cursor(scene):
    tube = sweep()
    select(tube)
    scene.cursor.location = (0, 0, 1)
    assert bpy.ops.object.sweep_classify() == {"FINISHED"}
    assert membership.of_points(tube, np.array([scene.cursor.location])).tolist() == [1]


def test_a_tree_and_a_sweep_without_extent_along_an_axis_are_refused_by_a_sentence(scene):
    points = cloud([(0, 0, 1)])
    for ob in (drilled(), sweep()):
        ob.scale.y = 0
        select(ob, points)
        with pytest.raises(RuntimeError, match=f"must not be scaled to nothing, as '{ob.name}' is"):
            bpy.ops.object.sweep_classify()
    assert "membership" not in points.data.attributes


def test_an_open_sweep_is_a_surface_that_vertices_are_on(scene):
    tube, points = sweep(start="open"), cloud([(0, 0, 1), (0.5, 0, 1), (0, 0, 2)])
    select(tube, points)
    bpy.ops.object.sweep_classify()
    assert written(points).tolist() == [-1, 0, 0]


def test_a_mesh_that_is_no_sweep_is_not_classified_against(scene):
    select(cube(), cloud([(0, 0, 1)]))
    assert not bpy.ops.object.sweep_classify.poll()


def test_a_mesh_without_vertices_is_refused_by_a_sentence(scene):
    empty = add("empty", bpy.data.meshes.new("empty"))
    with pytest.raises(sw.ShapeError, match="mesh: must have vertices, got 'empty'"):
        membership.of_mesh(sweep(), empty)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Convert to CSG: an extruded sweep becomes a live tree of named primitives, and Evaluate makes it one sweep again."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import add, cube, select, shown, sweep

import sweep_addon as sw
from sweep_addon.bridge import objects, trees
from sweep_addon.core.conversion import kind

PLATE = sw.TranslationalSweep(
    sw.contours.Outline(
        [[(-2, -1), (2, -1), (2, 1), (-2, 1)], [(-0.5, 0), (0.5, 0)]], bulges=[[0, 0.4, 0, 0], [1, 1]], tolerance=1e-4
    ),
    height=0.5,
)
BULGE = 2 * np.arctan(0.4), 1.0 / np.sin(2 * np.arctan(0.4))  # half the arc's angle, its radius
AREA = 8 + BULGE[1] ** 2 * (BULGE[0] - np.sin(2 * BULGE[0]) / 2) - np.pi / 4  # the segment by formula, and the hole


def test_a_plate_becomes_a_block_a_chorded_cylinder_and_a_cylinder(scene):
    ob = sw.to_object(PLATE, "plate")
    ob.location, ob.rotation_euler = (1, 2, 3), (0, 0, 0.5)
    select(ob)
    assert bpy.ops.object.sweep_convert_to_csg() == {"FINISHED"}
    assert bpy.context.active_object == ob and tuple(ob.location) == (1, 2, 3)
    assert [step.object.name for step in trees.booleans(ob)] == ["Minor Chorded Cylinder", "Cylinder"]
    assert [step.operation for step in trees.booleans(ob)] == ["UNION", "DIFFERENCE"]
    assert shown(ob).volume() == pytest.approx(0.5 * AREA, rel=1e-3)
    trees.booleans(ob)[1].object.location.x = 0.25
    assert shown(ob).volume() == pytest.approx(0.5 * AREA, rel=1e-3)


def test_evaluate_gives_the_outline_back(scene):
    ob = sw.to_object(PLATE, "plate")
    select(ob)
    bpy.ops.object.sweep_convert_to_csg()
    assert bpy.ops.object.sweep_tree_evaluate() == {"FINISHED"}
    back = sw.from_object(ob)
    assert isinstance(back, sw.TranslationalSweep) and back.height == 0.5
    loops = sorted(zip(back.contour.loops, back.contour.bulges, strict=True), key=lambda pair: len(pair[0]))
    assert [len(loop) for loop, _ in loops] == [2, 4]
    assert np.allclose(np.sort(np.abs(loops[1][1])), [0, 0, 0, 0.4], atol=1e-3)
    assert np.allclose(np.abs(loops[0][1]), 1, atol=0.02)
    assert [each.name for each in bpy.data.objects] == ["plate"] and not ob.modifiers


def test_a_single_primitive_is_a_tree_without_steps(scene):
    ob = sw.to_object(sw.TranslationalSweep(sw.contours.Circle(1.0), height=2.0), "can")
    select(ob)
    assert bpy.ops.object.sweep_convert_to_csg() == {"FINISHED"}
    assert not ob.modifiers and shown(ob).volume() == pytest.approx(2 * np.pi, rel=3e-3)


def test_what_is_no_extrusion_is_refused(scene):
    select(sweep())
    assert not bpy.ops.object.sweep_convert_to_csg.poll()
    drafted = sw.to_object(sw.TranslationalSweep(sw.contours.Rectangle(2, 2), height=0.5, taper=0.2), "drafted")
    select(drafted)
    with pytest.raises(RuntimeError, match="taper: must be 0"):
        bpy.ops.object.sweep_convert_to_csg()
    assert sw.from_object(drafted).taper == 0.2


def test_a_tree_of_other_things_is_not_evaluated(scene):
    body, tool = cube(2.0, name="body"), cube(1.0, (1, 0, 0), "tool")
    select(body, tool)
    bpy.ops.object.sweep_union()
    with pytest.raises(RuntimeError, match="must be translational sweeps, got 'Triangles'"):
        bpy.ops.object.sweep_tree_evaluate()
    assert trees.is_tree(body) and len(bpy.data.objects) == 2


def test_a_curve_that_is_flattened_is_converted_by_its_arcs(scene):
    """A circle of Bezier segments, each three ten-thousandths off a true one: a cylinder, and no fan of prisms."""
    bpy.ops.curve.primitive_bezier_circle_add(radius=2.0)
    circle = bpy.context.object
    circle.data.dimensions, circle.data.resolution_u = "2D", 24
    mesh = objects.new_mesh(sw.TranslationalSweep(height=1.0), "can", contour=circle)
    ob = add("can", mesh)
    select(ob)
    assert bpy.ops.object.sweep_convert_to_csg() == {"FINISHED"}
    assert kind(sw.from_object(ob)) == "cylinder" and not ob.modifiers
    assert shown(ob).volume() == pytest.approx(4 * np.pi, rel=5e-3)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Offset surfaces of mesh objects, and those of curves in their plane, follow these, and refuse what is not closed."""

from math import cos, pi, sin

import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import add, curve, extent, select, text

import sweep_addon as sw
from sweep_addon.bridge import objects
from sweep_addon.properties import finding, live, solving

CORNERS = [(x, y, z) for x in (-0.2, 0.2) for y in (-0.2, 0.2) for z in (-0.2, 0.2)]
FACES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def cube(faces):
    mesh = bpy.data.meshes.new("cube")
    mesh.from_pydata(CORNERS, [], faces)
    return add("cube", mesh)


def test_a_mesh_object_is_offset_and_followed(scene):
    model = cube(FACES)
    ob = add("offset", objects.new_mesh(sw.OffsetSurface(radius=0.1), body=model))
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


def test_a_sweep_whose_curve_is_gone_is_offset_as_it_is_shown(scene):
    path = curve("POLY", [(0, 0, 0), (0, 0, 2)])
    pipe = add("pipe", objects.new_mesh(sw.GeneralizedCylinder(contour=sw.contours.Rectangle(1, 1)), trajectory=path))
    bpy.data.objects.remove(path)
    bpy.context.view_layer.update()
    assert pipe.data.sweep.error.startswith("trajectory: must be an object of the scene")
    ob = add("offset", objects.new_mesh(sw.OffsetSurface(radius=0.25), body=pipe))
    assert extent(ob) == pytest.approx((1.5, 1.5, 2.5), abs=1e-5)


def test_an_open_mesh_object_is_refused(scene):
    model = cube(FACES[1:])
    with pytest.raises(sw.ShapeError, match="body: must be closed, or .* a curve or text, .* got '4 open edges'"):
        objects.new_mesh(sw.OffsetSurface(), body=model)


def test_the_active_mesh_is_offset_where_it_stands(scene):
    model = cube(FACES)
    model.location, model.scale = (1, 2, 3), (2, 2, 2)
    select(model)
    assert bpy.ops.object.sweep_offset_selected() == {"FINISHED"}
    ob = bpy.context.active_object
    bpy.context.view_layer.update()
    assert ob.parent == model and objects.inputs(ob.data) == {"body": model}
    radius = ob.data.sweep.offset_surface.radius
    assert radius == pytest.approx(0.4 / 20)
    assert extent(ob) == pytest.approx([0.4 + 2 * radius] * 3, abs=1e-4)  # in the mesh's own space, which is scaled
    assert ob.matrix_world.translation[:] == pytest.approx((1, 2, 3))


def test_nothing_is_offset_but_meshes_curves_and_texts(scene):
    select(add("empty", None))
    with pytest.raises(RuntimeError, match="Select a closed mesh"):
        bpy.ops.object.sweep_offset_selected()


SQUARE = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]


def test_the_area_in_the_active_curve_is_offset_and_followed(scene):
    """A square of 2 m: 4 of area, 8 round, and four quarters of a disc."""
    square = curve("POLY", SQUARE)
    square.data.splines[0].use_cyclic_u = True
    select(square)
    assert bpy.ops.object.sweep_offset_selected() == {"FINISHED"}
    ob = bpy.context.active_object
    assert ob.parent == square and objects.inputs(ob.data) == {"body": square}
    group = ob.data.sweep.offset_surface
    assert group.radius == pytest.approx(2 / 20)
    group.tolerance = 1e-5
    assert area(ob) == pytest.approx(4 + 8 * 0.1 + pi * 0.01, abs=1e-4)
    group.side = "SHELL"
    assert area(ob) == pytest.approx(2 * 8 * 0.1 + (pi - 4) * 0.01, abs=1e-4)
    for point in square.data.splines[0].points:
        point.co.x *= 2
    square.data.update_tag()
    bpy.context.view_layer.update()
    assert area(ob) == pytest.approx(2 * 12 * 0.1 + (pi - 4) * 0.01, abs=1e-4)
    assert "true arcs" in ob.data.sweep.told
    group.side, group.radius = "INSIDE", 3.0
    assert "must leave something of the area inside" in ob.data.sweep.error


def test_letters_are_offset_whose_outline_turns_back_on_itself(scene):
    """The Q of Blender's own font, by a tenth: a margin as wide all round it, outwards and into its bow."""
    letter = text("Q")
    select(letter)
    assert bpy.ops.object.sweep_offset_selected() == {"FINISHED"}
    ob = bpy.context.active_object
    ob.data.sweep.offset_surface.radius = 0.1
    assert ob.data.sweep.error == ""
    assert extent(ob)[:2] == pytest.approx([side + 0.2 for side in letter.dimensions[:2]], abs=2e-3)


def area(ob):
    return sum(polygon.area for polygon in ob.data.polygons)


def test_an_open_curve_is_closed_by_a_straight_line_as_any_contour_is(scene):
    select(curve("POLY", SQUARE))
    assert bpy.ops.object.sweep_offset_selected() == {"FINISHED"}
    assert area(bpy.context.active_object) == pytest.approx(4 + 8 * 0.1 + pi * 0.01, rel=1e-3)


def test_a_circle_of_four_bezier_segments_is_offset_as_a_circle(scene):
    """A disc of radius 1 along the lecture's circle of radius 5: between 4 and 6, each a circle of two arcs."""
    bpy.ops.curve.primitive_bezier_circle_add(radius=5.0)
    circle = bpy.context.active_object
    ob = add("ring", objects.new_mesh(sw.OffsetSurface(radius=1.0, side="shell", tolerance=1e-4), body=circle))
    assert "0 lines and 4 true arcs" in ob.data.sweep.told
    assert area(ob) == pytest.approx(20 * pi, rel=1e-3)
    assert sw.from_object(ob).outline().area == pytest.approx(20 * pi, rel=3e-4)  # Bezier's is up to 2.7e-4 wider
    for point in circle.data.splines[0].bezier_points:
        point.co.x *= 2
        point.handle_left.x *= 2
        point.handle_right.x *= 2
    circle.data.update_tag()
    bpy.context.view_layer.update()
    assert area(ob) > 25 * pi


def test_a_polygon_whose_corners_lie_on_a_circle_is_offset_as_a_polygon(scene):
    around = [2 * pi * i / 32 for i in range(32)]
    drawn = curve("POLY", [(cos(a), sin(a), 0) for a in around])
    ob = add("ring", objects.new_mesh(sw.OffsetSurface(radius=0.1), body=drawn))
    assert "32 lines and 32 true arcs" in ob.data.sweep.told


def test_the_contour_of_an_offset_becomes_a_curve_and_a_solid_does_not(scene):
    ob = sw.to_object(sw.OffsetSurface(sw.contours.Rectangle(2.0, 1.0), 0.25, tolerance=1e-5))
    before = area(ob)
    select(ob)
    assert bpy.ops.object.sweep_edit_as_curve(parameter="body") == {"FINISHED"}
    assert ob.parent == objects.inputs(ob.data)["body"]
    assert area(ob) == pytest.approx(before, rel=1e-5) and before == pytest.approx(2 + 1.5 + pi / 16, abs=1e-4)
    solid = sw.to_object(sw.OffsetSurface())
    select(solid)
    with pytest.raises(RuntimeError, match="must be a contour to become a curve"):
        bpy.ops.object.sweep_edit_as_curve(parameter="body")


def test_an_offset_region_comes_back_as_it_was_given(scene):
    shape = sw.OffsetSurface(sw.contours.Star(7, 0.5, 0.25), 0.125, "shell")
    assert sw.from_object(sw.to_object(shape)) == shape


def test_in_a_window_a_rough_offset_stands_until_the_true_one_is_made(scene, monkeypatch):
    monkeypatch.setattr(live, "waits", lambda depsgraph: True)
    ob = sw.to_object(sw.OffsetSurface(sw.solids.Ball(0.2, 16), radius=0.1))
    assert ob.data.sweep.solid == live.AWAITED and extent(ob)[2] == pytest.approx(0.6, rel=0.02)
    work = solving.work_of(ob.data)
    work.thread.join()
    solving.finish(ob.data, work)
    assert ob.data.sweep.solid == "" and "Engine convex, as" in ob.data.sweep.told


def test_it_meets_itself_nowhere_and_has_no_frames(scene):
    ob = sw.to_object(sw.OffsetSurface())
    assert finding.find(ob.data) == ()

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh follows its parameters, whoever changes them, and is left alone where nothing has changed."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import add, extent, parameters_of, places, select, straight, sweep

from sweep_addon.bridge import meshes, objects
from sweep_addon.core.contours import Circle, Rectangle
from sweep_addon.core.shapes.translational_sweep import TranslationalSweep
from sweep_addon.properties import handlers, live

RADIUS = "sweep.generalized_cylinder.contour_circle_radius"


@pytest.fixture
def written(monkeypatch):
    """The names of the meshes that were written, one for each time."""
    names, write = [], meshes.write
    monkeypatch.setattr(meshes, "write", lambda mesh, *others: names.append(mesh.name) or write(mesh, *others))
    return names


def update():
    bpy.context.view_layer.update()


def driven(mesh, ob):
    """Let an object's x be the radius."""
    driver = mesh.driver_add(RADIUS).driver
    driver.type = "SUM"
    variable = driver.variables.new()
    variable.type = "TRANSFORMS"
    variable.targets[0].id, variable.targets[0].transform_type = ob, "LOC_X"


def keyed(mesh):
    """A radius of 0.5 at frame 1 that has grown to 2.5 at frame 11, and is half way at frame 6."""
    for frame, radius in ((1, 0.5), (11, 2.5)):
        mesh.sweep.generalized_cylinder.contour_circle_radius = radius
        mesh.keyframe_insert(RADIUS, frame=frame)


def test_property_set_by_a_script_is_the_mesh_at_once(scene):
    ob = sweep()
    parameters_of(ob).contour_circle_radius = 1.5
    assert extent(ob) == pytest.approx((3, 3, 2))
    parameters_of(ob).trajectory_line_end = (0, 0, 7)
    assert extent(ob) == pytest.approx((3, 3, 7))
    parameters_of(ob).contour = "RECTANGLE"
    assert len(ob.data.vertices) == 8


def test_a_fit_is_chosen_live(scene):
    """An octagon in the circle of 1 m, one with its area, and one about it."""
    ob = sweep(contour=Circle(1.0, 8))
    areas = {"INSCRIBED": 8 / 2 * np.sin(np.pi / 4), "AREA_TRUE": np.pi, "CIRCUMSCRIBED": 8 * np.tan(np.pi / 8)}
    for fit, area in areas.items():
        parameters_of(ob).fit = fit
        radius = extent(ob)[0] / 2
        assert 8 / 2 * np.sin(np.pi / 4) * radius**2 == pytest.approx(area)


def test_many_properties_are_one_rebuild_where_they_wait(scene, written):
    ob = sweep()
    written.clear()
    ob.data.sweep.paused = True
    parameters_of(ob).contour_circle_radius = 1.5
    parameters_of(ob).trajectory_line_end = (0, 0, 7)
    assert written == []
    ob.data.sweep.paused = False
    assert written == ["sweep"] and extent(ob) == pytest.approx((3, 3, 7))


def test_keyframes_are_followed_by_every_frame(scene):
    ob = sweep()
    keyed(ob.data)
    for frame, radius in ((1, 0.5), (11, 2.5), (6, 1.5), (1, 0.5)):
        scene.frame_set(frame)
        assert extent(ob) == pytest.approx((2 * radius, 2 * radius, 2))


def test_driver_is_followed_without_a_frame_change(scene):
    ob, handle = sweep(), add("handle", None)
    driven(ob.data, handle)
    handle.location.x = 1.25
    update()
    assert extent(ob) == pytest.approx((2.5, 2.5, 2))


def test_driver_is_followed_by_frame_changes(scene):
    ob, handle = sweep(), add("handle", None)
    driven(ob.data, handle)
    for frame, x in ((1, 1), (11, 3)):
        handle.location.x = x
        handle.keyframe_insert("location", frame=frame)
    for frame, x in ((1, 1), (11, 3)):
        scene.frame_set(frame)
        assert extent(ob) == pytest.approx((2 * x, 2 * x, 2))


def test_keyframes_drivers_and_materials_survive_a_new_topology(scene):
    ob, handle = sweep(), add("handle", None)
    side = bpy.data.materials.new("side")
    ob.data.materials[0] = side
    driven(ob.data, handle)
    ob.data.keyframe_insert("sweep.generalized_cylinder.trajectory_line_end", frame=1)
    parameters_of(ob).contour = "RECTANGLE"
    parameters_of(ob).contour = "CIRCLE"
    animation = ob.data.animation_data
    assert animation.action and len(animation.drivers) == 1
    assert list(ob.data.materials) == [side, None]


def test_a_sweep_that_is_shaded_flat_stays_so_in_a_new_topology(scene):
    """Blender draws a mesh with the normals of its faces where it is flat as a whole, and so do renders."""
    ob = sweep()
    shaded = []
    for shade in (None, bpy.ops.object.shade_flat, bpy.ops.object.shade_smooth):
        if shade:
            select(ob)
            shade()
        shaded.append(ob.data.normals_domain)
        parameters_of(ob).contour_circle_points += 1
        assert ob.data.normals_domain == shaded[-1]
    assert shaded[1] == "FACE" and shaded[0] == shaded[2] != "FACE"


@pytest.mark.parametrize("by_operator", [False, True])
def test_a_copy_with_its_own_data_is_independent(scene, by_operator):
    ob = sweep()
    if by_operator:
        select(ob)
        bpy.ops.object.duplicate(linked=False)
        copy = bpy.context.active_object
    else:
        copy = add("copy", ob.data.copy())
    parameters_of(copy).contour_circle_radius = 1.5
    assert extent(copy) == pytest.approx((3, 3, 2)) and extent(ob) == pytest.approx((1, 1, 2))
    parameters_of(ob).contour_circle_radius = 0.75
    assert extent(copy) == pytest.approx((3, 3, 2)) and extent(ob) == pytest.approx((1.5, 1.5, 2))


def test_a_linked_duplicate_shares_parameters_and_mesh(scene):
    ob = sweep()
    select(ob)
    bpy.ops.object.duplicate(linked=True)
    twin = bpy.context.active_object
    parameters_of(twin).contour_circle_radius = 1.5
    assert twin != ob and extent(ob) == pytest.approx((3, 3, 2))


def test_where_nothing_changed_nothing_is_written(scene, written):
    path = straight()
    ob = sweep(trajectory=path)
    written.clear()
    parameters_of(ob).contour_circle_radius = 0.5  # as it was
    path.location.x = 3  # the sweep is parented to it
    update()
    scene.frame_set(5)
    ob.data.update_tag()
    update()
    assert written == []


def test_a_change_is_written_once(scene, written):
    path = straight()
    ob = sweep(trajectory=path)
    written.clear()
    path.data.splines[0].points[1].co.z = 3
    update()
    assert written == ["sweep"] and extent(ob)[2] == 3


def test_an_unrelated_animation_reads_nothing_of_200_sweeps(scene, monkeypatch):
    for _ in range(200):
        sweep()
    handle = add("handle", None)
    handle.keyframe_insert("location", frame=1)
    handle.location.x = 5
    handle.keyframe_insert("location", frame=11)
    update()
    read = []
    for module, name in ((live.objects, "shapes"), (objects.rna, "objects"), (handlers, "rebuild"), (meshes, "write")):
        monkeypatch.setattr(module, name, lambda *_, name=name: read.append(name))

    for frame in range(1, 6):
        scene.frame_set(frame)
        handle.location.y = frame
        update()

    assert handle.location.x > 0 and read == []


def test_an_animated_curve_that_no_sweep_uses_rebuilds_none_of_them(scene, monkeypatch):
    path = straight()
    sweep(), sweep(trajectory=straight())
    path.keyframe_insert("location", frame=1)
    update()
    read = []
    monkeypatch.setattr(live.objects, "shapes", lambda *_: read.append("shapes"))
    path.location.x = 5
    path.keyframe_insert("location", frame=11)
    for frame in (1, 5, 11):
        scene.frame_set(frame)
    assert path.location.x == 5 and read == []


def test_shape_keys_are_refused_in_a_sentence_and_the_mesh_is_kept(scene):
    ob = sweep()
    ob.shape_key_add(name="Basis")
    ob.shape_key_add(name="Bent").data[0].co = (9, 9, 9)
    parameters_of(ob).contour_circle_radius = 1.5
    assert ob.data.sweep.error.startswith("The mesh has shape keys") and extent(ob) == pytest.approx((1, 1, 2))
    assert ob.data.shape_keys.key_blocks["Bent"].data[0].co.x == 9

    ob.shape_key_clear()
    update()
    assert ob.data.sweep.error == "" and extent(ob) == pytest.approx((3, 3, 2))


def test_a_refused_value_keeps_the_mesh_and_the_next_good_one_replaces_it(scene):
    ob = sweep()
    before = places(ob.data)
    parameters_of(ob).contour_circle_radius = 0
    assert ob.data.sweep.error == "contour.radius: must be more than 0, got 0"
    assert np.array_equal(places(ob.data), before)
    parameters_of(ob).contour_circle_radius = 1.5
    assert ob.data.sweep.error == "" and extent(ob) == pytest.approx((3, 3, 2))


def test_a_mesh_without_parameters_is_left_alone(scene, written):
    mesh = bpy.data.meshes.new("plain")
    mesh.from_pydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [], [(0, 1, 2)])
    add("plain", mesh)
    update()
    scene.frame_set(3)
    assert written == [] and len(mesh.vertices) == 3


def test_a_taper_is_changed_past_where_edges_vanish_and_walls_meet(scene):
    """Of a rounded plate the fillets vanish, then it is a roof; where nothing would be left it stays as it was."""
    ob = add("plate", objects.new_mesh(TranslationalSweep(Rectangle(4.0, 2.0, 0.25), 1.0)))
    parameters = ob.data.sweep.translational_sweep
    counts = []
    for taper in (0.1, 0.5, 0.785398163, 1.0):
        parameters.taper = taper
        counts.append((len(ob.data.vertices), round(extent(ob)[2], 5)))
    assert [height for _, height in counts] == [1, 1, 1, 1]
    assert counts[0][0] > counts[1][0] > counts[2][0] == counts[3][0]
    assert "nothing is left" in ob.data.sweep.error
    parameters.taper = 0.1
    assert len(ob.data.vertices) == counts[0][0] and not ob.data.sweep.error

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files: a sweep saved and opened again, appended, linked, and read from the files of every past version."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import cube, curve, extent, parameters_of, places, select, square, straight, sweep, text
from write_format import DATA, SHAPE

import sweep_addon as sw
from sweep_addon.bridge import meshes, objects
from sweep_addon.core.declared.forms import VERSION


def update():
    bpy.context.view_layer.update()


@pytest.fixture
def saved(scene, tmp_path):
    """A file with a sweep of two curves whose radius has a driver, and one with keyframes."""
    ob = sweep(trajectory=straight(), contour=square())
    keyed = sweep()
    keyed.name = keyed.data.name = "keyed"
    for frame, radius in ((1, 0.5), (11, 2.5)):
        parameters_of(keyed).contour_circle_radius = radius
        parameters_of(keyed).keyframe_insert("contour_circle_radius", frame=frame)
    scene.frame_set(1)
    assert extent(ob) == pytest.approx((1, 1, 2))
    path = tmp_path / "saved.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    return path


def empty():
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)


def follows_its_curves(ob):
    """Whether a sweep follows what its trajectory and contour are now."""
    group = parameters_of(ob)
    group.trajectory_object.data.splines[0].points[1].co.z = 5
    group.contour_object.scale.x = 3
    update()
    return extent(ob) == pytest.approx((3, 1, 5)) and ob.data.sweep.error == ""


def test_reopened_file_is_written_by_nobody_and_still_live(saved, monkeypatch):
    empty()
    names, write = [], meshes.write
    monkeypatch.setattr(meshes, "write", lambda mesh, *others: names.append(mesh.name) or write(mesh, *others))
    bpy.ops.wm.open_mainfile(filepath=str(saved))
    update()
    assert names == [] and not any(mesh.sweep.edited or mesh.sweep.error for mesh in bpy.data.meshes)
    bpy.context.scene.frame_set(6)
    assert names == ["keyed"] and extent(bpy.data.objects["keyed"]) == pytest.approx((3, 3, 2))
    assert follows_its_curves(bpy.data.objects["sweep"])


def test_appended_object_brings_its_curves_and_is_live(saved):
    empty()
    bpy.ops.wm.append(directory=f"{saved}/Object/", filename="sweep")
    ob = bpy.data.objects["sweep"]
    update()
    assert extent(ob) == pytest.approx((1, 1, 2))
    assert follows_its_curves(ob)


def test_linked_object_is_live_where_it_was_made_to_move(saved):
    """Nobody can change its parameters here, but its keyframes go on in every file that links it."""
    empty()
    with bpy.data.libraries.load(str(saved), link=True) as (_, here):
        here.objects = ["sweep", "keyed"]
    ob, keyed = here.objects
    for linked in here.objects:
        bpy.context.scene.collection.objects.link(linked)
    update()
    before = places(ob.data)
    assert extent(ob) == pytest.approx((1, 1, 2))

    for frame, width in ((11, 5), (1, 1), (6, 3)):
        bpy.context.scene.frame_set(frame)
        assert extent(keyed) == pytest.approx((width, width, 2))
    ob.data.update_tag()
    update()

    assert np.array_equal(places(ob.data), before)
    for linked in here.objects:
        assert linked.data.sweep.error == "" and not linked.data.sweep.edited
    assert not objects.is_editable_sweep(ob) and objects.is_sweep(ob)


def test_linked_curve_is_an_input(saved):
    empty()
    with bpy.data.libraries.load(str(saved), link=True) as (_, here):
        here.objects = ["path"]
    bpy.context.scene.collection.objects.link(here.objects[0])
    ob = sweep(trajectory=here.objects[0])
    assert extent(ob) == pytest.approx((1, 1, 2)) and ob.data.sweep.error == ""


def test_a_linked_curve_whose_file_is_gone_keeps_the_mesh_and_says_which(saved, tmp_path):
    test_linked_curve_is_an_input(saved)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "follows.blend"), relative_remap=False)
    saved.rename(tmp_path / "elsewhere.blend")
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "follows.blend"))
    ob = bpy.data.objects["sweep"]
    parameters_of(ob).contour_circle_radius = 3
    sentence = f"trajectory: must be an object of the scene; 'path' is missing, of the file {str(saved)!r}"
    assert extent(ob) == pytest.approx((1, 1, 2)) and ob.data.sweep.error == sentence


def test_linked_sweep_made_local_is_live(saved):
    empty()
    bpy.ops.wm.link(directory=f"{saved}/Object/", filename="keyed")
    ob = bpy.data.objects["keyed"]
    bpy.ops.object.make_local(type="ALL")
    update()
    parameters_of(ob).trajectory_line_end = (0, 0, 7)
    assert extent(ob) == pytest.approx((1, 1, 7))


@pytest.fixture
def overridden(saved):
    """The mesh of a linked sweep as a library override, on an object that is one too."""
    empty()
    with bpy.data.libraries.load(str(saved), link=True) as (_, here):
        here.objects = ["keyed"]
    linked = here.objects[0]
    ob = linked.override_create(remap_local_usages=False)
    bpy.context.scene.collection.objects.link(ob)
    ob.data = linked.data.override_create(remap_local_usages=False)
    update()
    return ob


def test_an_override_of_a_linked_mesh_is_live(overridden):
    group = parameters_of(overridden)
    group.trajectory_line_end = (0, 0, 7)
    update()
    assert extent(overridden) == pytest.approx((1, 1, 7)) and overridden.data.sweep.error == ""
    group.contour_circle_points = 16
    update()
    assert len(overridden.data.vertices) == 32 and extent(overridden) == pytest.approx((1, 1, 7))
    assert not overridden.data.sweep.edited and not overridden.data.validate()


def test_fields_of_an_override_can_be_changed_in_the_sidebar(overridden):
    own, others = parameters_of(overridden), parameters_of(sweep())
    fields = [each for each in own.bl_rna.properties.keys() if each not in ("rna_type", "name")]
    grey = [each for each in fields if own.is_property_readonly(each)]
    assert overridden.data.is_editable and grey == [each for each in fields if others.is_property_readonly(each)]


def test_contours_on_the_way_that_an_override_has_more_are_in_the_file(overridden, tmp_path):
    select(overridden)
    bpy.ops.object.sweep_item_add(parameter="morph")
    item = parameters_of(overridden).morph[0]
    item.contour, item.contour_circle_radius = "CIRCLE", 3
    name, width = overridden.name, extent(overridden)
    path = str(tmp_path / "overridden.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.open_mainfile(filepath=path)
    assert width[0] == pytest.approx(6) and extent(bpy.data.objects[name]) == pytest.approx(width)


def test_an_override_is_in_the_file_with_its_own_parameters(overridden, tmp_path):
    parameters_of(overridden).trajectory_line_end = (0, 0, 7)
    name, path = overridden.name, str(tmp_path / "overridden.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    empty()
    bpy.ops.wm.open_mainfile(filepath=path)
    ob = bpy.data.objects[name]
    assert ob.data.override_library and extent(ob) == pytest.approx((1, 1, 7))
    bpy.context.scene.frame_set(11)
    assert extent(ob) == pytest.approx((5, 5, 7))


def test_an_override_is_not_applied_since_its_mesh_is_the_other_files(overridden):
    select(overridden)
    assert not bpy.ops.object.sweep_apply.poll()


def test_version_of_the_parameters_is_in_the_file(scene):
    """A default is not saved: a newer program would read an old file as one of its own version."""
    assert VERSION == sweep().data.sweep.version
    assert sweep().data.sweep.is_property_set("version")


def test_every_parameter_is_in_the_file(scene):
    """So a shape stays what it is when a default changes."""
    group = parameters_of(sweep())
    assert all(group.is_property_set(name) for name in ("scale_x", "scale_x_constant_value", "start", "samples"))


def test_job_of_format_1_reads_as_it_was_meant():
    assert sw.load(DATA / "format_1.toml") == SHAPE


def test_blend_file_of_format_1_reads_as_it_was_meant_and_is_live(scene):
    bpy.ops.wm.open_mainfile(filepath=str(DATA / "format_1.blend"))
    numbers, curves = bpy.data.objects["numbers"], bpy.data.objects["curves"]
    assert [mesh.sweep.version for mesh in bpy.data.meshes] == [1, 1]
    assert sw.from_object(numbers) == SHAPE
    assert numbers.data.sweep.error == "" and meshes.equal(numbers.data, SHAPE.mesh(dtype="f4"))
    assert extent(curves) == pytest.approx((1, 1, 2))
    assert follows_its_curves(curves)
    bpy.context.scene.frame_set(11)
    assert parameters_of(curves).twist_constant_value == pytest.approx(3)


def test_weights_of_a_curve_survive_a_file(scene, tmp_path):
    ring = curve("NURBS", np.c_[np.random.default_rng(5).normal(size=(6, 3)), [1, 2, 1, 3, 1, 2]], use_cyclic_u=True)
    ob = sweep(trajectory=ring)
    before = places(ob.data)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "ring.blend"))
    empty()
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "ring.blend"))
    ob = bpy.data.objects["sweep"]
    ob.data.sweep.made = ""  # so that it is made again
    parameters_of(ob).contour_circle_points = parameters_of(ob).contour_circle_points
    assert ob.data.sweep.made and np.array_equal(places(ob.data), before)


@pytest.mark.parametrize(
    ("key", "name", "sentence"),
    [
        ("trajectory", "two", "must be a curve of one spline, and of more each in an object of its own, got 2"),
        ("trajectory", "letters", "must be a curve object, got 'text'"),
        ("contour", "cube", "must be a curve or text object, got 'mesh'"),
    ],
)
def test_a_job_refuses_an_object_that_it_cannot_take_whole(scene, tmp_path, key, name, sentence):
    """Of two splines the second had been left out."""
    made = {curve("POLY", [(0, 0, 0), (0, 0, 2)], [(5, 0, 0), (5, 0, 2)], name="two"), text("B", "letters"), cube()}
    bpy.data.libraries.write(str(tmp_path / "inputs.blend"), made)
    job = tmp_path / "job.toml"
    job.write_text(f"kind = 'generalized-cylinder'\n{key} = {{ file = 'inputs.blend', object = '{name}' }}")
    with pytest.raises(sw.ShapeError) as refusal:
        sw.load(job)
    assert str(refusal.value) == f"{job}:2: {key}.object: {sentence}"


def test_a_job_says_the_corners_of_a_curve_in_a_file(scene, tmp_path):
    """The curve is scaled, the radius is in metres."""
    bent, smooth = [(0, 0, 0), (0, 0, 2), (0, 2, 2)], [(0, 0, 0), (0, 0, 1), (0, 1, 2), (0, 1, 3)]
    both = {curve("POLY", bent, name="bent"), curve("NURBS", smooth, name="smooth")}
    bpy.data.libraries.write(str(tmp_path / "paths.blend"), both)
    empty()

    def trajectory(said):
        job = tmp_path / "job.toml"
        job.write_text(f"kind = 'generalized-cylinder'\ntrajectory = {{ file = 'paths.blend', {said} }}")
        return sw.load(job).trajectory

    corner = "corner = { kind = 'round', radius = 0.5 }"
    expected = sw.trajectories.Polyline(3 * np.array(bent), corner=sw.corners.Round(0.5))
    assert trajectory(f"object = 'bent', scale = 3, {corner}") == expected
    assert trajectory("object = 'bent', scale = 3") == sw.trajectories.Polyline(3 * np.array(bent))
    with pytest.raises(sw.ShapeError, match="trajectory.corner: stands for .* of straight legs only, got 'round'"):
        trajectory(f"object = 'smooth', {corner}")
    with pytest.raises(sw.ShapeError, match="trajectory.corner.radius: must be at most 2 to fit"):
        trajectory(f"object = 'bent', {corner.replace('0.5', '5')}")

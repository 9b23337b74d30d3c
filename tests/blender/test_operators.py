# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a user can do, without a window: add, sweep what is selected, apply, copy; where it cannot be done, why."""

from types import SimpleNamespace

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

import bmesh
from mathutils import Matrix, Vector
from scenes import add, curve, extent, parameters_of, places, select, square, straight, sweep, text, tried

import sweep_addon as sw
from sweep_addon import presets
from sweep_addon.bridge import objects, placing
from sweep_addon.core.declared.parameters import spelled
from sweep_addon.core.shapes.kinds import SHAPES


def known():
    """All that Blender holds, by name."""
    return {repr(data) for data in bpy.data.user_map()}


def enclosed(mesh):
    """The volume that a mesh encloses, by Blender's own sum; it must be closed, with nothing to repair."""
    measured = bmesh.new()
    measured.from_mesh(mesh)
    assert measured.edges and all(edge.is_manifold and edge.is_contiguous for edge in measured.edges)
    volume = measured.calc_volume(signed=True)
    measured.free()
    assert not mesh.validate() and volume > 0
    return volume


def test_added_shape_stands_where_it_is_asked_to(scene):
    scene.cursor.location = (1, 2, 3)
    assert bpy.ops.mesh.generalized_cylinder_add(contour_circle_radius=0.5) == {"FINISHED"}
    ob = bpy.context.active_object
    assert tuple(ob.location) == (1, 2, 3) and ob.select_get()
    assert parameters_of(ob).contour_circle_radius == 0.5
    assert enclosed(ob.data) > 0
    bpy.ops.mesh.generalized_cylinder_add(location=(4, 0, 0), rotation=(0, 1, 0))
    ob = bpy.context.active_object
    assert tuple(ob.location) == (4, 0, 0) and ob.rotation_euler.y == pytest.approx(1)


def test_added_shape_joins_the_mesh_that_is_edited(scene):
    """As Blender's own shapes do."""
    bpy.ops.mesh.primitive_cube_add()
    cube = bpy.context.active_object
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.generalized_cylinder_add(trajectory="LINE", contour="RECTANGLE")
    bpy.ops.object.mode_set(mode="OBJECT")
    assert len(cube.data.vertices) == 16 and list(scene.collection.objects) == [cube]
    assert cube.data.sweep.kind == "NONE"


OPEN = {"mixed_dimension", "plane_region", presets.GROWN}


@pytest.mark.parametrize("name", tried(p.name for p in presets.PRESETS if p.group not in OPEN))
def test_preset_is_closed_and_valid_wherever_it_stands(scene, made_once, name):
    assert bpy.ops.mesh.sweep_preset_add(preset=name.upper()) == {"FINISHED"}
    ob = bpy.context.active_object
    assert ob.name == presets.title(name)
    volume = enclosed(ob.data)
    bpy.ops.mesh.sweep_preset_add(preset=name.upper(), follow=False, location=(1, 2, 3), rotation=(1, 0, 0))
    assert tuple(bpy.context.active_object.location) == (1, 2, 3)
    assert enclosed(bpy.context.active_object.data) == pytest.approx(volume)


def test_the_preset_that_is_added_where_none_is_named_is_a_pipe(scene):
    assert bpy.ops.mesh.sweep_preset_add() == {"FINISHED"}
    assert bpy.context.active_object.name == "Pipe"


@pytest.mark.parametrize("name", tried(p.name for p in presets.PRESETS if p.group == presets.GROWN))
def test_preset_of_a_grammar_has_the_valid_mesh_of_its_shape(scene, name):
    assert bpy.ops.mesh.sweep_preset_add(preset=name.upper()) == {"FINISHED"}
    ob, expected = bpy.context.active_object, presets.shape(name).mesh()
    assert ob.name == presets.BY_NAME[name].title and not ob.data.sweep.error
    assert len(ob.data.vertices) == len(expected.vertices) and len(ob.data.polygons) == len(expected.offsets) - 1
    assert not ob.data.validate()


@pytest.mark.parametrize("name", [p.name for p in presets.PRESETS if p.group == "mixed_dimension"])
def test_preset_of_mixed_dimension_says_of_what_it_is(scene, name):
    assert bpy.ops.mesh.sweep_preset_add(preset=name.upper()) == {"FINISHED"}
    assert bpy.context.active_object.data.sweep.told.startswith("Parts: ")


@pytest.mark.parametrize("name", [p.name for p in presets.PRESETS if p.group == "plane_region"])
def test_preset_of_a_plane_region_is_flat_faces_that_look_up(scene, name):
    assert bpy.ops.mesh.sweep_preset_add(preset=name.upper()) == {"FINISHED"}
    mesh = bpy.context.active_object.data
    assert mesh.sweep.error == "" and all(polygon.normal.z > 0.999 for polygon in mesh.polygons)


def test_straight_preset_follows_the_active_curve_if_that_is_selected_and_asked_for(scene):
    path = curve("POLY", [(0, 0, 0), (5, 0, 0)], name="path")
    for selected, follow, long in ((True, True, True), (True, False, False), (False, True, False)):
        select(path)
        path.select_set(selected)
        bpy.ops.mesh.sweep_preset_add(preset="PIPE", follow=follow)
        ob = bpy.context.active_object
        assert (ob.parent == path) == long and (extent(ob)[0] == pytest.approx(5)) == long
        assert enclosed(ob.data) > 0


def test_refused_shape_leaves_nothing_behind(scene):
    before = known()
    for radius in (0, -1):
        with pytest.raises(RuntimeError, match=f"contour.radius: must be more than 0, got {radius}$"):
            bpy.ops.mesh.generalized_cylinder_add(contour_circle_radius=radius)
    with pytest.raises(RuntimeError, match="samples.contours: must be at most 200000, got 1000000000"):
        bpy.ops.mesh.generalized_cylinder_add(samples="COUNT", samples_count_contours=10**9)
    assert known() == before


def test_one_curve_gets_a_circle_along_it(scene):
    path = straight()
    path.location = (3, 0, 0)
    select(path)
    assert bpy.ops.object.sweep_selected() == {"FINISHED"}
    ob = bpy.context.active_object
    assert bpy.context.selected_objects == [ob] and ob.parent == path
    assert parameters_of(ob).trajectory_object == path and parameters_of(ob).contour == "CIRCLE"
    assert extent(ob)[2] == 2 and ob.matrix_world.translation.x == 3


@pytest.mark.parametrize("swap", [False, True])
def test_active_curve_is_the_contour_and_the_other_the_trajectory(scene, swap):
    contour, path = square(), curve("POLY", [(0, 0, 0), (7, 1, 0), (7, 9, 0)], use_cyclic_u=True)
    select(contour, path)
    bpy.ops.object.sweep_selected(swap=swap)
    group = parameters_of(bpy.context.active_object)
    roles = (group.contour_object, group.trajectory_object)
    assert roles == ((path, contour) if swap else (contour, path))


@pytest.mark.parametrize("text_is_active", [False, True])
def test_text_is_always_the_contour(scene, text_is_active):
    letters, path = text("I"), straight()
    select(*((letters, path) if text_is_active else (path, letters)))
    bpy.ops.object.sweep_selected(swap=text_is_active)
    group = parameters_of(bpy.context.active_object)
    assert (group.contour_object, group.trajectory_object) == (letters, path)


def test_refused_sweep_of_the_selected_leaves_nothing_behind(scene):
    speck = curve("POLY", [(0, 0, 0), (0, 0, 0)], name="Speck")
    select(speck)
    before = known()
    with pytest.raises(RuntimeError, match="trajectory: must be a curve with a length, got 'Speck'"):
        bpy.ops.object.sweep_selected()
    assert known() == before and speck.data.users == 1 and speck.users == 1
    assert bpy.context.active_object == speck and speck.select_get()


def test_a_refused_contour_that_blender_has_still_to_look_at_is_told_in_one_sentence(scene, capfd):
    """To read it Blender is brought up to date, which tells the handlers of the mesh that is being made."""
    path, letters = straight(), text("I")
    letters.data.body = ""
    letters.data.update_tag()
    select(path, letters)
    with pytest.raises(RuntimeError, match="contour: must be a curve or text with an outline, got 'text'"):
        bpy.ops.object.sweep_selected()
    assert "Traceback" not in capfd.readouterr().err


def test_text_has_no_length_to_move_along(scene):
    select(text("I"))
    with pytest.raises(RuntimeError, match="trajectory: must be a curve object, got 'text'"):
        bpy.ops.object.sweep_selected()


@pytest.mark.parametrize("shape", [shape for shape in SHAPES if objects.carrier(shape) == "contour"], ids=spelled)
@pytest.mark.parametrize("kind", ["curve", "text", "two"])
def test_active_curve_or_text_is_the_contour_of_a_shape_without_a_trajectory(scene, shape, kind):
    """The new object is its child, in its space: what scales it scales the sweep once."""
    contour = text("I") if kind == "text" else square()
    contour.location, contour.scale = (3, 0, 0), (2, 2, 2)
    select(contour, *([straight()] if kind == "two" else []))
    bpy.ops.object.sweep_selected(shape=spelled(shape, "_").upper())
    bpy.context.view_layer.update()
    ob = bpy.context.active_object
    assert ob.parent == contour and ob.data.sweep.kind == spelled(shape, "_").upper() and not ob.data.sweep.error
    assert ob.dimensions[1] == pytest.approx(contour.dimensions[1], rel=1e-5)


def refused(operator, sentence, **options):
    """Whether an operator cannot be called and says this about it."""
    assert not operator.poll()
    with pytest.raises(RuntimeError, match=sentence):
        operator(**options)


def test_sweep_selected_says_what_to_select(scene):
    sentence = "Select a curve to sweep along, or two"
    refused(bpy.ops.object.sweep_selected, sentence)
    select(text("I"), text("O"))
    refused(bpy.ops.object.sweep_selected, sentence)
    select(straight(), square(), text("I"))
    refused(bpy.ops.object.sweep_selected, sentence)
    select(straight(), square())
    bpy.context.view_layer.objects.active = None  # neither of them is the contour
    refused(bpy.ops.object.sweep_selected, sentence)


def test_operators_on_a_sweep_say_that_one_must_be_active(scene):
    bpy.ops.mesh.primitive_cube_add()
    for empty in (False, True):
        if empty:
            bpy.context.view_layer.objects.active = None
            select(None)
        refused(bpy.ops.object.sweep_apply, "Select a sweep")
        refused(bpy.ops.object.sweep_copy, "Make a sweep the active object", form="JOB")
        refused(bpy.ops.object.sweep_edit_as_curve, "Make a sweep the active object", parameter="contour")


def test_linked_sweep_can_be_copied_and_nothing_else(scene, tmp_path):
    bpy.data.libraries.write(str(tmp_path / "library.blend"), {sweep()})
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    bpy.ops.wm.link(directory=f"{tmp_path}/library.blend/Object/", filename="sweep")
    select(bpy.data.objects["sweep"])
    refused(bpy.ops.object.sweep_apply, "not linked from another file")
    refused(bpy.ops.object.sweep_edit_as_curve, "not linked from another file", parameter="contour")
    assert bpy.ops.object.sweep_copy(form="JOB") == {"FINISHED"}


def test_applied_sweeps_are_plain_meshes_and_others_are_not_touched(scene):
    path = straight()
    first, second, other = sweep(trajectory=path), sweep(), sweep()
    twin = bpy.data.objects.new("twin", second.data)
    scene.collection.objects.link(twin)
    bpy.ops.mesh.primitive_cube_add()
    select(bpy.context.active_object, first, second)
    before = places(first.data)

    assert bpy.ops.object.sweep_apply() == {"FINISHED"}

    assert [ob.data.sweep.kind == "NONE" for ob in (first, second, twin, other)] == [True, True, True, False]
    path.data.splines[0].points[1].co.z = 9
    bpy.context.view_layer.update()
    assert np.array_equal(places(first.data), before) and first.data.sweep.error == ""
    assert path.users == 1  # an applied mesh uses it no more: deleting it is for good


def test_a_sweep_whose_curve_is_gone_can_be_applied(scene):
    """Its last mesh stays, and is plain."""
    path = straight()
    ob = sweep(trajectory=path)
    bpy.data.objects.remove(path)
    bpy.context.view_layer.update()
    assert ob.data.sweep.error.startswith("trajectory: must be an object of the scene")
    select(ob)
    before = places(ob.data)
    assert bpy.ops.object.sweep_apply() == {"FINISHED"}
    assert ob.data.sweep.kind == "NONE" and ob.data.sweep.error == "" and np.array_equal(places(ob.data), before)


def test_what_carried_an_applied_sweep_may_be_deleted_and_nothing_jumps(scene):
    """It goes on with what carried the curve; a curve that moves by itself keeps it."""
    rig, path, moving = add("rig", None), straight(), straight()
    rig.location, path.location, path.parent = (5, 0, 0), (0, 2, 0), rig
    moving.keyframe_insert("location", frame=1)
    swept = []
    for carrier in (path, moving):
        select(carrier)
        bpy.ops.object.sweep_selected()
        swept.append(bpy.context.active_object)
    twin = bpy.data.objects.new("twin", swept[0].data)
    scene.collection.objects.link(twin)
    twin.parent = path
    select(*swept)
    assert bpy.ops.object.sweep_apply() == {"FINISHED"}
    assert [ob.parent for ob in (*swept, twin)] == [rig, moving, rig]

    bpy.data.objects.remove(path)
    rig.location.z = 1
    bpy.context.view_layer.update()
    for ob in (swept[0], twin):
        assert tuple(ob.matrix_world.translation) == pytest.approx((5, 2, 1))


def test_an_applied_sweep_stays_also_where_it_is_not_seen_or_moves_by_itself(scene):
    """Of what is hidden, and of other scenes, Blender has no matrices; what has keyframes goes where these say."""
    path = straight()
    path.location = (0, 2, 0)
    select(path)
    bpy.ops.object.sweep_selected()
    swept, other = bpy.context.active_object, bpy.data.scenes.new("other")
    hidden, elsewhere, keyed = (bpy.data.objects.new(name, swept.data) for name in ("hidden", "elsewhere", "keyed"))
    for ob, place in ((hidden, scene), (elsewhere, other), (keyed, scene)):
        place.collection.objects.link(ob)
        ob.parent, ob.location = path, (1, 0, 0)
    hidden.hide_viewport = True
    keyed.keyframe_insert("location", frame=1)
    assert bpy.ops.object.sweep_apply() == {"FINISHED"}

    hidden.hide_viewport = False
    scene.frame_set(2)
    other.view_layers[0].update()
    assert (hidden.parent, elsewhere.parent, keyed.parent) == (None, None, path)
    for ob in (hidden, elsewhere, keyed):
        assert tuple(ob.matrix_world.translation) == pytest.approx((1, 2, 0))


@pytest.mark.parametrize("seen", ["hidden", "excluded", "elsewhere", "with its path"])
def test_an_applied_twin_that_is_not_seen_stays_where_a_constraint_had_it(scene, seen):
    """The path has moved since Blender last knew the twin's place; all of them are turned and scaled by a parent."""
    path, follower, rig = straight(), add("follower", None), add("rig", None)
    path.data.use_path, follower.parent = True, path
    path.location, path.rotation_euler, path.scale = (1, 2, 3), (0.3, 0.2, 0.1), (2, 2, 2)
    rig.location, rig.rotation_euler = (0, 0, 7), (0, 1, 0)
    select(path)
    bpy.ops.object.sweep_selected()
    swept = bpy.context.active_object
    twin = add("twin", swept.data)
    placing.attach(twin, path)
    twin.parent, twin.location = rig, (5, 0, 0)
    bpy.context.view_layer.update()
    assert [each.type for each in twin.constraints] == ["CHILD_OF"]
    hide(twin, seen)
    path.hide_viewport = seen == "with its path"
    path.location.x, rig.location.x = 11, 4
    bpy.context.view_layer.update()

    select(swept)
    assert bpy.ops.object.sweep_apply() == {"FINISHED"} and not twin.constraints

    show(twin, seen)
    bpy.context.view_layer.update()
    path_there = Matrix.LocRotScale(path.location, path.rotation_euler, path.scale)
    rig_there = Matrix.LocRotScale(rig.location, rig.rotation_euler, None)
    expected = path_there @ rig_there @ Matrix.Translation((5, 0, 0))
    assert np.allclose(twin.matrix_world, expected, atol=1e-4)


def hide(ob, how):
    """Take an object from sight: by its switch, by that of its collection, or into another scene."""
    ob.hide_viewport = how in ("hidden", "with its path")
    if how == "excluded":
        aside = bpy.data.collections.new("aside")
        bpy.context.scene.collection.children.link(aside)
        bpy.context.view_layer.layer_collection.children["aside"].exclude = True
        aside.objects.link(ob)
    elif how == "elsewhere":
        bpy.data.scenes.new("other").collection.objects.link(ob)
    if how in ("excluded", "elsewhere"):
        bpy.context.scene.collection.objects.unlink(ob)


def show(ob, how):
    """Bring it back."""
    ob.hide_viewport = False
    if how in ("excluded", "elsewhere"):
        bpy.context.scene.collection.objects.link(ob)


def copied(ob, form):
    """The text that the operator puts on the clipboard, which there is none of in background."""
    reports, clipboard = [], SimpleNamespace()
    operator = SimpleNamespace(form=form, report=lambda kind, sentence: reports.append((*kind, sentence)))
    context = SimpleNamespace(active_object=ob, window_manager=clipboard)
    assert bpy.types.OBJECT_OT_sweep_copy.execute(operator, context) == {"FINISHED"}
    assert bpy.ops.object.sweep_copy(form=form) == {"FINISHED"}
    return clipboard.clipboard, reports


@pytest.mark.parametrize("inputs", [False, True])
def test_copied_job_is_the_equal_shape(scene, inputs):
    ob = sweep(trajectory=straight(), contour=square()) if inputs else sweep()
    select(ob)
    job, _ = copied(ob, "JOB")
    assert sw.load(job) == sw.from_object(ob)


@pytest.mark.parametrize("inputs", [False, True])
def test_copied_python_run_makes_the_equal_shape(scene, inputs):
    ob = sweep(trajectory=straight(), contour=square()) if inputs else sweep()
    select(ob)
    line, _ = copied(ob, "PYTHON")
    before = set(scene.collection.objects)
    exec(line, {})
    (made,) = set(scene.collection.objects) - before
    assert sw.from_object(made) == sw.from_object(ob) and np.array_equal(places(made.data), places(ob.data))


def test_copied_python_of_several_splines_makes_them_all_and_a_job_says_that_it_holds_one(scene):
    ob = sweep(trajectory=curve("POLY", [(0, 0, 0), (0, 0, 2)], [(5, 0, 0), (5, 0, 2)]))
    select(ob)
    lines, _ = copied(ob, "PYTHON")
    _, reports = copied(ob, "JOB")
    before = set(scene.collection.objects)
    exec(lines, {})
    assert len(set(scene.collection.objects) - before) == 2
    assert ("WARNING", "A job holds one shape: the first of 2 splines was copied") in reports


@pytest.mark.parametrize(
    ("operator", "undo"),
    [
        ("mesh.generalized_cylinder_add", True),
        ("mesh.sweep_preset_add", True),
        ("object.sweep_selected", True),
        ("object.sweep_convert", True),
        ("object.sweep_apply", True),
        ("object.sweep_edit_as_curve", True),
        ("object.sweep_copy", False),  # changes nothing
    ],
)
def test_operator_and_its_options_have_tooltips_and_what_changes_something_is_undone(scene, operator, undo):
    space, verb = operator.split(".")
    known = getattr(getattr(bpy.ops, space), verb).get_rna_type()
    assert known.description and known.name
    theirs = {"rna_type", "align", "location", "rotation"}  # Blender's own, without words
    assert all(option.description for option in known.properties if option.identifier not in theirs)
    assert ("UNDO" in getattr(bpy.types, f"{space.upper()}_OT_{verb}").bl_options) == undo


def test_both_copy_buttons_say_what_they_copy():
    python, job = (
        bpy.types.OBJECT_OT_sweep_copy.description(None, SimpleNamespace(form=form)) for form in ("PYTHON", "JOB")
    )
    assert python.startswith("Copy as Python. A line for ") and job.startswith("Copy as Job. A job file ")


@pytest.mark.parametrize("add", ["bezier_curve", "bezier_circle", "nurbs_curve", "nurbs_circle", "nurbs_path"])
@pytest.mark.parametrize("preset", [False, True])
def test_pipe_lies_on_the_curve_that_blender_adds(scene, add, preset):
    """In the world: Blender puts children of a curve with path animation at the path's start."""
    getattr(bpy.ops.curve, f"primitive_{add}_add")(location=(1, 2, 3), rotation=(0.3, 0.2, 0.1))
    path = bpy.context.active_object
    if preset:
        bpy.ops.mesh.sweep_preset_add(preset="PIPE")
    else:
        bpy.ops.object.sweep_selected()
    lies_on(bpy.context.active_object, path)


def test_pipe_lies_on_a_curve_that_something_follows(scene):
    """Its path animation stays on, and the follower where it was."""
    bpy.ops.curve.primitive_nurbs_path_add(location=(1, 2, 3))
    path = bpy.context.active_object
    follower = bpy.data.objects.new("follower", None)
    scene.collection.objects.link(follower)
    follower.parent = path
    bpy.context.view_layer.update()
    before = follower.matrix_world.copy()
    bpy.ops.object.sweep_selected()
    lies_on(bpy.context.active_object, path)
    assert path.data.use_path and follower.matrix_world == before


def lies_on(ob, path):
    """The middles of the boxes of tube and curve in the world: no side of the tube's is more than a radius farther."""
    bpy.context.view_layer.update()
    assert ob != path and ob.data.sweep.error == ""
    shown = path.to_mesh()
    middle = [path.matrix_world @ Vector(side) for side in extremes(shown)]
    path.to_mesh_clear()
    tube = [ob.matrix_world @ Vector(side) for side in extremes(ob.data)]
    apart = np.subtract(np.mean(tube, axis=0), np.mean(middle, axis=0))
    assert np.abs(apart).max() < 0.1


def extremes(mesh):
    """The least and the greatest coordinates of a mesh."""
    values = places(mesh)
    return values.min(axis=0), values.max(axis=0)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""L-systems in Blender: a text that people edit, sliders of its constants, and a mesh that follows both."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import cube, places, select

import sweep_addon as sw
from sweep_addon.bridge import objects, texts
from sweep_addon.properties import reading
from sweep_addon.properties.live import rebuild

TREE = """#define l 1      # 0.5 .. 2 m how long the stem is
#define a 30     # 0 .. 90 deg how far branches lean
#define half l/2
#generations 1
axiom: A
A -> F(l) [+(a) F(half)] F(l)
"""


def plant(text=TREE, **given):
    """A plant of edges in the scene, whose places tell what it was made from."""
    return sw.to_object(sw.Plant(text, output="edges", **given))


def parameters_of(ob):
    return ob.data.sweep.plant


def height(ob):
    return float(np.ptp(places(ob.data)[:, 0]))


def edit(ob, old, new):
    """Change the text as a person does, and wait until it is looked at."""
    held = parameters_of(ob).system_text
    held.from_string(held.as_string().replace(old, new))
    rebuild(ob.data)


def test_the_text_of_a_plant_is_a_text_of_the_file(scene):
    ob = plant()
    assert parameters_of(ob).system_text.as_string() == TREE
    assert sw.from_object(ob) == sw.Plant(TREE, output="edges")
    assert height(ob) == pytest.approx(2)


def test_constants_are_sliders_with_range_unit_and_words(scene):
    values = parameters_of(plant()).constants
    assert dict(values.items()) == {"l": 1.0, "a": 30.0}  # the other follows from them
    told = values.id_properties_ui("l").as_dict()
    assert (told["soft_min"], told["soft_max"], told["default"]) == (0.5, 2.0, 1.0)
    assert (told["description"], told["subtype"]) == ("how long the stem is", "DISTANCE")


def turned(ob, name, value):
    """Turn a constant as its slider does, which tells Blender that the mesh has changed."""
    parameters_of(ob).constants[name] = value
    ob.data.update_tag()
    bpy.context.view_layer.update()


def test_a_slider_makes_the_mesh_anew(scene):
    ob = plant()
    turned(ob, "l", 1.5)
    assert height(ob) == pytest.approx(3)
    assert sw.from_object(ob).constants == {"l": 1.5}


def test_a_constant_that_a_script_makes_no_number_is_refused_until_it_is_one(scene):
    ob = plant()
    turned(ob, "l", "long")
    assert ob.data.sweep.error.startswith("constants.l: must be a number") and "'long'" in ob.data.sweep.error
    assert height(ob) == pytest.approx(2)
    turned(ob, "l", 1.5)
    assert ob.data.sweep.error == "" and height(ob) == pytest.approx(3)


def test_a_constant_turns_what_the_text_says_by_it(scene):
    ob = plant("#define a 0  # 0 .. 180 deg\n#angle a\naxiom: F+F")
    assert height(ob) == pytest.approx(2)
    turned(ob, "a", 90.0)
    assert height(ob) == pytest.approx(1)  # a metre along x, and one along y
    parameters_of(ob).angle = 45.0
    assert height(ob) == pytest.approx(1)


def test_an_edited_text_makes_the_mesh_anew(scene):
    ob = plant()
    edit(ob, "F(l) [", "F(l) F(l) [")
    assert height(ob) == pytest.approx(3)


def written(ob, told=True):
    """Change the text as the documented lines of a script do, from a stem of 2 m to one of 4 m."""
    parameters_of(ob).system_text.from_string("axiom: F(4)")
    if told:
        ob.data.update_tag()


@pytest.mark.parametrize("follow", ["update", "frame"])
def test_a_text_that_a_script_changes_makes_the_mesh_anew_and_it_stays(scene, follow):
    ob = plant()
    bpy.context.view_layer.update()
    written(ob)
    if follow == "update":
        bpy.context.view_layer.update()
    else:
        scene.frame_set(5)
    assert height(ob) == pytest.approx(4)
    bpy.context.view_layer.update()
    scene.frame_set(6)
    assert height(ob) == pytest.approx(4)


def test_an_exporter_sees_the_mesh_of_a_text_that_a_script_has_changed(scene):
    ob = plant()
    bpy.context.view_layer.update()
    written(ob)
    assert height(ob.evaluated_get(bpy.context.evaluated_depsgraph_get())) == pytest.approx(4)


@pytest.mark.parametrize("told", [True, False])
def test_a_file_is_saved_with_the_mesh_of_its_text(scene, tmp_path, told):
    ob = plant()
    bpy.context.view_layer.update()
    written(ob, told)
    path = str(tmp_path / "plant.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path, copy=True)
    name = ob.name
    with bpy.data.libraries.load(path) as (held, brought):
        brought.objects = [name]
    assert height(brought.objects[0]) == pytest.approx(4)  # nothing reads the texts of what is appended


def test_a_file_that_was_saved_with_another_mesh_is_brought_up_to_date(scene, tmp_path, monkeypatch):
    ob = plant()
    bpy.context.view_layer.update()
    written(ob, told=False)
    name, path = ob.name, str(tmp_path / "plant.blend")
    with monkeypatch.context() as without:
        without.setattr("sweep_addon.properties.handlers.follow", lambda mesh: None)
        bpy.ops.wm.save_as_mainfile(filepath=path)
    assert height(ob) == pytest.approx(2)
    bpy.ops.wm.open_mainfile(filepath=path)
    assert height(bpy.data.objects[name]) == pytest.approx(4)


def test_a_text_with_mistakes_leaves_the_mesh_and_says_where(scene):
    ob = plant()
    edit(ob, "[+(a)", "[+(a")
    assert height(ob) == pytest.approx(2)
    assert "line 6" in ob.data.sweep.error
    edit(ob, "[+(a", "[+(a)")
    assert ob.data.sweep.error == ""


def test_a_constant_that_was_turned_keeps_its_value_in_another_text_and_the_others_follow_it(scene):
    ob = plant()
    turned(ob, "l", 1.5)
    edit(ob, "#define a 30", "#define a 45")
    edit(ob, "#define l 1 ", "#define l 1.2 ")
    assert dict(parameters_of(ob).constants.items()) == {"l": 1.5, "a": 45.0}
    edit(ob, "#define half l/2", "#define half 0.2")
    assert parameters_of(ob).constants["half"] == 0.2
    edit(ob, "#define half 0.2\n", "")
    assert "half" in ob.data.sweep.error  # it is needed
    edit(ob, "F(half)", "F")
    assert "half" not in parameters_of(ob).constants and ob.data.sweep.error == ""


@pytest.mark.parametrize("last", ["", "axiom: A(", "no grammar of this version"])
def test_a_file_whose_last_text_this_version_refuses_follows_the_new_one(scene, last):
    ob = plant()
    turned(ob, "l", 1.5)
    parameters_of(ob).system_understood = last
    edit(ob, "F(l) [", "F(l) F(l) [")
    assert ob.data.sweep.error == "" and height(ob) == pytest.approx(4.5)
    assert parameters_of(ob).system_understood == parameters_of(ob).system_text.as_string()


@pytest.mark.parametrize("other", ["half", [1.0, 2.0], {"l": 1.0}])
def test_a_constant_to_which_a_script_gave_no_number_has_that_of_the_text(scene, other):
    ob = plant()
    values = parameters_of(ob).constants
    del values["l"]
    values["l"] = other
    edit(ob, "F(l) [", "F(l) F(l) [")
    assert dict(parameters_of(ob).constants.items()) == {"l": 1.0, "a": 30.0} and height(ob) == pytest.approx(3)


def test_the_number_of_steps_follows_the_text_until_it_is_turned(scene):
    ob = plant()
    edit(ob, "#generations 1", "#generations 0")
    assert parameters_of(ob).generations == 0 and len(ob.data.vertices) == 0
    parameters_of(ob).generations = 1
    edit(ob, "#generations 0", "#generations 5")
    assert parameters_of(ob).generations == 1 and len(ob.data.vertices)


def test_reset_gives_all_numbers_the_values_of_the_text(scene):
    ob = plant(generations=0, constants={"l": 2})
    texts.reset(ob.data)
    assert sw.from_object(ob) == sw.Plant(TREE, output="edges")


def test_constants_follow_keyframes_and_drivers(scene):
    ob = plant()
    path = 'sweep.plant.constants["l"]'
    for frame, value in ((1, 1.0), (11, 2.0)):
        parameters_of(ob).constants["l"] = value
        ob.data.keyframe_insert(path, frame=frame)
    for frame, value in ((1, 2), (11, 4)):
        scene.frame_set(frame)
        assert height(ob) == pytest.approx(value)
    other = plant()
    other.data.driver_add(path).driver.expression = "frame"
    scene.frame_set(2)
    assert height(other) == pytest.approx(4)


def test_a_deleted_text_is_remembered(scene):
    ob = plant()
    bpy.data.texts.remove(parameters_of(ob).system_text)
    turned(ob, "l", 2)
    assert height(ob) == pytest.approx(4)
    select(ob)
    bpy.ops.object.sweep_grammar_text_new()
    assert parameters_of(ob).system_text.as_string() == TREE


def test_a_copy_shares_the_text_and_has_constants_of_its_own(scene):
    ob = plant()
    copy = ob.copy()
    copy.data = ob.data.copy()
    scene.collection.objects.link(copy)
    turned(copy, "l", 2)
    assert height(ob) == pytest.approx(2) and height(copy) == pytest.approx(4)
    edit(ob, "F(l) [", "[")
    rebuild(copy.data)
    assert height(ob) == pytest.approx(1) and height(copy) == pytest.approx(2)


def test_a_file_keeps_text_constants_and_mesh(scene, tmp_path):
    ob = plant(constants={"l": 1.5})
    shape, path = sw.from_object(ob), str(tmp_path / "plant.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.open_mainfile(filepath=path)
    ob = next(ob for ob in bpy.data.objects if ob.type == "MESH")
    assert sw.from_object(ob) == shape and height(ob) == pytest.approx(3)
    assert parameters_of(ob).system_text.as_string() == TREE
    turned(ob, "l", 2)
    assert height(ob) == pytest.approx(4)


def test_an_appended_plant_brings_its_text(scene, tmp_path):
    path = str(tmp_path / "library.blend")
    bpy.data.libraries.write(path, {plant()})
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    bpy.ops.wm.append(directory=f"{path}/Object/", filename="L-System")
    ob = bpy.data.objects["L-System"]
    edit(ob, "F(l) [", "[")
    assert height(ob) == pytest.approx(1)


def test_too_large_a_word_is_refused_with_its_size_and_the_mesh_stays(scene):
    ob = plant("axiom: F\nF -> FF", generations=3)
    parameters_of(ob).generations = 40
    assert "1,099,511,627,776" in ob.data.sweep.error and len(ob.data.edges) == 8


def test_a_plant_is_an_operand_of_a_tree_by_its_mesh(scene):
    """A box with a tube of twelve sides driven through it: the volumes of both, but for what they share."""
    tube = sw.to_object(sw.Plant("#width 1\naxiom: F(4)", output={"kind": "tubes", "sides": 12}))
    box = cube(2.0)
    bpy.context.view_layer.update()
    select(tube, box)
    bpy.ops.object.sweep_union()
    tree = sw.from_object(tube)
    section = 12 / 2 * np.sin(np.pi / 6) * 0.5**2
    assert tree.mesh().volume() == pytest.approx(8 + 3 * section, rel=1e-5)


def test_nobody_asks_where_an_l_system_meets_itself(scene):
    select(plant())
    assert not bpy.ops.object.sweep_find_self_intersections.poll()
    assert not bpy.ops.object.sweep_select_self_intersections.poll()


def test_the_operator_takes_text_and_constants_and_refuses_as_all_others_do(scene):
    bpy.ops.mesh.plant_add(system=TREE, constants='{"l": 1.5}', generations=1)
    ob = bpy.context.active_object
    assert sw.from_object(ob) == sw.Plant(TREE, constants={"l": 1.5}, angle=90, step=1, width=0.1)
    for wrong, said in (
        ({"system": "axiom: F["}, "system: line 1, column 9"),
        ({"constants": '{"m": 1}'}, "constants.m: is no constant of the text, which has"),
        ({"constants": "[["}, "constants: must be a table of numbers"),
    ):
        with pytest.raises(RuntimeError, match=said):
            bpy.ops.mesh.plant_add(**wrong)


def test_a_number_that_is_none_is_refused_and_the_mesh_stays(scene):
    ob = plant()
    turned(ob, "l", float("nan"))
    assert ob.data.sweep.error == "constants.l: must be a number, got nan" and height(ob) == pytest.approx(2)


def test_materials_have_a_slot_of_each_colour(scene):
    ob = plant("axiom: F'(4)F", generations=0)
    assert len(ob.data.materials) == 2  # edges have no faces
    parameters_of(ob).output = "TUBES"
    assert len(ob.data.materials) == 5


def test_polygons_and_organs_are_faces_and_points_with_attributes(scene):
    ob = plant("#angle 90\n#names leaf\naxiom: F'{f+f+f+f}~leaf(0.5)", generations=0)
    assert len(ob.data.polygons) == 1 and ob.data.polygons[0].material_index == 1
    organ = [value.value for value in ob.data.attributes["organ"].data]
    assert organ.count(1) == 1 and "1 = leaf (1 of it)" in ob.data.sweep.told
    assert ob.data.attributes["size"].data[organ.index(1)].value == 0.5
    turned = ob.data.attributes["rotation"].data[organ.index(1)].value
    quarter = (0.5**0.5, 0.5**0.5, 0, 0)  # about x: z to -y, where it heads; its negative is the same rotation
    assert abs(np.dot(turned, quarter)) == pytest.approx(1)
    assert not ob.data.validate()


def test_the_mesh_is_valid_with_its_texture_coordinates(scene):
    ob = sw.to_object(sw.Plant())
    assert not ob.data.validate()
    assert {"u", "v", "arc_length", "radius", "colour", "birth", "axis", "order"} <= set(ob.data.attributes.keys())
    shape = sw.from_object(ob)
    uv = np.empty(2 * len(ob.data.loops), np.float32)
    ob.data.uv_layers[0].uv.foreach_get("vector", uv)
    assert uv == pytest.approx(shape.mesh().uv.ravel(), abs=1e-5)
    parameters_of(ob).attributes = False
    parameters_of(ob).texture = "NONE"
    assert "radius" not in ob.data.attributes and "order" not in ob.data.attributes and not ob.data.uv_layers


def test_axes_become_splines_that_blender_draws_as_thick(scene):
    ob = sw.to_object(sw.Plant("axiom: !(0.2)F(1)[&(90)!(0.1)F(2)]F(1)", upright=True))
    ob.location.x = 3
    select(ob)
    bpy.ops.object.sweep_grammar_curves()
    curve = bpy.context.active_object
    bpy.context.view_layer.update()
    lengths = sorted(spline.calc_length() for spline in curve.data.splines)
    assert lengths == pytest.approx([2, 2]) and curve.matrix_world.translation.x == 3
    thick = {round(2 * point.radius, 6) for spline in curve.data.splines for point in spline.points}
    assert thick == {0.2, 0.1}
    assert curve.dimensions.z == pytest.approx(2, abs=0.2) and ob.data.sweep.kind == "PLANT"


def curves_of(ob):
    """The curves that an object shows: of each its places and its radii."""
    geometry = ob.evaluated_get(bpy.context.evaluated_depsgraph_get()).evaluated_geometry()  # which holds the curves
    shown = geometry.curves
    sizes = [0] if shown is None else np.diff([offset.value for offset in shown.curve_offset_data])
    points = [] if shown is None else [(tuple(point.position), point.radius) for point in shown.points]
    return [points[end - size : end] for size, end in zip(sizes, np.cumsum(sizes), strict=True) if size]


def test_poly_lines_are_live_curves_of_the_axes(scene):
    """Of two branches that begin at one point, which a mesh whose vertices they share would cut there."""
    ob = sw.to_object(sw.Plant("#define l 1\naxiom: !(0.2)F(1)[&(90)!(0.1)F(l)]F(1)", upright=True, output="curves"))
    assert sw.from_object(ob).output == sw.Plant(output="curves").output and len(ob.modifiers) == 1
    stem, branch = sorted(curves_of(ob), key=len, reverse=True)
    assert [place[2] for place, _ in stem] == pytest.approx([0, 1, 2])
    assert [r for _, r in stem] == pytest.approx([0.1] * 3)
    assert [place[2] for place, _ in branch] == pytest.approx([1, 1])
    assert [r for _, r in branch] == pytest.approx([0.05] * 2)
    parameters_of(ob).constants["l"] = 3
    rebuild(ob.data)
    long = min(curves_of(ob), key=len)
    assert np.linalg.norm(np.subtract(long[1][0], long[0][0])) == pytest.approx(3)


def test_a_button_makes_curves_and_leaves_faces_and_organs(scene):
    ob = sw.to_object(sw.Plant("#names leaf\naxiom: F(1)[+(90)F(1)~leaf(1)]{.+(90)f(1).+(90)f(1).}", upright=True))
    select(ob)
    assert not curves_of(ob)
    bpy.ops.object.sweep_grammar_live_curves()
    bpy.ops.object.sweep_grammar_live_curves()  # once is enough
    assert parameters_of(ob).output == "CURVES" and len(ob.modifiers) == 1 and len(curves_of(ob)) == 2
    geometry = ob.evaluated_get(bpy.context.evaluated_depsgraph_get()).evaluated_geometry()
    mesh = geometry.mesh
    assert len(mesh.polygons) == 1 and len(mesh.vertices) == 3 + 1


def test_a_text_is_read_when_it_has_stood_still_for_a_moment(scene):
    ob = plant()
    watch = reading.Watch()
    assert watch() == reading.PAUSE
    parameters_of(ob).system_text.from_string(TREE.replace("F(l) [", "["))
    assert watch() and height(ob) == pytest.approx(2)
    assert watch() and height(ob) == pytest.approx(1)
    bpy.data.objects.remove(ob)
    bpy.data.meshes.remove(bpy.data.meshes[0])
    assert watch() is None


def test_what_is_applied_forgets_text_and_constants(scene):
    ob = plant()
    select(ob)
    bpy.ops.object.sweep_apply()
    assert parameters_of(ob).system_text is None and not parameters_of(ob).constants.keys()
    assert len(bpy.data.texts) == 0 or bpy.data.texts[0].users == 0


def test_a_constant_is_animated_in_rendered_frames_too(scene):
    """A render has a depsgraph of its own and gives nothing back: what it reads are the constants of its own copy."""
    ob = plant()
    for frame, value in ((1, 1.0), (11, 2.0)):
        parameters_of(ob).constants["l"] = value
        ob.data.keyframe_insert('sweep.plant.constants["l"]', frame=frame)
    scene.frame_set(6)
    depsgraph = bpy.context.evaluated_depsgraph_get()
    read = objects.shapes(ob.data.evaluated_get(depsgraph), depsgraph)[0]
    assert read.constants["l"] == pytest.approx(1.5, abs=1e-5)


def test_a_constant_may_have_a_name_that_blender_uses_itself(scene):
    ob = plant("#define name 1  # 0 .. 3 m how long\naxiom: F(name)")
    path = f'sweep.plant.constants["{texts.key("name")}"]'
    for frame, value in ((1, 1.0), (3, 3.0)):
        turned(ob, texts.key("name"), value)
        ob.data.keyframe_insert(path, frame=frame)
    scene.frame_set(2)
    assert height(ob) == pytest.approx(2) and sw.from_object(ob).constants == {"name": 2}


def test_a_thousand_constants_and_names_that_are_too_long_keep_nobody_waiting(scene):
    lines = "\n".join(f"#define c{number} {number}" for number in range(1000))
    long = "l" * 80
    ob = plant(f"{lines}\n#define {long} 2\naxiom: F({long})F(c999)")
    assert height(ob) == pytest.approx(1001) and len(parameters_of(ob).constants.keys()) == texts.MOST
    assert sw.from_object(ob).constants == {}

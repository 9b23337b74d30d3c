# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the sidebar and the menu draw in each state, by a layout that writes down what it is asked for."""

import timeit
from pathlib import Path
from types import SimpleNamespace

import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from layouts import Layout, context_of
from scenes import add, cube, curve, parameters_of, select, square, straight, sweep, text

import sweep_addon as sw
from sweep_addon import presets
from sweep_addon.bridge import objects
from sweep_addon.core.declared.options import MEETING
from sweep_addon.core.declared.parameters import inside, parameters, spelled
from sweep_addon.core.declared.texts import ASIDE
from sweep_addon.core.shapes.kinds import SHAPES
from sweep_addon.properties.live import rebuild

MOST_CALLS = 150  # of the layout, in one draw: under 1 ms in a window


def drawn(ob=None, mode="OBJECT", width=300, folded=False, others=()):
    """All that the sidebar draws with this object active, and the words of it."""
    layout = Layout(folded=folded)
    bpy.types.VIEW3D_PT_sweep.draw(SimpleNamespace(layout=layout), context_of(ob, mode, width, others))
    return layout.drawn


def said(calls):
    """The words among them, with the line breaks of a narrow sidebar taken out."""
    return " ".join(calls)


def test_without_a_sweep_it_says_what_to_do_and_offers_it(scene):
    plain = bpy.data.objects.new("plain", bpy.data.meshes.new("plain"))
    for ob in (None, plain, straight(), text("I")):
        calls = drawn(ob)
        assert {"VIEW3D_MT_sweep_add", "object.sweep_selected"} <= set(calls)
        assert "object.sweep_apply" not in calls
        assert "curve" in said(calls)
    assert "Object Mode" in said(drawn(plain, mode="EDIT_MESH"))


def test_every_shape_is_offered_with_a_picture_of_it(scene):
    calls = drawn()
    offered = [f"mesh.{spelled(shape, '_')}_add" for shape in SHAPES]
    assert [call for call in calls if call in ("picture", *offered)] == sum((["picture", name] for name in offered), [])
    assert not {*offered} & {*drawn(mode="EDIT_MESH")}
    pictures = Path(__file__).resolve().parents[2] / "panels" / "pictures"
    assert {path.stem for path in pictures.glob("*.png")} == {spelled(shape, "_") for shape in SHAPES}


def test_a_curve_with_a_bevel_can_be_converted(scene):
    path = straight()
    assert "object.sweep_convert" not in drawn(path)
    path.data.bevel_depth = 0.1
    assert "object.sweep_convert" in drawn(path)


def test_menu_stands_in_object_convert(scene):
    layout = Layout()
    for draw in bpy.types.VIEW3D_MT_object_convert.draw._draw_funcs:
        if draw.__module__.startswith("bl_ext.user_default.sweep_addon"):
            draw(SimpleNamespace(layout=layout), bpy.context)
    assert "object.sweep_convert" in layout.drawn


def test_a_sweep_shows_every_parameter_once_and_what_can_be_done(scene):
    calls = drawn(sweep())
    for p in parameters(sw.GeneralizedCylinder):
        assert calls.count(p.name) == (0 if p.item else 1)
    assert {"object.sweep_apply", "object.sweep_copy", "object.sweep_edit_as_curve"} <= set(calls)
    assert "object.sweep_item_add" in calls
    assert "contour_circle_radius" in calls and "contour_rectangle_width" not in calls


def test_a_body_that_is_an_object_can_be_gone_to(scene):
    solid, given = (add("offset", objects.new_mesh(sw.OffsetSurface(), **body)) for body in ({}, {"body": cube()}))
    assert "object.sweep_edit_as_curve" not in drawn(solid) and "object.sweep_edit_as_curve" in drawn(given)


def test_an_extrusion_can_be_taken_apart_into_primitives(scene):
    plate = sw.to_object(sw.TranslationalSweep())
    assert "object.sweep_convert_to_csg" in drawn(plate) and "object.sweep_classify" in drawn(plate)
    assert "object.sweep_convert_to_csg" not in drawn(sweep()) and "object.sweep_classify" in drawn(sweep())


def test_folded_groups_draw_nothing_of_theirs(scene):
    calls = drawn(sweep(), folded=True)
    for p in parameters(sw.GeneralizedCylinder):
        folded = p.group and p.group != MEETING  # whose option stands beside what was found
        assert calls.count(p.name) == (0 if folded else 1)


def test_size_is_said_where_the_eye_is(scene):
    ob = sweep()
    assert f"2 contours, {len(ob.data.polygons):,} faces" in said(drawn(ob))


@pytest.mark.parametrize("width", [120, 200, 300, 900])
def test_an_error_is_said_whole_however_narrow_the_sidebar(scene, width):
    ob = sweep()
    parameters_of(ob).contour_circle_radius = 0
    words = said(drawn(ob, width=width)).replace(" ", "")  # a word that is too long is broken
    assert ob.data.sweep.error.replace(" ", "") in words
    assert "contour_circle_radius" in drawn(ob, width=width)


def test_alt_is_named_where_it_changes_another_sweep_too(scene):
    ob, plain = sweep(), bpy.data.objects.new("plain", bpy.data.meshes.new("plain"))
    twin = bpy.data.objects.new("twin", ob.data)  # shares the parameters anyway
    for others, named in (((), False), ((plain, straight(), twin), False), ((plain, sweep()), True)):
        assert ("Alt" in said(drawn(ob, others=others))) == named


def test_warnings_of_the_shape_are_said(scene):
    ob = sweep(frame="frenet")
    assert ob.data.sweep.told and ob.data.sweep.told in said(drawn(ob))


def test_a_mesh_edited_by_hand_says_what_will_happen_to_it(scene):
    ob = sweep()
    ob.data.sweep.edited = True
    assert "the next change replaces it" in said(drawn(ob)) and "Apply" in said(drawn(ob))
    select(ob)
    bpy.ops.object.mode_set(mode="EDIT")
    assert "Edit Mode" in said(drawn(ob, mode="EDIT_MESH"))
    bpy.ops.object.mode_set(mode="OBJECT")


def test_a_linked_sweep_says_so_and_offers_nothing_to_change(scene, tmp_path):
    bpy.data.libraries.write(str(tmp_path / "library.blend"), {sweep()})
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    bpy.ops.wm.link(directory=f"{tmp_path}/library.blend/Object/", filename="sweep")
    calls = drawn(bpy.data.objects["sweep"])
    assert "linked from another file" in said(calls) and "contour" not in calls


UNIONS = [p for p in parameters(sw.GeneralizedCylinder) if p.kinds]


@pytest.mark.parametrize(
    ("p", "kind"), [pytest.param(p, kind, id=f"{p.name}-{spelled(kind)}") for p in UNIONS for kind in p.kinds]
)
def test_a_chosen_kind_shows_its_own_parameters_and_no_other_kinds(scene, p, kind):
    ob = sweep()
    setattr(parameters_of(ob), p.name, spelled(kind, "_").upper())
    calls = drawn(ob)
    prefix = f"{p.name}_{spelled(kind, '_')}_"
    own = {prefix + q.name for q in inside(p, kind) if not q.is_list}
    assert own <= set(calls)
    others = {name for name in calls if name.startswith(f"{p.name}_") and not name.startswith(prefix)}
    assert not others


def test_what_is_in_a_list_shows_its_parameters_and_a_button_that_takes_it_out(scene):
    calls = drawn(sweep(morph=[(0.5, "circle"), (1, "star")]))
    assert calls.count("t") == calls.count("object.sweep_item_remove") == 2
    assert calls.count("contour") == 3 and calls.count("contour_star_inner") == 1


@pytest.mark.parametrize("parameter", ["contour", "trajectory"])
def test_an_object_shows_which(scene, parameter):
    ob = sweep(**{parameter: {"contour": square, "trajectory": straight}[parameter]()})
    assert f"{parameter}_object" in drawn(ob)
    setattr(parameters_of(ob), f"{parameter}_object", None)
    assert f"{parameter}_object" in drawn(ob)


def test_corners_are_asked_of_a_curve_that_has_some(scene):
    ob = sweep(trajectory=straight())
    assert "trajectory_polyline_corner_mitre_limit" in drawn(ob)
    parameters_of(ob).trajectory_polyline_corner = "ROUND"
    assert "trajectory_polyline_corner_round_radius" in drawn(ob)
    assert not [name for name in drawn(ob) if name.startswith(("trajectory_polyline_points", "trajectory_bezier"))]
    smooth = sweep(trajectory=curve("NURBS", [(0, 0, 0), (0, 0, 1), (0, 1, 2), (0, 1, 3)]))
    assert not [name for name in drawn(smooth) if "corner" in name]


@pytest.mark.parametrize("text", ["", "7", "null", "{}", "[[", '"a"', "[" * 5000])
@pytest.mark.parametrize("name", ["contour_outline_loops", "scale_x_points_points"])
def test_a_list_that_somebody_spoilt_is_drawn_with_its_refusal(scene, text, name):
    ob = sweep()
    setattr(parameters_of(ob), name, text)
    parameters_of(ob).contour, parameters_of(ob).scale_x = "OUTLINE", "POINTS"
    assert ob.data.sweep.error and "must" in said(drawn(ob))


def test_menu_offers_every_shape_and_every_preset(scene):
    layout = Layout()
    bpy.types.VIEW3D_MT_sweep_add.draw(SimpleNamespace(layout=layout), bpy.context)
    assert layout.drawn.count("mesh.generalized_cylinder_add") == 1
    single = [preset for preset in presets.PRESETS if not preset.group]
    assert layout.drawn.count("mesh.sweep_preset_add") == len(single) >= 3


def test_sizes_of_a_preset_have_a_menu_of_their_own(scene):
    layout = Layout()
    bpy.types.VIEW3D_MT_sweep_add.draw(SimpleNamespace(layout=layout), bpy.context)
    assert layout.drawn.count("VIEW3D_MT_sweep_screw_thread") == 1
    sizes = Layout()
    bpy.types.VIEW3D_MT_sweep_screw_thread.draw(SimpleNamespace(layout=sizes), bpy.context)
    assert sizes.drawn.count("mesh.sweep_preset_add") == 10


def test_menu_stands_in_add_mesh(scene):
    layout = Layout()
    for draw in bpy.types.VIEW3D_MT_mesh_add.draw._draw_funcs:
        if draw.__module__.startswith("bl_ext.user_default.sweep_addon"):
            draw(SimpleNamespace(layout=layout), bpy.context)
    assert "VIEW3D_MT_sweep_add" in layout.drawn


def test_last_operation_shows_every_parameter(scene):
    known = bpy.ops.mesh.generalized_cylinder_add.get_rna_type()
    values = {key: getattr(known.properties[key], "default", None) for key in known.properties.keys()}
    layout, operator = Layout(), bpy.types.MESH_OT_generalized_cylinder_add
    asked = SimpleNamespace(**{**values, "layout": layout, "shape": operator.shape, "bl_rna": known})
    operator.draw(asked, bpy.context)
    lists = {p.group for p in parameters(sw.GeneralizedCylinder) if p.item}
    for p in parameters(sw.GeneralizedCylinder):
        assert layout.drawn.count(p.name) == (0 if p.group in lists else 1)
    assert {"location", "rotation", "contour_circle_radius"} <= set(layout.drawn)


def test_a_draw_is_few_calls_and_changes_nothing(scene):
    ob = sweep()
    before = ob.data.sweep.made
    calls = drawn(ob)
    seconds = min(timeit.repeat(lambda: drawn(ob), number=20, repeat=3)) / 20
    print(f"\ndraw of a sweep: {len(calls)} calls of the layout, {seconds * 1000:.2f} ms in Python")
    assert len(calls) < MOST_CALLS and ob.data.sweep.made == before


def test_every_grammar_has_a_line_in_one_of_the_menus_of_l_systems(scene):
    menus = [Layout() for _ in range(3)]
    for menu, layout in zip(("add", "plants", "curves"), menus, strict=True):
        getattr(bpy.types, f"VIEW3D_MT_sweep_l_system_{menu}").draw(SimpleNamespace(layout=layout), bpy.context)
    assert menus[0].drawn.count("mesh.plant_add") == 1
    plants, curves = (layout.drawn.count("mesh.sweep_preset_add") for layout in menus[1:])
    assert plants + curves == len([preset for preset in presets.PRESETS if preset.group == "l_system"])
    assert plants > 20 and curves > 20


def test_an_l_system_shows_its_text_its_size_and_its_constants(scene):
    ob = sw.to_object(sw.Plant())
    calls = drawn(ob)
    assert {"system_text", "object.sweep_grammar_edit", "object.sweep_grammar_reset"} <= set(calls)
    assert "7,162 modules; next step 14,330" in said(calls)
    assert [call for call in calls if call.startswith("[")] == [f'["{name}"]' for name in "r1 r2 a0 a2 d wr".split()]
    assert not {"object.sweep_classify", "object.sweep_find_self_intersections"} & set(calls)
    for p in parameters(sw.Plant):
        assert calls.count(p.name) == (0 if p.type in ASIDE else 1)


def test_what_is_wrong_in_a_grammar_is_shown_by_its_lines(scene):
    ob = sw.to_object(sw.Plant())
    ob.data.sweep.plant.system_text.from_string("axiom: F[\nF -> x(")
    rebuild(ob.data)
    calls = drawn(ob, width=900)
    assert "Line 1: axiom: F[" in calls and "Column 7: expected ')' after it" in said(calls)
    assert calls.count("object.sweep_grammar_edit") == 3 and "7,162" not in said(calls)

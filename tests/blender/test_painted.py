# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Weights, colours, UV maps and other attributes that people put on a sweep stay when it has other faces."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import curve, parameters_of, places, sweep

from sweep_addon.bridge import carried
from sweep_addon.core.contours import Circle, Outline, Rectangle
from sweep_addon.core.rings.ends import Round, Taper
from sweep_addon.core.stations.sampling import Count
from sweep_addon.core.trajectories import Line, Polyline


@pytest.fixture
def ob(scene):
    """A straight tube of eleven rings of eight points, one metre high."""
    return sweep(contour=Circle(0.5, points=8), trajectory=Line(end=(0, 0, 1)), samples=Count(11))


def weigh(ob, weights):
    """Give each vertex its weight in a new group."""
    group = ob.vertex_groups.new(name="Pin")
    for index, weight in enumerate(weights):
        group.add([index], float(weight), "REPLACE")


def weights(ob):
    return np.array([sum(group.weight for group in vertex.groups) for vertex in ob.data.vertices])


def paint(mesh, name, kind, domain, values):
    made = mesh.attributes.new(name, kind, domain)
    made.data.foreach_set({"FLOAT": "value", "INT": "value"}.get(kind, "color"), np.ravel(values))


def painted(mesh, name, width=1):
    found = mesh.attributes[name]
    values = np.empty(width * len(found.data), np.float32 if width > 1 or found.data_type == "FLOAT" else np.int32)
    found.data.foreach_get("color" if width > 1 else "value", values)
    return values.reshape(-1, width) if width > 1 else values


def named(mesh):
    """The names of attributes, but for what Blender says of the selection."""
    return {a.name for a in mesh.attributes if not a.name.startswith((".select", ".hide"))}


def corners(mesh):
    """The places of the corners of faces, (c, 3), and the numbers of corners of each face."""
    return places(mesh)[[loop.vertex_index for loop in mesh.loops]], [p.loop_total for p in mesh.polygons]


def test_weights_between_rings_are_between_theirs(ob):
    weigh(ob, places(ob.data)[:, 2])
    parameters_of(ob).samples_count_contours = 41
    assert len(ob.data.vertices) == 41 * 8 and ob.data.sweep.error == ""
    assert np.abs(weights(ob) - places(ob.data)[:, 2]).max() <= 1e-6


def test_weights_round_the_contour_are_on_the_chords_of_those_before(ob):
    angle = np.arctan2(*places(ob.data)[:, 1::-1].T)
    weigh(ob, 0.5 + 0.5 * np.sin(angle))
    parameters_of(ob).contour_circle_points = 96
    angle = np.arctan2(*places(ob.data)[:, 1::-1].T)
    assert np.abs(weights(ob) - 0.5 - 0.5 * np.sin(angle)).max() <= 0.5 * (np.pi / 4) ** 2 / 8 + 1e-6


def test_rings_that_stay_keep_their_weights_to_the_bit(ob):
    weigh(ob, np.random.default_rng(1).random(88))
    before = weights(ob).reshape(8, 11)
    parameters_of(ob).samples_count_contours = 21
    assert np.array_equal(weights(ob).reshape(8, 21)[:, ::2], before)


def test_weights_do_not_drift_under_a_slider(ob):
    weigh(ob, places(ob.data)[:, 2])
    group = parameters_of(ob)
    for count in range(12, 40):
        group.samples_count_contours = count
        group.contour_circle_points = 8 + count % 5
    assert np.abs(weights(ob) - places(ob.data)[:, 2]).max() <= 1e-5


def test_the_tip_stays_the_tip_while_the_sweep_grows(ob):
    weigh(ob, places(ob.data)[:, 2] > 0.95)
    group = parameters_of(ob)
    ob.data.sweep.paused = True
    group.trajectory_line_end, group.samples_count_contours = (0, 0, 5), 51
    ob.data.sweep.paused = False
    expected = np.clip(2 * places(ob.data)[:, 2] - 9, 0, 1)  # from the ring before, at 0.9 of the length, to the tip
    assert np.abs(weights(ob) - expected).max() < 1e-5


@pytest.mark.parametrize("kind", ["FLOAT_COLOR", "BYTE_COLOR"])
@pytest.mark.parametrize("domain", ["POINT", "CORNER"])
def test_colours_follow_and_stay_the_ones_that_are_shown(ob, kind, domain):
    mesh = ob.data
    spots = places(mesh) if domain == "POINT" else corners(mesh)[0]
    paint(mesh, "Other", kind, domain, np.ones((len(spots), 4)))
    paint(mesh, "Paint", kind, domain, np.column_stack((spots[:, 2], np.zeros((len(spots), 2)), np.ones(len(spots)))))
    mesh.attributes.active_color_name = mesh.attributes.default_color_name = "Paint"
    parameters_of(ob).samples_count_contours = 31
    spots = places(mesh) if domain == "POINT" else corners(mesh)[0]
    found = painted(mesh, "Paint", 4)
    near = 1e-6 if kind == "FLOAT_COLOR" else 0.03  # bytes are mixed as they are shown, not as light
    assert np.abs(found[:, 0] - spots[:, 2]).max() < near and (found[:, 1] == 0).all()
    assert mesh.attributes.active_color_name == mesh.attributes.default_color_name == "Paint"
    assert mesh.attributes["Paint"].data_type == kind and mesh.attributes["Paint"].domain == domain


@pytest.mark.parametrize(("count", "points"), [(31, 8), (11, 40), (4, 5), (31, 40)])
def test_a_second_uv_map_stays_on_its_faces_and_in_use(ob, count, points):
    """It is the first one, stretched, so it is to be that of the new faces too: seams, ends and all."""
    mesh = ob.data
    second = mesh.uv_layers.new(name="Second")
    values = np.empty(2 * len(mesh.loops), np.float32)
    mesh.uv_layers["UVMap"].uv.foreach_get("vector", values)
    second.uv.foreach_set("vector", 2 * values + 1)
    mesh.uv_layers.active = second
    second.active_render = True
    group = parameters_of(ob)
    group.samples_count_contours, group.contour_circle_points = count, points
    first, second = (np.empty(2 * len(mesh.loops), np.float32) for _ in range(2))
    mesh.uv_layers["UVMap"].uv.foreach_get("vector", first)
    mesh.uv_layers["Second"].uv.foreach_get("vector", second)
    sides = np.repeat([p.loop_total == 4 for p in mesh.polygons], [p.loop_total for p in mesh.polygons])
    apart = np.abs(second - 2 * first - 1).reshape(-1, 2)[sides]
    longer = abs(points * np.sin(np.pi / points) - 8 * np.sin(np.pi / 8))  # one polygon's way round than the other's
    assert apart[:, 0].max() < 1e-5 and apart[:, 1].max() < 2 * longer + 1e-5
    assert [layer.name for layer in mesh.uv_layers] == ["UVMap", "Second"]
    assert mesh.uv_layers.active.name == "Second" and mesh.uv_layers["Second"].active_render


def test_an_end_painted_apart_from_the_side_stays_apart(ob):
    mesh = ob.data
    ends = np.repeat([p.loop_total == 8 for p in mesh.polygons], [p.loop_total for p in mesh.polygons])
    paint(mesh, "Paint", "FLOAT_COLOR", "CORNER", np.outer(ends, np.ones(4)))
    paint(mesh, "Group", "INT", "FACE", [7 if p.loop_total == 8 else 1 for p in mesh.polygons])
    group = parameters_of(ob)
    group.samples_count_contours, group.contour_circle_points = 45, 20
    _, sizes = corners(mesh)
    assert sorted(sizes) == [4] * 880 + [20] * 2
    assert (painted(mesh, "Paint", 4)[:, 0] == (np.repeat(sizes, sizes) == 20)).all()
    assert (painted(mesh, "Group") == np.where(np.array(sizes) == 20, 7, 1)).all()


def test_tips_that_come_and_go_have_what_lay_there(ob):
    paint(ob.data, "height", "FLOAT", "POINT", places(ob.data)[:, 2])
    group = parameters_of(ob)
    for end in ("TAPER", "FLAT"):
        group.end = end
        assert np.abs(painted(ob.data, "height") - places(ob.data)[:, 2]).max() < 1e-5
    assert not ob.data.validate()


def test_the_attributes_of_the_sweep_itself_are_its_own(ob):
    weigh(ob, np.ones(88))
    parameters_of(ob).samples_count_contours = 21
    mesh, made = ob.data, sweep(contour=Circle(0.5, points=8), trajectory=Line(end=(0, 0, 1)), samples=Count(21)).data
    assert named(mesh) == named(made)
    for name in ("u", "v", "arc_length"):
        assert np.array_equal(painted(mesh, name), painted(made, name))
    assert np.array_equal(places(mesh), places(made)) and not mesh.validate()


def test_keyframes_and_materials_stay_with_the_weights(ob):
    mesh = ob.data
    weigh(ob, np.ones(88))
    mesh.materials[0] = bpy.data.materials.new("steel")
    group = parameters_of(ob)
    group.keyframe_insert("contour_circle_radius", frame=1)
    group.samples_count_contours = 21
    assert mesh.animation_data.action is not None and mesh.materials[0].name == "steel"
    assert (weights(ob) == 1).all()


def test_loops_of_a_contour_are_not_mixed_up(scene):
    square = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    made = sweep(contour=Outline([square, square[::-1] / 2]), trajectory=Line(end=(0, 0, 1)), samples=Count(3))
    paint(made.data, "inside", "FLOAT", "POINT", np.abs(places(made.data)[:, :2]).max(axis=1) < 0.6)
    parameters_of(made).samples_count_contours = 9
    assert (painted(made.data, "inside") == (np.abs(places(made.data)[:, :2]).max(axis=1) < 0.6)).all()


def test_a_closed_path_of_uneven_steps_keeps_things_where_they_are(scene):
    """A mitre moves what lies beside the path by half the contour's width along it."""
    frame = Polyline([(0, 0, 0), (2, 0, 0), (2, 1, 0), (0, 1, 0)], closed=True)
    made = sweep(contour=Rectangle(0.02, 0.02), trajectory=frame)
    for axis in range(3):
        paint(made.data, "xyz"[axis], "FLOAT", "POINT", places(made.data)[:, axis])
    group = parameters_of(made)
    group.samples, group.samples_count_contours = "COUNT", 60
    assert len(made.data.vertices) == 60 * 4
    found = np.stack([painted(made.data, axis) for axis in "xyz"], axis=1)
    assert np.abs(found - places(made.data)).max() <= 0.01 + 1e-6


def test_ends_are_known_by_their_shape_whatever_material_they_have(ob):
    mesh = ob.data
    mesh.polygons.foreach_set("material_index", np.arange(len(mesh.polygons)) % 2)
    paint(mesh, "Group", "INT", "FACE", [7 if p.loop_total == 8 else 1 for p in mesh.polygons])
    group = parameters_of(ob)
    group.samples_count_contours, group.contour_circle_points = 45, 20
    assert (painted(mesh, "Group") == [7 if p.loop_total == 20 else 1 for p in mesh.polygons]).all()


@pytest.mark.parametrize("end", [Round(), Taper(0.3)])
def test_what_corners_and_faces_have_goes_where_there_are_tips(scene, end):
    made = sweep(contour=Circle(0.2, points=8), trajectory=Line(end=(0, 0, 1)), samples=Count(11), end=end)
    for domain, items in (("POINT", "vertices"), ("CORNER", "loops"), ("FACE", "polygons")):
        paint(made.data, domain, "INT", domain, np.ones(len(getattr(made.data, items)), np.int32))
    weigh(made, np.ones(len(made.data.vertices)))
    parameters_of(made).samples_count_contours = 21
    assert {"POINT", "CORNER", "FACE"} & named(made.data) == {"POINT"} and made.data.sweep.error == ""
    assert (painted(made.data, "POINT") == 1).all() and (weights(made) == 1).all()


def test_the_faces_of_an_end_keep_their_own_while_the_contour_stays(scene):
    """A square with a hole has ends of several faces, which share their corners."""
    square = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    ob = sweep(contour=Outline([square, square[::-1] / 2]), trajectory=Line(end=(0, 0, 1)), samples=Count(3))
    count, sides = len(ob.data.polygons), 2 * 8
    paint(ob.data, "Number", "INT", "FACE", np.arange(count, dtype=np.int32))
    parameters_of(ob).samples_count_contours = 9
    assert count > sides + 2
    assert painted(ob.data, "Number")[8 * 8 :].tolist() == list(range(sides, count))


@pytest.mark.parametrize("kind", ["INT16_2D", "INT32_2D"])
def test_pairs_of_whole_numbers_are_those_of_the_nearest(ob, kind):
    made = ob.data.attributes.new("Pair", kind, "POINT")
    height = np.rint(10 * places(ob.data)[:, 2]).astype(np.int32)
    made.data.foreach_set("value", np.column_stack((height, -height)).ravel())
    parameters_of(ob).samples_count_contours = 31
    found = np.array([tuple(each.value) for each in ob.data.attributes["Pair"].data])
    assert np.array_equal(found[:, 0], np.rint(10 * places(ob.data)[:, 2])) and np.array_equal(
        found[:, 1], -found[:, 0]
    )


def test_what_lies_on_no_grid_goes_as_before(scene):
    """Two splines make two tubes in one mesh, of which no attribute says which is which."""
    path = curve("POLY", [(0, 0, 0), (0, 0, 1)], [(3, 0, 0), (3, 0, 1)])
    ob = sweep(contour=Rectangle(), trajectory=path, samples=Count(3), end=Taper(0.2))
    paint(ob.data, "mine", "FLOAT", "POINT", np.ones(len(ob.data.vertices)))
    parameters_of(ob).samples_count_contours = 5
    assert "mine" not in ob.data.attributes and ob.data.sweep.error == ""


def test_where_nothing_is_put_on_a_mesh_nothing_is_looked_for(ob, monkeypatch):
    monkeypatch.setattr(carried, "sources", None)
    parameters_of(ob).samples_count_contours = 21
    assert ob.data.sweep.error == "" and len(ob.data.vertices) == 21 * 8

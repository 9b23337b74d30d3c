# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Self-intersection in Blender: told with every change, looked for a moment later or on request, its faces selected."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import curve, parameters_of, places, select, sweep
from test_panels import drawn, said

from sweep_addon.core.contours import Circle
from sweep_addon.core.stations.sampling import Count
from sweep_addon.core.trajectories import Arc, Polyline
from sweep_addon.properties import finding

FOLD = "the contour reaches the centre of curvature"
HOOK = Polyline([(0, 0, 0), (10, 0, 0), (10, 5, 0), (5, 5, 0), (5, 1, 0)])  # ends a metre from its first leg


def crossing():
    """A pipe whose end goes into its first leg."""
    return sweep(contour=Circle(1.2, points=16), trajectory=HOOK)


def selected(mesh, kind="polygons"):
    parts = getattr(mesh, kind)
    values = np.empty(len(parts), bool)
    parts.foreach_get("select", values)
    return np.flatnonzero(values)


def test_a_fold_is_told_with_the_change_that_makes_it(scene):
    ob = sweep(contour=Circle(0.2), trajectory=Arc(radius=0.3))
    assert ob.data.sweep.told == ""
    parameters_of(ob).contour_circle_radius = 0.5
    assert FOLD in ob.data.sweep.told and FOLD in said(drawn(ob, width=2000))
    assert "object.sweep_select_self_intersections" in drawn(ob)
    parameters_of(ob).contour_circle_radius = 0.2
    assert ob.data.sweep.told == "" and "object.sweep_select_self_intersections" not in drawn(ob)


def test_a_moment_later_all_places_are_found_and_then_there_is_no_timer(scene):
    ob = crossing()
    sweep_of = ob.data.sweep
    assert finding.is_due(ob.data) and not sweep_of.places
    assert finding.look() is None
    assert sweep_of.looked_at == sweep_of.made and "meets" in sweep_of.places
    assert "meets" in said(drawn(ob, width=2000)) and not finding.is_due(ob.data)


def test_the_largest_safe_size_is_searched_for_on_request(scene):
    """The search takes a tenth of a second or several, in which a window would stand still."""
    ob = crossing()
    select(ob)
    finding.look()
    assert "A radius" not in ob.data.sweep.places and "object.sweep_find_self_intersections" in drawn(ob)
    bpy.ops.object.sweep_find_self_intersections()
    assert "A radius up to 0.9999 m" in ob.data.sweep.places and "meets" in ob.data.sweep.places
    assert "A radius up to 0.9999 m" in said(drawn(ob, width=2000))
    assert "object.sweep_find_self_intersections" not in drawn(ob)


def test_of_a_round_tube_the_largest_safe_size_takes_no_search_and_is_told_at_once(scene):
    """Of a tube that bends round a circle it is the radius of that."""
    ob = sweep(contour=Circle(0.4), trajectory=Arc(radius=0.3))
    finding.look()
    assert "A radius up to 0.3 m" in ob.data.sweep.places
    assert "object.sweep_find_self_intersections" not in drawn(ob)


def test_of_several_sweeps_one_is_looked_at_at_a_time(scene):
    first, second = crossing(), sweep()
    assert finding.look() == finding.NEXT and finding.look() is None
    assert first.data.sweep.places and not second.data.sweep.places
    assert not any(map(finding.is_due, (first.data, second.data)))


def test_what_was_found_is_not_shown_of_another_shape(scene):
    ob = crossing()
    finding.look()
    parameters_of(ob).contour_circle_radius = 0.5
    assert finding.is_due(ob.data) and "meets" not in said(drawn(ob, width=2000))
    finding.look()
    assert ob.data.sweep.places == ""


def test_in_background_no_timer_waits(scene):
    """Blender hangs at its end while one does."""
    crossing()
    bpy.context.view_layer.update()
    assert bpy.app.background and not bpy.app.timers.is_registered(finding.look)


def test_with_a_window_a_change_starts_the_moment_anew_and_disabling_ends_it(scene, monkeypatch):
    started, running = [], []

    class Timers:
        @staticmethod
        def register(function, first_interval):
            started.append(first_interval)
            running.append(function)

        @staticmethod
        def unregister(function):
            running.remove(function)

        @staticmethod
        def is_registered(function):
            return function in running

    app = type("app", (), {"background": False, "timers": Timers, "is_job_running": staticmethod(lambda job: False)})
    monkeypatch.setattr(finding, "bpy", type("bpy", (), {"app": app, "data": bpy.data}))
    ob = crossing()
    bpy.context.view_layer.update()
    parameters_of(ob).contour_circle_points = 12
    bpy.context.view_layer.update()
    assert running == [finding.look] and len(started) >= 2 and set(started) == {finding.MOMENT}
    finding.stop()
    assert not running


def test_on_request_it_is_found_at_once(scene):
    ob = crossing()
    select(ob)
    assert bpy.ops.object.sweep_find_self_intersections() == {"FINISHED"}
    assert "meets" in ob.data.sweep.places


def test_the_faces_are_selected_in_edit_mode_and_the_shape_stays_live(scene):
    ob = crossing()
    select(ob)
    before = places(ob.data)
    assert bpy.ops.object.sweep_select_self_intersections() == {"FINISHED"}
    assert ob.mode == "EDIT" and tuple(scene.tool_settings.mesh_select_mode) == (False, False, True)
    bpy.ops.object.mode_set(mode="OBJECT")
    faces = selected(ob.data)
    legs = {face % 4 for face in faces if face < 64}  # four legs of 16 faces
    assert legs == {0, 3} and set(faces) & {65} and 64 not in faces  # and the cap at the end
    corners = {vertex for face in faces for vertex in ob.data.polygons[face].vertices}
    assert set(selected(ob.data, "vertices")) == corners
    assert (places(ob.data) == before).all() and not ob.data.sweep.edited
    parameters_of(ob).contour_circle_radius = 0.5
    assert bpy.ops.object.sweep_select_self_intersections() == {"CANCELLED"} and ob.mode == "OBJECT"


def test_of_several_splines_the_faces_of_each_are_found(scene):
    bend = [(np.cos(a), np.sin(a), 0) for a in np.linspace(0, 3, 40)]
    path = curve("POLY", [(5, 0, 0), (5, 0, 3)], bend)
    ob = sweep(contour=Circle(0.5, points=8), trajectory=path, samples=Count(40))
    ob.data.sweep.generalized_cylinder.contour_circle_radius = 1.5
    select(ob)
    assert bpy.ops.object.sweep_select_self_intersections() == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    straight_faces = 8 * 39 + 2
    assert len(selected(ob.data)) and selected(ob.data).min() >= straight_faces


def test_a_mesh_changed_by_hand_has_other_faces(scene):
    ob = crossing()
    select(ob)
    ob.data.vertices[0].co.x += 1
    ob.data.update_tag()
    bpy.context.view_layer.update()
    assert ob.data.sweep.edited and not bpy.ops.object.sweep_select_self_intersections.poll()
    assert bpy.ops.object.sweep_find_self_intersections.poll()


def test_a_sweep_that_cannot_be_made_is_not_looked_at_again_and_again(scene):
    ob = crossing()
    parameters_of(ob).scale_x = "FORMULA"
    parameters_of(ob).scale_x_formula_text = "0"
    assert ob.data.sweep.error
    finding.look()
    assert not finding.is_due(ob.data) and not bpy.ops.object.sweep_find_self_intersections.poll()


def test_applied_nothing_of_it_is_left(scene):
    ob = crossing()
    finding.look()
    select(ob)
    bpy.ops.object.sweep_apply()
    assert not ob.data.sweep.places and not ob.data.sweep.looked_at and not finding.is_due(ob.data)

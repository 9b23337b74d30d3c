# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids in Blender: an option of the shape that stays live; with a window, made while the surface stands."""

import time
from dataclasses import replace

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")
pytest.importorskip("manifold3d")

from scenes import add, parameters_of, select, sweep
from test_panels import drawn, said

import sweep_addon as sw
from sweep_addon.core.contours import Circle, Outline, Rectangle
from sweep_addon.core.stations.sampling import Count
from sweep_addon.core.trajectories import Arc, Polyline
from sweep_addon.properties import finding, live, solving

TURN = Arc(0.3, 2 * np.pi)


def spindle(**more):
    return sweep(contour=Circle(0.5, points=16), trajectory=TURN, samples=Count(32), **more)


def volume(mesh):
    mesh.calc_loop_triangles()
    places = np.array([vertex.co for vertex in mesh.vertices])
    a, b, c = places[np.array([triangle.vertices for triangle in mesh.loop_triangles])].swapaxes(0, 1)
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


@pytest.fixture
def window(monkeypatch):
    """As with a window: the surface stands while a solid is made."""
    monkeypatch.setattr(live, "waits", lambda depsgraph: not (depsgraph and depsgraph.mode == "RENDER"))


def made(mesh):
    """The work of a mesh, once it is done."""
    work = solving.work_of(mesh)
    while not work.done:
        time.sleep(0.01)
    return work


def test_in_background_the_mesh_is_the_solid_at_once_and_follows_its_parameters(scene):
    ob = spindle()
    surface = volume(ob.data)
    parameters_of(ob).make_solid = True
    assert volume(ob.data) > 1.02 * surface and not ob.data.sweep.solid
    before = volume(ob.data)
    parameters_of(ob).contour_circle_radius = 0.6
    assert volume(ob.data) > before
    parameters_of(ob).contour_circle_radius = 0.5
    parameters_of(ob).make_solid = False
    assert volume(ob.data) == pytest.approx(surface, rel=1e-6)


def test_blenders_exact_boolean_finds_the_same_volume(scene):
    """Of legs that cross; of the spindle it is wrong."""
    path = Polyline([(-2, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0.1, -2, 0.1)])
    ob = sweep(contour=Rectangle(0.5, 0.4), trajectory=path)
    far = add("far", bpy.data.meshes.new("far"))
    far.data.from_pydata(
        [(9, 9, 9), (9.1, 9, 9), (9, 9.1, 9), (9, 9, 9.1)], [], [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
    )
    boolean = ob.modifiers.new("union", "BOOLEAN")
    boolean.operation, boolean.solver, boolean.use_self, boolean.object = "UNION", "EXACT", True, far
    exact = volume(ob.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()) - 0.1**3 / 6
    ob.modifiers.clear()
    surface = volume(ob.data)
    parameters_of(ob).make_solid = True
    assert volume(ob.data) == pytest.approx(exact, rel=1e-5) and exact < 0.97 * surface


def test_with_a_window_the_surface_stands_until_the_solid_is_ready(scene, window):
    ob = spindle(make_solid=True)
    mesh = ob.data
    surface = volume(mesh)
    assert mesh.sweep.solid == live.AWAITED and finding.is_due(mesh) and "In a moment" in said(drawn(ob, width=2000))
    work = made(mesh)
    solving.finish(mesh, work)
    assert volume(mesh) > 1.02 * surface and not mesh.sweep.solid and not mesh.sweep.told
    assert work.wanted == mesh.sweep.made
    parameters_of(ob).contour_circle_radius = 0.45
    assert mesh.sweep.solid == live.AWAITED  # and so it goes on
    parameters_of(ob).make_solid = False
    assert not mesh.sweep.solid


def test_what_is_refused_while_a_solid_is_made_stays_told(scene, window):
    ob = spindle(make_solid=True, twist="0*t")
    surface, work = volume(ob.data), made(ob.data)
    parameters_of(ob).twist_formula_text = "0*"
    refusal = ob.data.sweep.error
    solving.finish(ob.data, work)
    assert refusal and ob.data.sweep.error == refusal and volume(ob.data) > 1.02 * surface
    parameters_of(ob).twist_formula_text = "0*t"
    assert not ob.data.sweep.error and ob.data.sweep.solid == live.AWAITED


def test_esc_leaves_the_surface_and_says_so(scene, window):
    ob = spindle(make_solid=True)
    surface = volume(ob.data)
    work = solving.work_of(ob.data)
    work.stop()
    while not work.done:
        time.sleep(0.01)
    solving.finish(ob.data, work)
    assert ob.data.sweep.solid == solving.STOPPED.format("solid") and volume(ob.data) == surface
    assert solving.STOPPED.format("solid") in said(drawn(ob, width=2000)) and "object.sweep_make_solid" in drawn(ob)
    finding.find(ob.data)
    assert not finding.is_due(ob.data)


def wavy():
    """An outline of more points than a roof is made of while somebody waits."""
    turns = 2 * np.pi * np.arange(1100) / 1100
    radius = 1 + 0.1 * np.sin(40 * turns)
    return Outline([np.stack((radius * np.cos(turns), radius * np.sin(turns)), axis=1)])


def test_a_roof_that_a_script_makes_is_there_when_it_goes_on(scene, window):
    """Nothing of it could be seen at once: an empty mesh would be exported, and a refusal be told to nobody."""
    shape = sw.TranslationalSweep(wavy(), height=0.2, taper=0.4)
    ob = sw.to_object(shape)
    assert not ob.data.sweep.solid and len(ob.data.vertices) == len(shape.mesh().vertices) > 1100
    known = set(bpy.data.meshes)
    with pytest.raises(sw.ShapeError, match="taper"):
        sw.to_object(replace(shape, taper=1.5))
    assert set(bpy.data.meshes) == known


@pytest.mark.parametrize("end", ["flat", "open"])
def test_a_roof_of_many_points_is_made_while_the_last_mesh_stands(scene, window, end):
    ob = sw.to_object(sw.TranslationalSweep(wavy(), height=0.2, end=end))
    assert len(ob.data.vertices) == 2 * 1100 and not ob.data.sweep.solid
    ob.data.sweep.translational_sweep.taper = 0.5
    assert len(ob.data.vertices) == 2 * 1100 and ob.data.sweep.solid == live.AWAITED
    work = solving.work_of(ob.data)
    while not work.part:
        time.sleep(0.01)
    work.stop()
    while not work.done:
        time.sleep(0.01)
    solving.finish(ob.data, work)
    assert ob.data.sweep.solid == solving.STOPPED.format("solid") and len(ob.data.vertices) == 2 * 1100
    solving.finish(ob.data, made(ob.data))
    assert not ob.data.sweep.solid and len(ob.data.vertices) == len(sw.from_object(ob).mesh().vertices) > 1100


def test_why_there_is_no_solid_is_told(scene, window):
    ob = spindle()
    parameters_of(ob).trajectory_arc_angle = 2.0
    parameters_of(ob).start = "OPEN"
    parameters_of(ob).make_solid = True
    solving.finish(ob.data, made(ob.data))
    assert "got an open surface" in ob.data.sweep.solid and len(ob.data.vertices) == 16 * 32


def test_where_nobody_waits_an_awaited_solid_is_made_at_once(scene, monkeypatch):
    """As in a render of a file that was saved before its solid was ready."""
    with monkeypatch.context() as patch:
        patch.setattr(live, "waits", lambda depsgraph: True)
        ob = spindle(make_solid=True)
    surface = volume(ob.data)
    assert ob.data.sweep.solid == live.AWAITED
    live.rebuild(ob.data)
    assert volume(ob.data) > 1.02 * surface and not ob.data.sweep.solid


def test_the_option_stands_where_the_warning_is(scene):
    ob = spindle()
    select(ob)
    finding.find(ob.data)
    lines = drawn(ob)
    assert lines.index("make_solid") > lines.index("object.sweep_select_self_intersections")


def test_a_script_makes_a_solid_at_once(scene, window):
    """Where there is a window the surface stands until the operator is called, which returns with the solid."""
    ob = spindle(make_solid=True)
    surface = volume(ob.data)
    select(ob)
    assert ob.data.sweep.solid == live.AWAITED
    assert bpy.ops.object.sweep_make_solid() == {"FINISHED"}
    assert not ob.data.sweep.solid and volume(ob.data) > 1.02 * surface


def test_a_mesh_in_edit_mode_is_left_as_it_is(scene, window):
    """What is edited would be written over when Edit Mode ends."""
    ob = spindle(make_solid=True)
    select(ob)
    bpy.ops.object.mode_set(mode="EDIT")
    with pytest.raises(RuntimeError, match="leave Edit Mode first"):
        bpy.ops.object.sweep_make_solid()
    bpy.ops.object.mode_set(mode="OBJECT")
    assert ob.data.sweep.solid == live.AWAITED


def test_a_script_that_asks_for_the_solid_of_what_is_none_hears_why(scene):
    select(spindle())
    with pytest.raises(RuntimeError, match="must be a sweep whose Make Solid is on"):
        bpy.ops.object.sweep_make_solid()

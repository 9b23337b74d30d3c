# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Canal surfaces in Blender: added, along a curve with its radii, live, and of discs."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import places, select, straight

import sweep_addon as sw


def test_added_canal_surface_follows_its_law(scene):
    bpy.ops.mesh.canal_surface_add(trajectory="LINE", radius="FORMULA", radius_formula_text="0.2 + 0.5*t", points=16)
    ob = bpy.context.active_object
    assert ob.data.sweep.kind == "CANAL_SURFACE" and not ob.data.validate()
    highest = places(ob.data)[:, 2].max()
    assert highest == pytest.approx(1 + 0.7)
    ob.data.sweep.canal_surface.radius_formula_text = "0.2"
    assert places(ob.data)[:, 2].max() == pytest.approx(1.2)


def test_ball_of_a_curve_has_the_radius_of_its_points(scene):
    """A cone between balls of 0.1 and 0.3, by the radius of two points; the active of two curves is the path."""
    path, other = straight(), straight(5.0)
    path.data.splines[0].points[1].radius = 3.0
    select(path, other)
    assert bpy.ops.object.sweep_selected(shape="CANAL_SURFACE") == {"FINISHED"}
    ob = bpy.context.active_object
    assert ob.parent == path
    vertices = places(ob.data)
    assert vertices[:, 2].min() == pytest.approx(-0.1) and vertices[:, 2].max() == pytest.approx(2.3)
    apart = np.linalg.norm(vertices[:, None] - [(0, 0, 0), (0, 0, 2)], axis=2) - (0.1, 0.3)
    assert np.abs(apart).min(axis=1).max() < 1e-6


def test_discs_are_faces_that_can_be_read_back(scene):
    shape = sw.CanalSurface(sw.trajectories.Arc(5.0), 1.0, "disc")
    ob = sw.to_object(shape)
    assert sw.from_object(ob) == shape
    assert sum(face.area for face in ob.data.polygons) == pytest.approx(11 * np.pi, rel=1e-3)  # half a ring, one disc
    ob.data.sweep.canal_surface.trajectory = "HELIX"
    assert ob.data.sweep.error.startswith("trajectory: must lie in a plane for discs, got points")


def test_swallowed_balls_are_told(scene):
    ob = sw.to_object(sw.CanalSurface(sw.trajectories.Line(), "0.3 + 0.2*sin(12*t)"))
    assert ob.data.sweep.told.startswith("Radius: from u = 0 to 0.095 it changes faster than the path goes on")

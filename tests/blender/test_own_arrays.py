# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays of Blender's own: written into where they prove to be such, else item by item or by a copy."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import places

import sweep_addon as sw
from sweep_addon.bridge import face_offsets, meshes, own_arrays
from sweep_addon.bridge.own_arrays import FEWEST, own_array, seen_array

PRISM = sw.contours.RegularPolygon(sides=6)
HELIX = sw.trajectories.Helix()
LARGE = sw.GeneralizedCylinder(PRISM, HELIX, sw.sampling.Count(FEWEST))  # its caps have six corners, its sides four
SMALL = sw.GeneralizedCylinder(PRISM, HELIX, sw.sampling.Count(3))
KNOWN = (5, 3)  # of Blenders before this one it is known that they hold an array


def array_of_offsets(polygons):
    """Where the corners of faces start."""
    return own_array(polygons, "loop_start", np.int32)


class Faces(list):
    """Faces as RNA offers them, whose structures of so many integers lie in a buffer; or only seem to."""

    class Face:
        def __init__(self, kept, shown, index):
            self.kept, self.shown, self.index = kept, shown, index

        def as_pointer(self):
            return self.shown.ctypes.data + self.index * self.shown.itemsize

        loop_start = property(lambda self: self.kept[self.index], lambda self, n: self.kept.__setitem__(self.index, n))

    def __init__(self, count, integers=1, elsewhere=False):
        kept = np.zeros(count * integers, np.int32)
        shown = kept.copy() if elsewhere else kept
        super().__init__(self.Face(kept, shown, i * integers) for i in range(count))
        self.shown = shown


def written(mesh, made):
    """What Blender says of a mesh of arrays once it is written, and whether it finds anything to repair."""
    meshes.write(mesh, made)
    starts, totals = np.empty((2, len(mesh.polygons)), np.int32)
    mesh.polygons.foreach_get("loop_start", starts)
    mesh.polygons.foreach_get("loop_total", totals)
    return starts, totals, mesh.validate()


@pytest.mark.parametrize("shape", [LARGE, SMALL])
def test_both_ways_to_write_make_the_mesh_of_the_arrays(scene, monkeypatch, shape):
    made = shape.mesh()
    direct = written(bpy.data.meshes.new("Direct"), made)
    monkeypatch.setattr(face_offsets, "own_array", lambda *_: None)
    one_by_one = written(bpy.data.meshes.new("One by one"), made)
    for starts, totals, repaired in (direct, one_by_one):
        np.testing.assert_array_equal(starts, made.offsets[:-1])
        np.testing.assert_array_equal(totals, np.diff(made.offsets))
        assert not repaired


def test_mesh_that_shares_its_faces_with_a_copy_leaves_the_copy_as_it_was(scene):
    made, others = LARGE.mesh(), sw.GeneralizedCylinder(PRISM, HELIX, sw.sampling.Count(FEWEST + 1)).mesh()
    mesh = bpy.data.meshes.new("Mesh")
    meshes.write(mesh, made)
    copy = mesh.copy()
    starts, _, repaired = written(mesh, others)
    np.testing.assert_array_equal(starts, others.offsets[:-1])
    kept = np.empty(len(copy.polygons), np.int32)
    copy.polygons.foreach_get("loop_start", kept)
    np.testing.assert_array_equal(kept, made.offsets[:-1])
    assert not repaired and not copy.validate()


@pytest.mark.skipif(bpy.app.version >= KNOWN, reason="a newer Blender may hold its faces in other ways")
def test_array_is_found_in_the_blenders_that_hold_one(scene):
    mesh = bpy.data.meshes.new("Mesh")
    mesh.loops.add(3 * FEWEST)
    mesh.polygons.add(FEWEST)
    held = array_of_offsets(mesh.polygons)
    held[:] = 3 * np.arange(FEWEST)
    assert [mesh.polygons[i].loop_start for i in (0, 1, 500, 999)] == [0, 3, 1500, 2997]


def test_array_is_found_only_where_faces_are_its_integers():
    faces = Faces(10)
    array_of_offsets(faces)[:] = range(10)
    assert faces.shown.tolist() == list(range(10))
    assert array_of_offsets(Faces(10, integers=3)) is None  # as Blender held them until 3.5
    assert array_of_offsets(Faces(10, elsewhere=True)) is None


def test_array_is_seen_without_setting_a_value(scene):
    mesh = LARGE.mesh()
    held = bpy.data.meshes.new("Mesh")
    meshes.write(held, mesh)
    seen = seen_array(held.attributes["position"].data, "vector", np.float32, 3)
    assert seen is None or seen.tolist() == mesh.vertices.astype(np.float32).ravel().tolist()
    assert seen is not None or bpy.app.version >= KNOWN
    np.testing.assert_array_equal(places(held), mesh.vertices.astype(np.float32))


def test_array_is_seen_only_where_items_lie_and_read_as_its_numbers():
    faces = Faces(10)
    faces.shown[:] = range(10)
    assert seen_array(faces, "loop_start", np.int32).tolist() == list(range(10))
    assert seen_array(Faces(10, integers=3), "loop_start", np.int32) is None
    apart = Faces(10, elsewhere=True)
    apart.shown[:] = 1
    assert seen_array(apart, "loop_start", np.int32) is None


@pytest.fixture
def drawn(scene, monkeypatch):
    """The arrays of Blender's own that vertices and texture coordinates were drawn into: meshes here count as large."""
    found = []
    monkeypatch.setattr(own_arrays, "MANY", 100)
    monkeypatch.setattr(own_arrays, "own_array", lambda *asked: found.append(own_array(*asked)) or found[-1])
    return found


TUBE = sw.GeneralizedCylinder(sw.contours.Circle(0.1, points=10), HELIX, sw.sampling.Count(20))


def shown(ob):
    """What Blender shows: places, and the corners of the box that it finds round them."""
    evaluated = ob.evaluated_get(bpy.context.evaluated_depsgraph_get())
    return places(evaluated.data), np.array(evaluated.bound_box)


def agrees(ob, shape):
    """That what Blender shows is a shape, its box and its texture coordinates too."""
    made, (found, box) = shape.mesh(), shown(ob)
    uv = np.empty(2 * len(made.corners), np.float32)
    ob.data.uv_layers[0].uv.foreach_get("vector", uv)
    ends = np.stack((box.min(axis=0), box.max(axis=0)))
    np.testing.assert_allclose(found, made.vertices, atol=1e-6)
    np.testing.assert_allclose(ends, np.stack((made.vertices.min(axis=0), made.vertices.max(axis=0))), atol=1e-6)
    np.testing.assert_allclose(uv.reshape(-1, 2), made.uv, atol=1e-5)
    assert not ob.data.validate()


@pytest.mark.skipif(bpy.app.version >= KNOWN, reason="a newer Blender may hold its vertices in other ways")
def test_vertices_and_texture_coordinates_are_drawn_into_blenders_own_arrays(drawn):
    ob = sw.to_object(TUBE)
    assert len(drawn) == 1  # vertices had no room before there were any
    ob.data.sweep.generalized_cylinder.contour_circle_radius = 0.2
    assert len(drawn) == 3 and all(array is not None for array in drawn)


def test_what_is_drawn_so_is_what_is_shown(drawn):
    ob = sw.to_object(TUBE)
    agrees(ob, TUBE)
    group = ob.data.sweep.generalized_cylinder
    for radius in (0.5, 0.25):
        group.contour_circle_radius = radius
        agrees(ob, sw.GeneralizedCylinder(sw.contours.Circle(radius, points=10), HELIX, TUBE.samples))
    copy = ob.data.copy()
    kept = places(copy)
    group.trajectory_helix_pitch = 1.0
    agrees(
        ob, sw.GeneralizedCylinder(sw.contours.Circle(0.25, points=10), sw.trajectories.Helix(pitch=1.0), TUBE.samples)
    )
    np.testing.assert_array_equal(places(copy), kept)


def test_other_faces_of_as_many_vertices_are_drawn_beside_them(drawn):
    ob = sw.to_object(TUBE)
    sweep = ob.data.sweep
    sweep.paused = True
    sweep.generalized_cylinder.contour_circle_points = 20
    sweep.generalized_cylinder.samples_count_contours = 10
    sweep.paused = False
    agrees(ob, sw.GeneralizedCylinder(sw.contours.Circle(0.1, points=20), HELIX, sw.sampling.Count(10)))


def test_a_refused_change_leaves_all_vertices_where_they_are(drawn):
    ob = sw.to_object(TUBE)
    group = ob.data.sweep.generalized_cylinder
    group.scale_x = group.scale_y = "FORMULA"
    kept = places(ob.data)
    group.scale_x_formula_text = "sqrt(-t)"
    assert ob.data.sweep.error
    np.testing.assert_array_equal(places(ob.data), kept)


def test_arrays_that_cannot_be_proven_are_written_by_a_copy(scene, monkeypatch):
    monkeypatch.setattr(own_arrays, "MANY", 100)
    monkeypatch.setattr(own_arrays, "own_array", lambda *_: None)
    ob = sw.to_object(TUBE)
    ob.data.sweep.generalized_cylinder.contour_circle_radius = 0.2
    agrees(ob, sw.GeneralizedCylinder(sw.contours.Circle(0.2, points=10), HELIX, TUBE.samples))

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the corners of faces start: written into Blender's own array where it proves to be one, else face by face."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

import sweep_addon as sw
from sweep_addon.bridge import face_offsets, meshes
from sweep_addon.bridge.face_offsets import FEWEST, array_of_offsets

PRISM = sw.contours.RegularPolygon(sides=6)
HELIX = sw.trajectories.Helix()
LARGE = sw.GeneralizedCylinder(PRISM, HELIX, sw.sampling.Count(FEWEST))  # its caps have six corners, its sides four
SMALL = sw.GeneralizedCylinder(PRISM, HELIX, sw.sampling.Count(3))
KNOWN = (5, 3)  # of Blenders before this one it is known that they hold an array


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
    monkeypatch.setattr(face_offsets, "array_of_offsets", lambda polygons: None)
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

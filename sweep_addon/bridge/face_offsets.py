# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the corners of each face start, written into a Blender mesh at once.

These numbers are no attribute. RNA offers them as `loop_start` of each face, with a function that sets one of them, and
`foreach_set` calls it for every face: a quarter of what a new topology of 640,000 faces takes. Blender holds them as
one array of C integers, and a face's own pointer is the address of its integer there, so they are copied into it.

This is not promised by Blender, so it is found out each time, on faces that were just added:

- They are an array of the mesh's own. Setting a value through RNA makes it so where the mesh shared it with another.
- The faces' pointers lie as far from each other as integers of an array do. A Blender whose faces are larger
  structures, or that answers with numbers of faces, is told apart by that.
- Numbers that nothing else writes, set through RNA on the first, the middle and the last face, are read at these
  pointers. No other memory than theirs, and what lies between them, is then written.

Where any of this is not so, `foreach_set` writes them: slower, and right in every Blender.
"""

import ctypes

import numpy as np

FEWEST = 1000  # faces that are worth the looking
SENTINELS = (0x5EED0001, 0x5EED0002, 0x5EED0003)  # of the first, the middle and the last face


def write_face_offsets(mesh, offsets):
    """Say where the corners of each face start.

    Parameters
    ----------
    mesh : bpy.types.Mesh
        Its faces were just added, and it has not been handed to anybody since.
    offsets : (f,) int32 array
        The first corner of each of its faces.
    """
    held = array_of_offsets(mesh.polygons) if len(mesh.polygons) >= FEWEST else None
    if held is None:
        mesh.polygons.foreach_set("loop_start", offsets)
    else:
        held[:] = offsets


def array_of_offsets(polygons):
    """Blender's own array of where faces start, or None where it cannot be proven to be one.

    Some of its values are not kept.
    """
    count = len(polygons)
    proven = (0, count // 2, count - 1)
    for index, value in zip(proven, SENTINELS, strict=True):
        polygons[index].loop_start = value
    first, *others = (polygons[index].as_pointer() for index in proven)
    size = ctypes.sizeof(ctypes.c_int)
    if any(other - first != size * index for other, index in zip(others, proven[1:], strict=True)):
        return None
    if any(ctypes.c_int.from_address(first + size * i).value != v for i, v in zip(proven, SENTINELS, strict=True)):
        return None
    return np.ctypeslib.as_array((ctypes.c_int * count).from_address(first))

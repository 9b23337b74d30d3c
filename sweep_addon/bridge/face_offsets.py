# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the corners of each face start, written into a Blender mesh at once.

These numbers are no attribute. RNA offers them as `loop_start` of each face, with a function that sets one of them, and
`foreach_set` calls it for every face: a quarter of what a new topology of 640,000 faces takes. Blender holds them as
one array of C integers, and a face's own pointer is the address of its integer there.
"""

import numpy as np

from .own_arrays import FEWEST, own_array


def write_face_offsets(mesh, offsets):
    """Say where the corners of each face start.

    Parameters
    ----------
    mesh : bpy.types.Mesh
        Its faces were just added, and it has not been handed to anybody since.
    offsets : (f,) int32 array
        The first corner of each of its faces.
    """
    held = own_array(mesh.polygons, "loop_start", np.int32) if len(mesh.polygons) >= FEWEST else None
    if held is None:
        mesh.polygons.foreach_set("loop_start", offsets)
    else:
        held[:] = offsets

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a Blender mesh that is a sweep meets itself, and the faces that are there."""

import numpy as np

from ..core.shapes.kinds import SWEPT
from . import objects


def told(mesh, searched=True):
    """Sentences about all places where the sweeps of a mesh meet themselves: a tuple of str.

    Parameters
    ----------
    mesh : bpy.types.Mesh
    searched : bool
        Whether the largest safe size is told too where it takes a search: a tenth of a second, or seconds.

    Raises
    ------
    ShapeError
        Where a shape cannot be made.
    """
    found = (shape.self_intersections() for shape in objects.shapes(mesh) if isinstance(shape, SWEPT))
    sentences = (places.told if searched else places.told_at_once for places in found)
    return tuple(dict.fromkeys(sentence for some in sentences for sentence in some))


def select(mesh):
    """Select the faces at these places, and no others.

    Returns
    -------
    int
        How many there are.

    Raises
    ------
    ShapeError
        Where a shape cannot be made.
    """
    faces = crossing(mesh)
    chosen = np.isin(np.arange(len(mesh.polygons)), faces)
    sizes, corners, edges = np.empty(len(chosen), np.int32), *np.empty((2, len(mesh.loops)), np.int32)
    mesh.polygons.foreach_get("loop_total", sizes)
    mesh.attributes[".corner_vert"].data.foreach_get("value", corners)
    mesh.attributes[".corner_edge"].data.foreach_get("value", edges)
    at = np.repeat(chosen, sizes)
    for parts, which in ((mesh.polygons, faces), (mesh.vertices, corners[at]), (mesh.edges, edges[at])):
        selected = np.zeros(len(parts), bool)
        selected[which] = True
        parts.foreach_set("select", selected)
    mesh.update()
    return len(faces)


def crossing(mesh):
    """The numbers of these faces in a mesh that is as its shapes make it: (k,) int array."""
    from ..core.self_intersection.faces import faces_of

    start, found = 0, [np.zeros(0, int)]
    for shape in objects.shapes(mesh):
        made, places = shape.mesh(dtype=np.float32), isinstance(shape, SWEPT) and shape.self_intersections()
        if places:
            one = hasattr(made.chart, "grid")  # of sweeps of several sections all faces are chosen
            found.append(start + (faces_of(made.chart, places) if one else np.arange(len(made.offsets) - 1)))
        start += len(made.offsets) - 1
    return np.concatenate(found)

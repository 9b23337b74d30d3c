# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of the scene as straight models that a curved axis bends."""

import bpy
import numpy as np

from ..core.declared.parameters import require


def mesh(ob, shape, axis, start, fit, depsgraph):
    """A new mesh: that of an object, its modifiers applied, bent along a shape.

    Parameters
    ----------
    ob : bpy.types.Object
        A mesh object, scaled as it is seen.
    shape : PDCurveSweep
    axis : int
        Which of the object's own axes runs along the trajectory; the two that follow lie along e2 and e3.
    start : float
        Where on the trajectory the object's origin stands, in metres.
    fit : bool
        Whether the mesh is stretched to be as long as the trajectory, from its start on.
    depsgraph : bpy.types.Depsgraph

    Raises
    ------
    ShapeError
        Nothing is left behind.
    """
    made = bpy.data.meshes.new_from_object(ob.evaluated_get(depsgraph), depsgraph=depsgraph)
    try:
        points = np.empty(3 * len(made.vertices), np.float32)
        made.attributes["position"].data.foreach_get("vector", points)
        model = points.reshape(-1, 3) * np.array(ob.matrix_world.to_scale(), dtype=float)
        straight = model[:, [(axis + 1) % 3, (axis + 2) % 3, axis]]
        if fit:
            long = float(np.ptp(straight[:, 2])) if len(straight) else 0.0
            require(long > 0, "must be long along its axis to be fitted", long, ob.name)
            straight[:, 2] = (straight[:, 2] - straight[:, 2].min()) * (shape.trajectory.length() / long)
        straight[:, 2] += start
        made.attributes["position"].data.foreach_set("vector", shape.bend(straight).astype(np.float32).ravel())
    except Exception:
        bpy.data.meshes.remove(made)
        raise
    made.update()
    made.name = f"{ob.name} Bent"
    return made


def remove(meshes):
    """Remove meshes that were made for nothing."""
    for made in meshes:
        bpy.data.meshes.remove(made)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What balls of changing radius leave: the cone that touches them all, which no discs of their radii do."""

import numpy as np
from peers import Bevel, CurveToMesh, curve, places

from bl_ext.user_default import sweep_addon as sw

SIDES, RADIUS = 64, 1.0
SLOPE = 0.5  # by how much the radius falls in a metre
PATH = np.array([(0, 0, z) for z in np.linspace(0, RADIUS / SLOPE, 9)])
LATERAL = 0.45, 1.9  # heights between which there is nothing but the cone


def rows():
    """Half the angle of the cone in degrees, from the vertices of each."""
    truth = np.degrees(np.arcsin(SLOPE))
    canal = sw.CanalSurface(sw.trajectories.Polyline(PATH), f"{RADIUS} - {SLOPE}*s", points=SIDES)
    bevel = Bevel(PATH, SIDES, RADIUS)
    bevel.object.data.splines[0].points.foreach_set("radius", np.linspace(1, 0, len(PATH)))
    meshes = sw.to_object(canal).data, CurveToMesh(curve(PATH), SIDES, RADIUS, shrinking=True).mesh(), bevel.mesh()
    found = [f"{half_angle(places(mesh)):.3f}" for mesh in meshes]
    name = f"cone around balls whose radius falls by {SLOPE} m a metre: half its angle, degrees"
    yield [name, f"{truth:.3f}", *found, "-", "-"]


def half_angle(vertices):
    """The angle at the tip between the axis and the vertices of the cone, the largest of them."""
    low, high = LATERAL
    cone = vertices[(vertices[:, 2] > low) & (vertices[:, 2] < high)]
    return np.degrees(np.arctan2(np.hypot(cone[:, 0], cone[:, 1]), RADIUS / SLOPE - cone[:, 2]).max())

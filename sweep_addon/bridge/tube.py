# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A tube that Blender itself draws along a curve, read as a sweep."""

from collections.abc import Callable

import numpy as np

from ..core.contours import Circle
from ..core.declared.frozen import frozen
from ..core.declared.parameters import require
from ..core.rings.ends import Flat, Open
from ..core.shapes.generalized_cylinder import GeneralizedCylinder
from ..core.stations.frames import FixedUp, RotationMinimizing, axes, first_normal
from ..core.stations.sampling import Tolerance, place
from ..core.trajectories.arc_length import arc_length

CHORD, FINE = 0.001, 0.02  # metres, and of the contour's reach: chords are no farther from the curve than the smaller
ON_SPLINES = {"HOOK", "SOFT_BODY", "MESH_DEFORM"}  # modifiers that always move a curve's points, and not its surface
SAME = 1e-3  # radians


@frozen
class Tube:
    """What Blender draws, as a sweep would be told.

    Parameters
    ----------
    shape : GeneralizedCylinder
    objects : dict
        The trajectory object, and where it is one, the contour object, by the parameter they stand for.
    place : bpy.types.Object
        In whose space the tube is.
    material : bpy.types.Material or None
    quiet : callable
        Takes from the objects what they draw themselves; the curve stays.
    """

    shape: GeneralizedCylinder
    objects: dict
    place: object
    material: object
    quiet: Callable


def shape(contour, frame, capped, reach, **laws):
    """The sweep of a contour that reaches so far, with what Blender may close or leave open."""
    end = Flat() if capped else Open()
    own = {} if contour is None else {"contour": contour}
    chord = Tolerance(min(CHORD, FINE * reach))
    return GeneralizedCylinder(samples=chord, frame=frame, start=end, end=end, **own, **laws)


def frame(curve):
    """The frame that carries the contours of a Blender curve."""
    require(curve.twist_mode != "TANGENT", "twist method must be minimum or z-up", "tangent")
    require(curve.twist_smooth == 0, "twist smoothing must be 0", curve.twist_smooth)
    return FixedUp() if curve.twist_mode == "Z_UP" and curve.dimensions == "3D" else RotationMinimizing()


def first_twist(paths, contour, where, turn=None):
    """The twist with which a rotation-minimizing frame starts as Blender's does.

    Parameters
    ----------
    paths : list of Trajectory
    contour : contour or None
    where : callable
        From a trajectory to the parameter where Blender starts.
    turn : (3, 3) float array, optional
        The rotation into the space in which Blender chooses its first normal.
    """
    turn = np.eye(3) if turn is None else turn
    found = []
    for path in paths:
        s = float(arc_length(path).at(np.array([where(path)]))[0])
        stations = place(path, Tolerance(path.length() / 100), (s,))
        e2, e3, _ = axes(RotationMinimizing(), stations, np.zeros(len(stations.s)))
        near = int(np.abs(stations.s - s).argmin())
        normal = (first_normal(stations.tangent[near : near + 1] @ turn.T) @ turn)[0]
        found.append(np.arctan2(normal @ e3[near], normal @ e2[near]))
    apart = np.abs(np.exp(1j * np.array(found)) - np.exp(1j * found[0])).max()
    if not isinstance(contour, Circle):
        require(apart < SAME, "splines must not start turned differently; separate them", f"{apart:.3g} rad")
    return round(float(found[0]), 6) if abs(found[0]) > SAME else 0.0


def enabled(ob):
    """The modifiers of an object that are at work."""
    return [modifier for modifier in ob.modifiers if modifier.show_viewport or modifier.show_render]


def require_on_splines(modifiers):
    """Refuse modifiers that change the surface and not the curve: the last that moves points takes all before it."""
    last = modifiers[-1] if modifiers else None
    fits = last is None or last.type in ON_SPLINES or last.use_apply_on_spline
    require(fits, "modifiers must work on the curve's points; apply or remove", last and last.name)


def require_cyclic(contour):
    """Refuse a contour object that is no closed outline."""
    require(contour.type == "CURVE", "the profile must be a curve object", contour.type.lower())
    closed = all(spline.use_cyclic_u for spline in contour.data.splines)
    require(closed, "the splines of the profile must be cyclic; a sweep's contour is closed", contour.name)

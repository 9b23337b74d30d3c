# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The bevel of a Blender curve as a tube: what it draws, and what of it no sweep can be.

Blender sets the bevel object's y axis against e3 of the minimum twist, and its x axis against e2 of z-up. It starts a
cyclic Bezier spline at its last knot.
"""

import numpy as np

from ..core.contours import Circle, Rectangle
from ..core.declared.parameters import at, require
from ..core.stations.frames import FixedUp, RotationMinimizing
from ..core.trajectories import Bezier
from ..core.trajectories.arc_length import arc_length
from . import curves
from .rna import decimal
from .tube import Tube, enabled, first_twist, frame, require_cyclic, require_on_splines, shape

DRAWS = {"bevel_depth", "extrude", "offset", "bevel_factor_start", "bevel_factor_end", "bevel_resolution"}
TAPER_POINTS = 65  # of the law that a taper object becomes


def is_bevelled(ob):
    """Whether an object is a curve that has a thickness."""
    if ob is None or ob.type != "CURVE":
        return False
    curve = ob.data
    return bool(curve.bevel_object if curve.bevel_mode == "OBJECT" else curve.bevel_depth or curve.extrude)


def tube(ob):
    """The bevel of a curve object.

    Raises
    ------
    ShapeError
        Where it has what a sweep has not, under the object's name.
    """
    curve = ob.data
    with at(ob.name):
        paths = curves.trajectories(ob)
        check(curve, paths)
        require_on_splines(enabled(ob))
        carried_by = frame(curve)
        inputs, laws = {"trajectory": ob}, taper(curve, paths)
        if curve.bevel_mode == "OBJECT":
            require_cyclic(curve.bevel_object)
            inputs["contour"], contour = curve.bevel_object, None
            section = curves.outline(curve.bevel_object).section()
            side = "scale_x" if isinstance(carried_by, FixedUp) else "scale_y"
            laws[side] = mirrored(laws[side])
        else:
            contour = round_contour(curve)
            section = contour.section()
        if isinstance(carried_by, RotationMinimizing):
            laws["twist"] = first_twist(paths, contour, starts)
        reach = float(np.linalg.norm(section.points, axis=1).max())
        made = shape(contour, carried_by, curve.use_fill_caps, reach, **laws)
        return Tube(made, inputs, ob, material(ob), lambda: quiet(ob))


def starts(path):
    """The parameter of a trajectory where Blender's bevel starts."""
    last_knot = isinstance(path, Bezier) and path.closed
    return path.domain[1] - 1 if last_knot else path.domain[0]


def check(curve, paths):
    """Refuse a bevel that no sweep can be."""
    full = "FULL" if curve.dimensions == "3D" else "NONE"
    require(curve.bevel_mode != "PROFILE", "the bevel must be round or an object", "a custom profile")
    if curve.bevel_mode == "ROUND" or full == "NONE":
        require(curve.fill_mode == full, f"the fill mode must be {full.lower()}", curve.fill_mode.lower())
    if curve.bevel_mode == "ROUND":
        require(curve.bevel_depth > 0, "the bevel depth must be more than 0", curve.bevel_depth)
    require(curve.offset == 0, "the offset must be 0", curve.offset)
    factors = [curve.bevel_factor_start, curve.bevel_factor_end]
    require(factors == [0, 1], "the bevel must start at 0 and end at 1", factors)
    moving = DRAWS & animated(curve)
    require(not moving, "the bevel must not be animated", ", ".join(sorted(moving)))
    for spline in curve.splines if any(path.carries for path in paths) else ():
        if spline.type == "BEZIER":
            ways = {spline.radius_interpolation, spline.tilt_interpolation}
            require(
                ways == {"LINEAR"}, "radius and tilt must be interpolated linearly", ", ".join(sorted(ways)).lower()
            )


def animated(data):
    """The names of the properties that keyframes or drivers move."""
    moved = data.animation_data
    if not moved:
        return set()
    from bpy_extras import anim_utils  # a millisecond of a start, for curves that are animated

    bag = anim_utils.action_get_channelbag_for_slot(moved.action, moved.action_slot) if moved.action else None
    return {curve.data_path for curve in (*(bag.fcurves if bag else ()), *moved.drivers)}


def round_contour(curve):
    """A circle, or where the curve is extruded, a rectangle with round ends."""
    depth, steps = decimal(curve.bevel_depth), curve.bevel_resolution
    if not curve.extrude:
        return Circle(depth, 4 + 2 * steps)
    return Rectangle(2 * depth, 2 * (depth + decimal(curve.extrude)), depth, steps + 2)


def taper(curve, paths):
    """The scales that a taper object asks for, read once: its height over its own x axis, from end to end."""
    if not curve.taper_object:
        return {"scale_x": 1.0, "scale_y": 1.0}
    require(len(paths) == 1, "a curve with a taper object must have one spline", len(paths))
    radii = paths[0].radii.values
    alone = not len(radii) or curve.taper_radius_mode == "MULTIPLY"
    require(
        alone and curve.taper_radius_mode != "ADD",
        "the taper must multiply the radius of the points",
        curve.taper_radius_mode.lower(),
    )
    (profile, *_) = curves.trajectories(curve.taper_object)
    x, y, _ = profile.evaluate(np.linspace(*profile.domain, TAPER_POINTS)).T
    x, y = (x, y) if x[-1] > x[0] else (x[::-1], y[::-1])
    require((np.diff(x) > 0).all(), "the taper object must run along its x axis", curve.taper_object.name)
    measure, (first, last) = arc_length(paths[0]), paths[0].domain
    t = measure.at(first + (x - x[0]) / (x[-1] - x[0]) * (last - first)) / measure.total
    law = np.stack((t, y * curve.taper_object.scale.y), axis=1).round(7)
    return {"scale_x": law, "scale_y": law}


def mirrored(law):
    return -law if isinstance(law, float) else law * (1, -1)


def material(ob):
    """The one material of a curve's splines."""
    numbers = sorted({spline.material_index for spline in ob.data.splines})
    require(len(numbers) == 1, "all splines must have one material", len(numbers))
    return ob.material_slots[numbers[0]].material if numbers[0] < len(ob.material_slots) else None


def quiet(ob):
    """Leave of a bevelled curve the path; another object that shares the curve keeps its bevel."""
    if ob.data.users > 1:
        ob.data = ob.data.copy()
    ob.data.bevel_depth = ob.data.extrude = 0
    ob.data.bevel_object = ob.data.taper_object = None

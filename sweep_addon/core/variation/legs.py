# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Legs of a motion: a frame turns at once at corners, where a generator passes over nothing, and goes on from there."""

from dataclasses import replace

import numpy as np

from ..rings.ends import Flat, Open
from ..stations.frames import Parallel
from ..trajectories.arc_length import arc_length

NOTCHED = (
    "Frame: at corners it turns at once, and the sweep has a notch on their outer side: round corners have none, "
    "nor have those of generalized cylinders, which are mitred."
)
BESIDE = 4e-9  # of the parameters: so far beside a corner the frame is that of its leg


def legs(motion, back):
    """The arc lengths between corners at which the frame of a motion turns, and its ends.

    Parameters
    ----------
    motion : Motion
    back : bool
        Whether it comes back to where it began.

    Returns
    -------
    (k, 2) float array
        In metres, none where there is no such corner. What comes back has no ends, and goes on beyond that of its
        trajectory from the last corner to the first.

    Examples
    --------
    >>> from sweep_addon.core.shapes.general_sweep import GeneralSweep
    >>> from sweep_addon.core.trajectories import Polyline
    >>> path = Polyline([(0, 0, 0), (1, 0, 0), (1, 2, 0)])
    >>> [legs(GeneralSweep(trajectory=path, frame=f).motion, False).tolist() for f in ("parallel", "fixed-up")]
    [[], [[0.0, 1.0], [1.0, 3.0]]]
    """
    measure = arc_length(motion.trajectory)
    corners = () if isinstance(motion.frame, Parallel) else measure.at(motion.trajectory.corners())
    if not len(corners):
        return np.zeros((0, 2))
    if back:
        ends = np.append(corners, corners[0] + measure.total)
    else:
        ends = np.unique(np.concatenate(([0.0], corners, [measure.total])))
    return np.stack((ends[:-1], ends[1:]), axis=1)


def on_leg(motion, leg, s):
    """The `Poses` of a motion at arc lengths of one of its legs, (n,), at corners as this leg has them."""
    measure = arc_length(motion.trajectory)
    within = s.clip(beside(motion.trajectory, leg[0], 1), beside(motion.trajectory, leg[1], -1))
    s, within = (np.where(places > measure.total, places - measure.total, places) for places in (s, within))
    places, which = np.unique(np.append(0.0, within), return_inverse=True)
    poses = motion.at(places).only(which.ravel()[1:])
    return poses._replace(s=s, origin=motion.trajectory.evaluate(measure.parameter(s)))


def beside(trajectory, place, side):
    """The arc length right beside a corner, or an end, before it or behind; both may be beyond the end."""
    measure, (start, end) = arc_length(trajectory), trajectory.domain
    lap = measure.total if place > measure.total else 0.0
    u = measure.parameter(np.array([place - lap])) + side * BESIDE * (end - start)
    return float(measure.at(u)[0]) + lap


def between(stations, leg):
    """The arc lengths of `Stations` on a leg, its ends among them: (n,) rising."""
    s = stations.s
    s = np.concatenate((s, s + stations.total)) if leg[1] > stations.total else s
    return np.concatenate((leg[:1], s[(s > leg[0]) & (s < leg[1])], leg[1:]))


def notched(mesh):
    """The mesh of several legs of a figure, or of a surface, told to have notches."""
    return replace(mesh, told=(*mesh.told, NOTCHED))


def ends_of(shape, stood):
    """What closes the ends of each of the legs on which a generator stands: a list of two.

    At corners they are flat, or open if an end of the whole is, which then has no inside.
    """
    within = Open() if Open() in (shape.start, shape.end) else Flat()
    first, last = (shape.start, shape.end) if stood[0][0].s[0] == 0 else (within, within)  # or it comes back
    ends = [first, *[within] * (2 * len(stood) - 2), last]
    return [ends[number : number + 2] for number in range(0, len(ends), 2)]

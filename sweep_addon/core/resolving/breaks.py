# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Breaks: where a sweep is two, at a leap of its frame, and at a corner whose mitre its contours run through."""

import numpy as np

from ..declared.frozen import individual
from ..rings.mitres import cut_back, leans
from ..shapes.carrying import farthest
from ..stations.frames import axes
from ..stations.leaps import leaps
from ..vectors import dot, unit

FAR = np.cos(np.radians(45))  # a contour that turns less at once has faces that do not cross each other
ROUNDING = 1e-9  # of a ring: what is no farther beyond a plane is in it


@individual
class Break:
    """The end of one leg, and the start of the next.

    Parameters
    ----------
    before, after : int
        The rings at which they are: one, or where the frame leaps two that stand next to each other.
    plane : (2, 3) float array or None
        A point of the plane that cuts both legs off at a corner, and its normal, onward.
    behind, ahead : (k, 2, 3) float array
        Of the rings that reach through it, from these on backward, and onward: the places on the trajectory, and its
        tangents. There are none where nothing is cut off.
    """

    before: int
    after: int
    plane: np.ndarray
    behind: np.ndarray
    ahead: np.ndarray

    @property
    def around(self):
        """The segments near it: (k,) int array; of a closed sweep they may be counted beyond its ends."""
        return np.arange(self.before - len(self.behind), self.after + len(self.ahead))


def breaks(shape, rings):
    """The breaks of a generalized cylinder, in order.

    Parameters
    ----------
    shape : GeneralizedCylinder
    rings : Rings
        Of its mesh.

    Returns
    -------
    tuple of Break
        At leaps farther than `FAR`, and at those corners whose plane a ring beside them reaches through. It does on the
        inner side of a bend that goes up to its corner, and where legs are shorter than their mitres lie back.
    """
    swept = shape.swept()
    stations, shift = swept.stations, rings.grid.domes[0]
    before, after, far = at_leaps(stations, swept.along.frame)
    plain = np.setdiff1d(stations.corners, after)
    before, after, far = (np.concatenate(part) for part in ((before, plain), (after, plain), (far, plain < 0)))
    cut = np.isin(after, stations.corners)
    cut[cut] = run_through(rings, shift + before[cut], shift + after[cut])
    cut &= not leans(swept.along, shape.frame, swept.symmetry)
    order = np.flatnonzero(far | cut)
    order = order[np.argsort(after[order])]
    before, after = before[order], after[order]
    reach = swept.along.farthest(farthest(swept.body.section, swept.body.change))
    zone = np.where(cut[order], cut_back(stations.arrive[after], stations.leave[after], reach), 0.0)
    found = (values.tolist() for values in (before, after, zone))
    return tuple(broken(stations, rings, *each) for each in zip(*found, strict=True))


def at_leaps(stations, frame):
    """The stations right before leaps of a frame and right behind: two (k,); and which are farther than `FAR`."""
    found = leaps(frame, stations.trajectory)
    before, after = (np.abs(stations.s - place[:, None]).argmin(axis=1) for place in found.T)
    if not len(found):
        return before, after, np.zeros(0, dtype=bool)
    e2, e3, _ = axes(frame, stations, np.zeros(len(stations.s)))
    return before, after, dot(e2[before], e2[after]) + dot(e3[before], e3[after]) < 2 * FAR


def run_through(rings, before, after):
    """At which corners the ring beside them reaches through their plane, on one side or the other: (k,) bool."""
    count, found = rings.grid.rings, np.full(len(before), False)
    for here, beside, side in ((before, before - 1, 1.0), (after, after + 1, -1.0)):
        away = rings.points[:, beside % count] - rings.centres[here]
        found |= (side * dot(away, rings.normals[here])).max(axis=0) > ROUNDING * rings.radii[here]
    return found


def broken(stations, rings, before, after, zone):
    """The break at some stations, which cuts legs off so far along them."""
    shift, count, none = rings.grid.domes[0], len(stations.s), np.zeros((0, 2, 3))
    before -= count if before > after else 0  # of a closed sweep it may be before the first ring
    if not zone:
        return Break(before + shift, after + shift, None, none, none)
    arrive, leave = stations.arrive[after], stations.leave[after]
    plane = np.stack((stations.points[after], unit((arrive + leave)[None])[0]))
    corners = stations.corners
    if rings.closed:
        corners = np.concatenate((corners[-1:] - count, corners, corners[:1] + count))
    else:
        corners = np.unique(np.concatenate(([0], corners, [count - 1])))
    number = int(np.searchsorted(corners, after))
    back, on = np.arange(before, corners[number - 1] - 1, -1), np.arange(after, corners[number + 1] + 1)
    sides = []
    for which, side, tangents, own in ((back, 1.0, stations.leave, arrive), (on, -1.0, stations.arrive, leave)):
        along = stations.s[which % count] + which // count * stations.total - stations.s[after]
        which = which[np.abs(along) <= zone]
        held = which[: within(rings.standing(which + shift), plane[0], side * plane[1])] % count
        standing = np.stack((stations.points[held], tangents[held]), axis=1)
        standing[:1, 1] = own
        sides.append(standing)
    return Break(before + shift, after + shift, plane, *sides)


def within(places, point, outward):
    """How many rings (n, m, 3), one behind the other from that in a plane on, reach beyond it; 0 if no other does."""
    far = ((places[1:] - point) @ outward).max(axis=1) > ROUNDING * np.ptp(places[0], axis=0).max()
    return int(np.argmin(np.append(far, False))) + bool(far[:1].any())

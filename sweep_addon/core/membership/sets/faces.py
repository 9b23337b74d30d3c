# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The faces of a planar sweep across its way: where it begins and ends, is cut off, or its contour turns at once."""

from functools import cached_property

import numpy as np

from ...vectors import dot
from ..motion.panels import at_both
from ..motion.planes import SPACE, off

SAME = 1e-9  # of the whole: places, and parameters, nearer than this are one


def outer(way, panels):
    """Which panels begin or end where an open sweep does, in a face of its own: (k, 2) bool."""
    found = np.zeros((len(panels.start), 2), dtype=bool)
    smooth = np.flatnonzero(panels.start < panels.end)
    found[smooth[[0, -1]], [0, 1]] = not way.closed
    found[smooth[[0, -1]], [0, 1]] &= np.array(way.beyond) == 0
    return found


class Faces:
    """The faces across a way.

    Parameters
    ----------
    way : Way
    panels : Panels
    planes : Planes
        Those of the panels.
    cuts : (k, 2, 4) float array
        The planes that cut off each panel at its leg's start and end, 0 where there is none.
    size : float
        Of the whole sweep, in metres.
    """

    def __init__(self, way, panels, planes, cuts, size):
        self.way, self.panels, self.planes, self.cuts, self.size = way, panels, planes, cuts, size

    def cut_off(self, places, panel, parameter):
        """How far places are beyond the planes that cut off their legs or the sweep, negative within: (n,)."""
        beyond = self.beyond_limits(places, parameter)
        cuts = self.cuts[panel] if self.cuts.any() else self.cuts[:0]
        for plane in cuts.swapaxes(0, 1):
            here = np.flatnonzero(plane.any(axis=1))
            beyond[here] = np.maximum(beyond[here], dot(places[here], plane[here, :3]) - plane[here, 3])
        return beyond

    def beyond_limits(self, places, parameter):
        """How far places are beyond the planes that cut off the sweep, negative within: (n,)."""
        beyond = np.full(len(places), -np.inf)
        for limit in self.way.limits:
            here = np.flatnonzero((parameter >= limit.low) & (parameter <= limit.high))
            beyond[here] = np.maximum(beyond[here], dot(places[here] - limit.point, limit.normal))
        return beyond

    def at_ends(self, places, panel, tolerance, faces=(True, True)):
        """Whether hits are on the plane in which an open sweep begins or ends, where it has a face: (n,) bool."""
        found = np.zeros(len(panel), dtype=bool)
        for planes, last, face in zip(self.planes.ends, self.planes.outer.T, faces, strict=True):
            here = np.flatnonzero(last[panel] & face)
            found[here] |= np.abs(off(places[here], planes, panel[here])) <= tolerance
        return found

    @cached_property
    def leaps(self):
        """Before and after which panel the contour turns at once within its plane: the other panel, or -1: (k, 2) int.

        What is in one figure there and not in the other is a face.
        """
        found = np.full((len(self.panels.start), 2), -1)
        smooth = np.flatnonzero(self.panels.start < self.panels.end)
        before, after = (smooth, np.roll(smooth, -1)) if self.way.closed else (smooth[:-1], smooth[1:])
        begin, end = at_both(self.panels.series[:, SPACE])
        leaps = np.abs(begin[after] - end[before]).max(axis=1) > SAME * self.size
        found[before[leaps], 1], found[after[leaps], 0] = after[leaps], before[leaps]
        return np.where(self.cuts.any(axis=2), -1, found)  # a corner cuts off each leg by itself

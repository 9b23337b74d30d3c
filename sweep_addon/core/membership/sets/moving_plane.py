# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Point membership of planar sweeps, by inverse sweeping.

The planes of the contour that pass through a point are found, the point is taken back by the motion into the contour's
own plane, and told from the contour there: the rules of the lecture, and what they leave out (docs/membership.md).

Source
------
Wang, Wang: Geometric modeling for swept volume of moving solids, IEEE CG&A 6(12), 1986; Martin, Stephenson: Sweeping of
three-dimensional objects, Computer-Aided Design 22(4), 1990; the lecture's "PMC algorithm".
"""

from functools import cached_property

import numpy as np

from ...variation.along import NOTHING
from ...vectors import dot, norms
from ..labels import IN, ON, OUT, TOUCHED, joined
from ..motion.corners import with_corners
from ..motion.hash import Boxes, Capsules, portions
from ..motion.panels import derivative, panels, powers
from ..motion.planes import MIDDLE, SCALES, SPACE, Planes, off
from ..motion.reach import chords
from .domes import as_sweep, in_dome
from .faces import SAME, Faces, outer
from .plane_distance import PlaneDistance
from .taken_back import UNCHANGED, TakenBack

LOOKED = 65  # places where it is looked at how large everything is
CHUNK = 1 << 15  # pairs of points and panels, and points, that fit into a processor's cache
FINE = 6  # cells of the lattice in the side of a box
ROOMS = 4  # lattices that are kept: a moving sweep is asked within several tolerances in turn
ROUNDING = 1e-12  # of the size
FOLD = 4.0  # tolerances: what is around a point is looked at not so far out
SOME = 1 << 12  # pairs, for which it is worth knowing whether the sweep meets itself


class MovingPlane:
    """A planar sweep as a set of points.

    Parameters
    ----------
    way : Way

    Attributes
    ----------
    box : (2, 3) float array
        Its least and greatest places, or a little more.
    is_sheet : bool
        Whether it is a surface without an inside, as the contour or an end is open.
    overlaps : bool
        Whether its distance may be too small where that is not much, or 0 within, where it meets itself.
    """

    overlaps = True

    def __init__(self, way):
        self.way, self.region, self.hashes, self.known = way, way.region, {}, {}
        self.is_sheet = way.region.is_open or not (way.closed or all(way.faces))
        looked = way.carried(np.linspace(way.breaks[0], way.breaks[-1], LOOKED))
        self.widest = float(np.abs(looked.scales).max())
        self.reach = float(norms(self.corners).max()) * self.widest
        extent = float(np.abs(looked.middle).max()) + self.reach
        sizes = np.ones(MIDDLE.stop)
        sizes[[3, 7, 11]], sizes[SCALES], sizes[SPACE], sizes[MIDDLE] = extent, self.widest, extent, extent
        pieces = panels(self.channels, way.breaks, way.parts, sizes)
        self.panels, self.cuts, self.legs = with_corners(pieces, way)
        low, high = (side[:, SPACE].reshape(-1, 4, 3) for side in self.panels.bounds)
        self.low, self.high = low.min(axis=1), high.max(axis=1)
        ends = [np.stack((d.middle - d.height - self.reach, d.middle + d.height + self.reach)) for d in way.domes]
        self.box = np.stack((self.low.min(axis=0), self.high.max(axis=0)))
        for low, high in ends:
            self.box = np.stack((np.minimum(self.box[0], low), np.maximum(self.box[1], high)))
        size = float(norms(self.box[1] - self.box[0]))
        self.planes = Planes(self.panels, self.low, self.high, outer(way, self.panels), ROUNDING * size)
        self.faces = Faces(way, self.panels, self.planes, self.cuts, size)
        self.taken_back = TakenBack(self.region, self.panels, self.widest, self.reach)

    @cached_property
    def corners(self):
        """The corners of the box around the contour: (4, 2)."""
        (a, b), (c, d) = self.region.box
        return np.array([(a, b), (c, b), (c, d), (a, d)])

    def channels(self, parameters):
        """All channels at rising parameters: (n, 29)."""
        at = self.way.carried(np.append(self.way.breaks[0], parameters))
        middle, normal, x, y, scales = (part[1:] for part in at)
        axes = np.linalg.inv(np.stack((x, y, normal), axis=1))[..., :2]
        space = middle[:, None] + np.einsum("kc,nc,njc->nkj", self.corners, scales, axes)
        held = [part for axis in (normal, x, y) for part in (axis, dot(axis, middle)[:, None])]
        return np.concatenate((*held, scales, space.reshape(len(parameters), -1), middle), axis=1)

    def hash(self, tolerance):
        """The lattice of what the contour reaches in each panel, with room for a tolerance around it."""
        room = max(1e-6 * norms(self.box[1] - self.box[0]), tolerance)
        found = self.hashes.get(room)
        if found is None:
            start, chord, radius = self.capsules
            found = Boxes.of(self.low - room, self.high + room, FINE, Capsules(start, chord, radius + room))
            self.hashes = {room: found} | dict(list(self.hashes.items())[: ROOMS - 1])
        return found

    @cached_property
    def capsules(self):
        """Chords about which the contour stays in each panel."""
        return chords(self.panels, self.region)

    def labels(self, points, tolerance):
        """IN, ON, OUT, or TOUCHED where a neighbourhood decides, for points (n, 3): (n,) int8."""
        labels = self.swept(points, tolerance)
        for dome in self.way.domes:
            labels = joined(labels, in_dome(dome, self.region, points, tolerance, self.is_sheet))
        labels[self.at_tips(points, tolerance)] = TOUCHED
        return np.where(labels == TOUCHED, ON, labels) if self.is_sheet else labels

    @cached_property
    def tips(self):
        """The ends of an open way that are points: (k, 3). No series follows a law that comes there too steeply."""
        if self.way.closed:
            return np.zeros((0, 3))
        at = self.way.carried(self.way.breaks[[0, -1]])
        return at.middle[np.abs(at.scales).max(axis=1) <= NOTHING * self.widest]

    def at_tips(self, points, tolerance):
        """Whether points (n, 3) are at the tips: (n,) bool."""
        return (norms(points[:, None] - self.tips) <= tolerance).any(axis=1)

    def distance(self, points):
        """How far points (n, 3) are from the boundary, or a fair part of that, negative inside, or less: (n,)."""
        return np.minimum.reduce([part(points) for part in self.distances])

    @cached_property
    def distances(self):
        """What tells the distance of the sweep and of its round ends."""
        domes = [MovingPlane(as_sweep(dome, self.region, self.is_sheet)) for dome in self.way.domes]
        return PlaneDistance(self), *(dome.distance for dome in domes)

    def swept(self, points, tolerance):
        """The labels without the round ends."""
        boxes, labels = self.hash(tolerance), np.full(len(points), OUT, dtype=np.int8)
        cell = boxes.cells(points)
        counts = boxes.counts(cell)
        asked = np.flatnonzero(counts)
        for some in portions(counts[asked], CHUNK):
            which = asked[some]
            labels[which] = self.of_planes(points[which], *boxes.pairs(cell[which]), tolerance)
        return labels

    def of_planes(self, points, point, panel, tolerance):
        """The labels of so few points that all pairs with panels fit into memory, domes left out."""
        if len(point) > max(len(points), SOME) and self.is_clean(tolerance):
            return self.first_found(points, point, panel, tolerance)
        which, x = self.planes.hits(points[point], panel, tolerance)
        point, panel = point[which], panel[which]
        inside, contact = self.sides(points[point], panel, x, tolerance)
        sure = np.zeros(len(points), dtype=bool)
        sure[point[inside]] = True
        labels = np.where(sure, IN, OUT).astype(np.int8)
        some = np.flatnonzero(contact > 0)
        some = some[~sure[point[some]]]
        if len(some):
            contacts = self.contacts(point[some], panel[some], x[some], contact[some], len(points))
            labels[contacts > 0] = np.where(contacts > 1, TOUCHED, ON)[contacts > 0]
        return labels

    def is_thin(self, points, tolerance):
        """Whether a contour that moves on is at points (n, 3) within a tolerance, so that some inside is: (n,) bool."""
        boxes, found = self.hash(tolerance), self.at_tips(points, tolerance)
        point, panel = boxes.pairs(boxes.cells(points))
        which, x = self.planes.hits(points[point], panel, tolerance)
        point, panel = point[which], panel[which]
        inside, contact = self.sides(points[point], panel, x, tolerance)
        moves = np.abs(self.planes.held[panel, :, 1:]).max(axis=(1, 2), initial=0.0) > UNCHANGED
        found[point[moves & (inside | (contact > 0))]] = True
        return found

    def is_clean(self, tolerance):
        """Whether it is known that no two images of a point are in the contour, or within a tolerance of it."""
        if self.is_sheet or not self.way.clean:
            return False
        known = self.known.get(tolerance)
        if known is None:
            known = self.known[tolerance] = bool(self.way.clean(2 * tolerance))
        return known

    def first_found(self, points, point, panel, tolerance):
        """The labels where no two images of a point are in the contour: the search ends with the first that is.

        Each point is asked of one panel, what is left of two more, of four more, and so on.
        """
        labels, most = np.full(len(points), OUT, dtype=np.int8), 1
        while len(point):
            first = np.flatnonzero(np.append(True, point[1:] != point[:-1]))
            rank = np.arange(len(point)) - np.repeat(first, np.diff(np.append(first, len(point))))
            now = np.flatnonzero(rank < most)
            which, x = self.planes.hits(points[point[now]], panel[now], tolerance)
            which = now[which]
            inside, contact = self.sides(points[point[which]], panel[which], x, tolerance)
            labels[point[which[contact > 0]]] = ON
            labels[point[which[inside]]] = IN
            later = np.flatnonzero(rank >= most)
            later = later[labels[point[later]] == OUT]
            point, panel, most = point[later], panel[later], 2 * most
        return labels

    def sides(self, places, panel, x, tolerance):
        """Of hits, which are in the contour, (h,) bool, and which at a boundary: (h,) int8, 2 where others decide."""
        parameter = self.panels.parameter(panel, x)
        depth = self.taken_back.depths(places, panel, x, parameter, tolerance)
        kept = self.faces.cut_off(places, panel, parameter)
        present = (depth <= tolerance) & (kept <= tolerance)
        if self.is_sheet:
            face = self.faces.at_ends(places, panel, tolerance, self.way.faces)
            face |= np.abs(self.faces.beyond_limits(places, parameter)) <= tolerance
            return np.zeros(len(x), dtype=bool), (present & ((depth >= -tolerance) | face)).astype(np.int8)
        edge = self.faces.at_ends(places, panel, tolerance)
        inside = (depth < -tolerance) & (kept < -tolerance) & ~edge
        contact = (present & ~inside).astype(np.int8)
        for side, others in enumerate(self.faces.leaps.T):
            here = np.flatnonzero(inside & (others[panel] >= 0))
            here = here[np.abs(off(places[here], self.planes.ends[side], panel[here])) <= tolerance]
            other, begin = others[panel[here]], np.full(len(here), (1.0, -1.0)[side])
            beyond = self.taken_back.from_region(places[here], other, begin, parameter[here], tolerance) >= -tolerance
            inside[here[beyond]], contact[here[beyond]] = False, 1
        folds = np.flatnonzero(~self.planes.falling[panel] & present)
        folds = folds[self.folded(places[folds], panel[folds], x[folds], tolerance)]
        inside[folds], contact[folds] = False, 2
        return inside, contact

    def folded(self, places, panel, x, tolerance):
        """Whether so near to places the planes turn back that none may pass through some neighbour: (n,) bool."""
        series = self.planes.series(places, panel)
        rate = derivative(series)
        slope, bend = (np.einsum("nj,nj->n", part, powers(x)) for part in (rate, derivative(rate)))
        return slope**2 <= 2 * FOLD * tolerance * (np.abs(bend) + tolerance)

    def contacts(self, point, panel, x, contact, count):
        """On how many boundaries points are, each counted once however many panels tell of it: (count,) int."""
        parameter = self.panels.parameter(panel, x)
        low, high = self.way.breaks[[0, -1]]
        if self.way.closed:
            parameter = np.where(parameter >= high - SAME * (high - low), low, parameter)
        order = np.lexsort((parameter, self.legs[panel], point))
        point, leg, parameter, contact = point[order], self.legs[panel][order], parameter[order], contact[order]
        other = np.append(
            True, (np.diff(point) != 0) | (np.diff(leg) != 0) | (np.diff(parameter) > SAME * (high - low))
        )
        found = np.bincount(point, np.where(other[: len(point)], 1, 0), count).astype(int)
        np.maximum.at(found, point, contact)
        return found

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
from ..motion.panels import PLACES, at_both, derivative, panels, powers, slopes
from ..motion.planes import MIDDLE, NORMAL, SCALES, SPACE, Planes, X, Y, off
from ..motion.reach import chords
from .domes import as_sweep, in_dome
from .plane_distance import PlaneDistance

LOOKED = 65  # places where it is looked at how large everything is
CHUNK = 1 << 15  # pairs of points and panels, and points, that fit into a processor's cache
FINE = 6  # cells of the lattice in the side of a box
ROOMS = 4  # lattices that are kept: a moving sweep is asked within several tolerances in turn
SAME = 1e-9  # of the whole: parameters nearer than this are one
NEAR = 30.0  # tolerances in the contour's plane: nearer to its boundary the distance from the surface is asked for
ROUNDING = 1e-12  # of the size
FOLD = 4.0  # tolerances: what is around a point is looked at not so far out
UNCHANGED = 1e-10  # of its size: what stays so is the same
SOME = 1 << 12  # pairs, for which it is worth knowing whether the sweep meets itself
FAR = 1e150


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
        self.panels, self.cuts, self.legs = with_corners(pieces, way, way.aside + self.reach)
        low, high = (side[:, SPACE].reshape(-1, 4, 3) for side in self.panels.bounds)
        self.low, self.high = low.min(axis=1), high.max(axis=1)
        ends = [np.stack((d.middle - d.height - self.reach, d.middle + d.height + self.reach)) for d in way.domes]
        self.box = np.stack((self.low.min(axis=0), self.high.max(axis=0)))
        for low, high in ends:
            self.box = np.stack((np.minimum(self.box[0], low), np.maximum(self.box[1], high)))
        rounding = ROUNDING * norms(self.box[1] - self.box[0])
        self.planes = Planes(self.panels, self.low, self.high, self.outer, rounding)

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

    def images(self, places, at):
        """Places taken back into the contour's plane, and the same before the scale is: two (n, 2)."""
        raw = np.stack([dot(places, at[:, axis][:, :3]) - at[:, axis][:, 3] for axis in (X, Y)], axis=1)
        return raw / np.where(at[:, SCALES] == 0, 1 / FAR, at[:, SCALES]), raw

    def at(self, panel, x, of=powers, first=X.start):
        """The channels from one on, but those of space: (n, 14), 0 before."""
        made = np.zeros((len(x), SPACE.start))
        made[:, first:] = np.einsum("ncj,nj->nc", self.panels.series[panel, first : SPACE.start], of(x))
        return made

    def sides(self, places, panel, x, tolerance):
        """Of hits, which are in the contour, (h,) bool, and which at a boundary: (h,) int8, 2 where others decide."""
        parameter = self.panels.parameter(panel, x)
        if self.round_ is None:
            depth = self.depths(places, panel, x, parameter, tolerance)
        else:
            depth = norms(places - np.einsum("ncj,nj->nc", self.middles[panel], powers(x))) - self.round_
            near = np.flatnonzero(np.abs(depth) <= NEAR * tolerance)
            if len(near):
                depth[near] = self.depths(places[near], panel[near], x[near], parameter[near], tolerance)
        kept = self.cut_off(places, panel, parameter)
        present = (depth <= tolerance) & (kept <= tolerance)
        if self.is_sheet:
            face = self.at_ends(places, panel, tolerance, self.way.faces)
            face |= np.abs(self.beyond_limits(places, parameter)) <= tolerance
            return np.zeros(len(x), dtype=bool), (present & ((depth >= -tolerance) | face)).astype(np.int8)
        edge = self.at_ends(places, panel, tolerance)
        inside = (depth < -tolerance) & (kept < -tolerance) & ~edge
        contact = (present & ~inside).astype(np.int8)
        for side, others in enumerate(self.leaps.T):
            here = np.flatnonzero(inside & (others[panel] >= 0))
            here = here[np.abs(off(places[here], self.planes.ends[side], panel[here])) <= tolerance]
            other, begin = others[panel[here]], np.full(len(here), (1.0, -1.0)[side])
            beyond = self.depths(places[here], other, begin, parameter[here], tolerance) >= -tolerance
            inside[here[beyond]], contact[here[beyond]] = False, 1
        folds = np.flatnonzero(~self.planes.falling[panel] & present)
        folds = folds[self.folded(places[folds], panel[folds], x[folds], tolerance)]
        inside[folds], contact[folds] = False, 2
        return inside, contact

    def depths(self, places, panel, x, parameter, tolerance):
        """How far images are from the contour's boundary, and near it hits from the surface, negative inside: (n,)."""
        at = self.at(panel, x)
        images, raw = self.images(places, at)
        scales = np.abs(at[:, SCALES])
        depth = self.region.depth(images, parameter) * scales.min(axis=1)
        near = np.flatnonzero(np.abs(depth) <= NEAR * tolerance)
        if len(near):
            depth[near] = self.from_surface(places[near], panel[near], x[near], images[near], parameter[near])
        depth[(norms(raw) <= tolerance) & (scales.max(axis=1) * self.reach <= tolerance * self.widest)] = 0.0  # a tip
        return depth

    @cached_property
    def round_(self):
        """The radius of a round contour that stays as it is, and leans nowhere; None of others."""
        if not self.region.is_round:
            return None
        at = np.einsum("kcj,ij->kic", self.panels.series[:, : SCALES.stop], powers(PLACES))
        scale, axes = at[0, 0, SCALES.start], np.stack([at[..., axis][..., :3] for axis in (NORMAL, X, Y)], axis=-2)
        off = np.abs(np.einsum("kiac,kibc->kiab", axes, axes) - np.eye(3)).max()
        off = max(off, np.abs(at[..., SCALES] / scale - 1).max()) if scale else np.inf
        return abs(scale) * self.region.radius if off <= UNCHANGED else None

    @cached_property
    def middles(self):
        """Where the contour's origin is in each panel: (k, 3, ORDER)."""
        return np.ascontiguousarray(self.panels.series[:, MIDDLE])

    def from_surface(self, places, panel, x, images, parameter):
        """How far hits near the contour's boundary are from the surface, to first order: (n,).

        The surface is where the contour's own distance f of the image Q vanishes. Where the plane passes through a
        point, n . (P - m) = 0, so its place x has the gradient -n / (n . (P - m))', and f that of f_Q Q_P + f' grad x.
        """
        at, rate = (self.at(panel, x, of, first=0) for of in (powers, slopes))
        depth, outward = self.region.exact(images, parameter)
        scales = np.where(at[:, SCALES] == 0, 1 / FAR, at[:, SCALES])
        along = np.stack([dot(places, rate[:, axis][:, :3]) - rate[:, axis][:, 3] for axis in (X, Y)], axis=1)
        moving = dot(outward, (along - images * rate[:, SCALES]) / scales)
        moving += self.region.growth(images, parameter) * (self.panels.end - self.panels.start)[panel] / 2
        turning = dot(places, rate[:, :3]) - rate[:, 3]
        x, y = ((outward / scales)[:, [i]] * at[:, axis][:, :3] for i, axis in enumerate((X, Y)))
        ahead = (moving / np.where(turning == 0, 1 / FAR, turning))[:, None] * at[:, NORMAL][:, :3]
        return depth / np.maximum(norms(x + y - ahead), 1 / FAR)

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

    @cached_property
    def outer(self):
        """Which panels begin or end where an open sweep does, in a face of its own: (k, 2) bool."""
        found = np.zeros((len(self.panels.start), 2), dtype=bool)
        smooth = np.flatnonzero(self.panels.start < self.panels.end)
        found[smooth[[0, -1]], [0, 1]] = not self.way.closed
        found[smooth[[0, -1]], [0, 1]] &= np.array(self.way.beyond) == 0
        return found

    def at_ends(self, places, panel, tolerance, faces=(True, True)):
        """Whether hits are on the plane in which an open sweep begins or ends, where it has a face: (n,) bool."""
        found = np.zeros(len(panel), dtype=bool)
        for planes, outer, face in zip(self.planes.ends, self.outer.T, faces, strict=True):
            here = np.flatnonzero(outer[panel] & face)
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
        leaps = np.abs(begin[after] - end[before]).max(axis=1) > SAME * norms(self.box[1] - self.box[0])
        found[before[leaps], 1], found[after[leaps], 0] = after[leaps], before[leaps]
        return np.where(self.cuts.any(axis=2), -1, found)  # a corner cuts off each leg by itself

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

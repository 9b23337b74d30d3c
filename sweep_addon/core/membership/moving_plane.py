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

from ..vectors import dot, norms
from .corners import with_corners
from .domes import in_dome
from .hash import Boxes, portions
from .labels import IN, ON, OUT, TOUCHED, joined
from .panels import NODES, at_both, derivative, panels, powers, slopes
from .roots import all_roots, simple

NORMAL, X, Y = slice(0, 4), slice(4, 8), slice(8, 12)  # channels: unit vectors, and how far the middle is along them
SCALES, SPACE = slice(12, 14), slice(14, 26)  # of the contour, and the ways of the corners of the box around it
LOOKED = 65  # places where it is looked at how large everything is
CHUNK = 1 << 15  # pairs of points and panels, and points, that fit into a processor's cache
MARGIN = 0.1  # of the steepest slope: what is left of it everywhere
SAME = 1e-9  # of the whole: parameters nearer than this are one
NEAR = 30.0  # tolerances in the contour's plane: nearer to its boundary the distance from the surface is asked for
ROUNDING = 1e-12  # of the size
FOLD = 4.0  # tolerances: what is around a point is looked at not so far out
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
    """

    def __init__(self, way):
        self.way, self.region, self.hashes = way, way.region, {}
        self.is_sheet = way.region.is_open or not (way.closed or all(way.faces))
        looked = way.carried(np.linspace(way.breaks[0], way.breaks[-1], LOOKED))
        self.widest = float(np.abs(looked.scales).max())
        self.reach = float(norms(self.corners).max()) * self.widest
        extent = float(np.abs(looked.middle).max()) + self.reach
        sizes = np.ones(26)
        sizes[[3, 7, 11]], sizes[SCALES], sizes[SPACE] = extent, self.widest, extent
        pieces = panels(self.channels, way.breaks, way.parts, sizes)
        self.panels, self.cuts, self.legs = with_corners(pieces, way, self.reach)
        low, high = (side[:, SPACE].reshape(-1, 4, 3) for side in self.panels.bounds)
        self.low, self.high = low.min(axis=1), high.max(axis=1)
        ends = [np.stack((d.middle - d.height - self.reach, d.middle + d.height + self.reach)) for d in way.domes]
        self.box = np.stack((self.low.min(axis=0), self.high.max(axis=0)))
        for low, high in ends:
            self.box = np.stack((np.minimum(self.box[0], low), np.maximum(self.box[1], high)))

    @cached_property
    def corners(self):
        """The corners of the box around the contour: (4, 2)."""
        (a, b), (c, d) = self.region.box
        return np.array([(a, b), (c, b), (c, d), (a, d)])

    def channels(self, parameters):
        """All channels at rising parameters: (n, 26)."""
        at = self.way.carried(np.append(self.way.breaks[0], parameters))
        middle, normal, x, y, scales = (part[1:] for part in at)
        axes = np.linalg.inv(np.stack((x, y, normal), axis=1))[..., :2]
        space = middle[:, None] + np.einsum("kc,nc,njc->nkj", self.corners, scales, axes)
        held = [part for axis in (normal, x, y) for part in (axis, dot(axis, middle)[:, None])]
        return np.concatenate((*held, scales, space.reshape(len(parameters), -1)), axis=1)

    @cached_property
    def falling(self):
        """Of each panel, whether the plane passes each place that the contour reaches in it once: (k,) bool."""
        series = self.panels.series
        space = np.einsum("kcj,ij->kic", series[:, SPACE], powers(NODES)).reshape(len(series), -1, 3)
        rates = np.einsum("kcj,ij->kic", series[:, NORMAL], slopes(NODES))
        slope = np.einsum("kpj,kij->kpi", space, rates[..., :3]) - rates[:, None, :, 3]
        low, high = slope.min(axis=(1, 2)), slope.max(axis=(1, 2))
        least, most = np.minimum(np.abs(low), np.abs(high)), np.maximum(np.abs(low), np.abs(high))
        return (low * high > 0) & (least > MARGIN * most)

    def passing(self, points, point, panel):
        """The planes that pass through points wherever these are, among pairs: points, panels and places in these."""
        places = points[point]
        begin, end = (off(places, planes, panel) for planes in self.ends)
        room = ROUNDING * norms(self.box[1] - self.box[0])
        kept = (np.minimum(begin, end) <= room) & (np.maximum(begin, end) >= -room) | self.turning_back(places, panel)
        point, panel = point[kept], panel[kept]
        series = self.series(places[kept], panel)
        monotone, x = simple(series)
        chosen = np.flatnonzero(monotone & (np.abs(x) <= 1 + SAME))
        which, at = all_roots(series[~monotone], 0.0)
        others = np.flatnonzero(~monotone)[which]
        index = np.concatenate((chosen, others))
        return point[index], panel[index], np.concatenate((np.clip(x[chosen], -1.0, 1.0), at))

    def hash(self, tolerance):
        """The lattice of the panels' boxes, with room for a tolerance around them."""
        room = max(1e-6 * norms(self.box[1] - self.box[0]), tolerance)
        if room not in self.hashes:
            self.hashes = {room: Boxes.of(self.low - room, self.high + room)} | dict(list(self.hashes.items())[:1])
        return self.hashes[room]

    @cached_property
    def ends(self):
        """The planes at the start and at the end of each panel: two (k, 4)."""
        return at_both(self.panels.series[:, NORMAL])

    @cached_property
    def rates(self):
        """How these change there: two (k, 4)."""
        return at_both(derivative(self.panels.series[:, NORMAL]))

    def labels(self, points, tolerance):
        """IN, ON, OUT, or TOUCHED where a neighbourhood decides, for points (n, 3): (n,) int8."""
        boxes, labels = self.hash(tolerance), np.full(len(points), OUT, dtype=np.int8)
        cell = boxes.cells(points)
        counts = boxes.counts(cell)
        asked = np.flatnonzero(counts)
        for some in portions(counts[asked], CHUNK):
            which = asked[some]
            labels[which] = self.of_planes(points[which], cell[which], tolerance)
        for dome in self.way.domes:
            labels = joined(labels, in_dome(dome, self.region, points, tolerance, self.is_sheet))
        return np.where(labels == TOUCHED, ON, labels) if self.is_sheet else labels

    def of_planes(self, points, cell, tolerance):
        """The labels of so few points that all pairs with panels fit into memory, domes left out."""
        point, panel, x = self.hits(points, *self.hash(tolerance).pairs(cell), tolerance)
        inside, contact = self.sides(points[point], panel, x, tolerance)
        sure = np.zeros(len(points), dtype=bool)
        sure[point[inside]] = True
        some = np.flatnonzero((contact > 0) & ~sure[point])
        contacts = self.contacts(point[some], panel[some], x[some], contact[some], len(points))
        return np.where(sure, IN, np.choose(np.minimum(contacts, 2), (OUT, ON, TOUCHED))).astype(np.int8)

    def hits(self, points, point, panel, tolerance):
        """The planes that pass through points, among pairs with panels: points, panels and places in these, (h,)."""
        places, falling = points[point], self.falling[panel]
        begin, end = (off(places, planes, panel) for planes in self.ends)
        kept = (np.minimum(begin, end) <= tolerance) & (np.maximum(begin, end) >= -tolerance)
        some = np.flatnonzero(~(kept | falling))  # where the planes turn back they may come by twice
        kept[some] = self.turning_back(places[some], panel[some])
        point, panel, places, falling = point[kept], panel[kept], places[kept], falling[kept]
        series, ends = self.series(places, panel), (np.abs(begin[kept]), np.abs(end[kept]))
        monotone, x = simple(series)
        end = (x > 0).astype(int)
        within = (np.abs(x) <= 1 + SAME) | (np.choose(end, ends) <= tolerance) & self.outer[panel, end]
        chosen = np.flatnonzero((monotone | falling) & within)
        found = point[chosen], panel[chosen], np.clip(x[chosen], -1.0, 1.0)
        others = np.flatnonzero(~(monotone | falling))
        others = others[self.reached(places[others], panel[others], tolerance)]
        if not len(others):
            return found
        which, at = all_roots(series[others], tolerance)
        more = point[others[which]], panel[others[which]], at
        return tuple(np.concatenate(pair) for pair in zip(found, more, strict=True))

    def turning_back(self, places, panel):
        """Whether the distance of places from the plane first grows and then falls, or the other way: (n,) bool."""
        begin, end = (off(places, planes, panel) for planes in self.rates)
        return begin * end <= 0

    def reached(self, places, panel, tolerance):
        """Whether places are in the boxes of panels: (n,) bool."""
        return ((places >= self.low[panel] - tolerance) & (places <= self.high[panel] + tolerance)).all(axis=1)

    def series(self, places, panel, channels=NORMAL):
        """How far places (n, 3) are from the plane, or along another channel, as series in panels: (n, ORDER)."""
        held = self.panels.series[panel, channels]
        made = np.einsum("ni,nij->nj", places, held[:, :3])
        made -= held[:, 3]
        return made

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
        at, parameter = self.at(panel, x), self.panels.parameter(panel, x)
        images, raw = self.images(places, at)
        scales = np.abs(at[:, SCALES])
        depth = self.region.depth(images, parameter) * scales.min(axis=1)
        near = np.flatnonzero(np.abs(depth) <= NEAR * tolerance)
        if len(near):
            depth[near] = self.distance(places[near], panel[near], x[near], images[near], parameter[near])
        depth[(norms(raw) <= tolerance) & (scales.max(axis=1) * self.reach <= tolerance * self.widest)] = 0.0  # a tip
        kept = self.cut_off(places, panel, parameter)
        present = (depth <= tolerance) & (kept <= tolerance)
        if self.is_sheet:
            face = self.at_ends(places, panel, x, tolerance, self.way.faces)
            face |= np.abs(self.beyond_limits(places, parameter)) <= tolerance
            return np.zeros(len(x), dtype=bool), (present & ((depth >= -tolerance) | face)).astype(np.int8)
        edge = self.at_ends(places, panel, x, tolerance)
        inside = (depth < -tolerance) & (kept < -tolerance) & ~edge
        contact = (present & ~inside).astype(np.int8)
        folds = np.flatnonzero(~self.falling[panel] & present)
        folds = folds[self.folded(places[folds], panel[folds], x[folds], tolerance)]
        inside[folds], contact[folds] = False, 2
        return inside, contact

    def distance(self, places, panel, x, images, parameter):
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
        cuts = self.cuts[panel]
        for plane in cuts.swapaxes(0, 1):
            here = np.flatnonzero(plane.any(axis=1))
            beyond[here] = np.maximum(beyond[here], dot(places[here], plane[here, :3]) - plane[here, 3])
        return beyond

    def beyond_limits(self, places, parameter):
        """How far places are beyond the planes that cut off the sweep, negative within: (n,)."""
        beyond = np.full(len(places), -np.inf)
        for limit in self.way.limits:
            here = np.flatnonzero((parameter >= limit.low) & (parameter <= limit.high))
            beyond[here] = np.maximum(beyond[here], (places[here] - limit.point) @ limit.normal)
        return beyond

    @cached_property
    def outer(self):
        """Which panels begin or end where an open sweep does, in a face of its own: (k, 2) bool."""
        found = np.zeros((len(self.panels.start), 2), dtype=bool)
        smooth = np.flatnonzero(self.panels.start < self.panels.end)
        found[smooth[[0, -1]], [0, 1]] = not self.way.closed
        found[smooth[[0, -1]], [0, 1]] &= np.array(self.way.beyond) == 0
        return found

    def at_ends(self, places, panel, x, tolerance, faces=(True, True)):
        """Whether hits are on the plane in which an open sweep begins or ends, where it has a face: (n,) bool."""
        found = np.zeros(len(x), dtype=bool)
        for planes, outer, face in zip(self.ends, self.outer.T, faces, strict=True):
            here = np.flatnonzero(outer[panel] & face)
            found[here] |= np.abs(off(places[here], planes, panel[here])) <= tolerance
        return found

    def folded(self, places, panel, x, tolerance):
        """Whether so near to places the planes turn back that none may pass through some neighbour: (n,) bool."""
        series = self.series(places, panel)
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


def off(places, planes, panel):
    """How far places (n, 3) are from planes, one of (k, 4) each: (n,)."""
    return dot(places, planes[panel, :3]) - planes[panel, 3]

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far points are from a planar sweep: the least of the distances from the contour as it stands on its way.

Outside that is the distance from the flat figures. Inside, the boundary is a part of what the contours sweep, of the
faces at the ends, of the planes that cut the sweep off, and of the lines about which a plane turns back within the
figure. Where a sweep meets itself or touches the axis that it turns about, some of that lies within: then a point is
deeper than is told.
"""

from functools import cached_property

import numpy as np

from ...vectors import dot, norms
from ..labels import IN, decided
from ..motion.panels import PLACES, at_both, derivative, parted, powers
from ..motion.planes import NORMAL, SCALES, SPACE, X, Y
from ..motion.reach import chords, speeds
from ..motion.roots import real
from ..plane.loops import Loops
from ..plane.one_by_one import nearest_of
from .least import Along
from .pairs import ALIKE, AS_IT_IS, LEANING, SCALED, Look, Pairs

STRIDE, MOST = 0.5, 8  # of what the contour reaches: how far it moves in half a part of a panel, of so many at most
ROOM = 1.1  # for what moves faster between the places that are looked at
JUMP = 1e-6  # of a rate: what changes more at once jumps
UPRIGHT = 1e-9  # what counts as no angle between axes, and as the same scale


class PlaneDistance:
    """The distance of a `MovingPlane`, its round ends left out.

    Parameters
    ----------
    plane : MovingPlane
    """

    def __init__(self, plane):
        self.plane, self.region = plane, plane.region
        self.tolerance = 1e-9 * float(norms(plane.box[1] - plane.box[0]))
        counts = np.clip(np.ceil(speeds(plane.panels) / (STRIDE * plane.reach)), 1, MOST).astype(int)
        self.panels, own = parted(plane.panels, counts)
        self.series, self.cuts = self.panels.series, plane.cuts[own]
        parallel, about_lines = self.turning()
        self.folding = ~plane.planes.falling[own] & ~about_lines
        last = np.cumsum(counts) - 1
        self.smooth = int((self.panels.start < self.panels.end).sum())  # those beyond corners come last
        begins, ends = (last - counts + 1)[plane.planes.outer[:, 0]], last[plane.planes.outer[:, 1]]
        self.faces = [*((panel, -1.0) for panel in begins), *((panel, 1.0) for panel in ends)]
        self.faces += [(int(panel), x) for panel, x in self.turned_back(plane.planes.falling[own], parallel)]
        self.is_cut, self.is_folded = bool(self.cuts.any()), bool(self.folding.any())
        self.frames = self.series[:, : SCALES.stop if self.kind else SCALES.start] @ powers(np.zeros(1))[0]
        gaps = ROOM * speeds(self.panels)
        gaps += plane.widest * self.region.change(self.panels.parameter, len(gaps), PLACES)
        whole = ~self.cuts.any(axis=(1, 2)) & (not plane.way.limits)
        self.along = Along(*chords(self.panels, self.region), whole)
        self.gaps = gaps, np.where(self.folding, np.inf, gaps)

    def __call__(self, points):
        """How far points (n, 3) are from the sweep, or less; negative inside, or less deep: (n,)."""
        inside = np.zeros(len(points), dtype=bool)

        def near(some):
            if self.plane.is_sheet:
                inside[some] = True
            else:
                labels = self.plane.swept(points[some], self.tolerance)
                labels = decided(labels, points[some], self.tolerance, Undomed(self.plane))
                inside[some] = labels == IN
            return Look(self, points[some], inside[some])

        found = self.along.least(points, near)
        if self.plane.is_sheet:
            return found
        if inside.any():
            found[inside] = -np.minimum(found[inside], self.from_faces(points[inside]))
        return found

    def unsigned(self, points, inside):
        """How far points (n, 3) are from the contours where they are inside, or the figures, or less: (n,)."""
        return self.along.least(points, lambda some: Look(self, points[some], inside[some]))

    def in_figure(self, points, panel, x):
        """How far points (n, 3) are from the contour, with what is in it, at a place of a panel: (n,)."""
        pairs = Pairs.of(self, points, np.zeros(len(points), dtype=bool), np.full(len(points), panel))
        return pairs.at(np.full(len(points), float(x)))

    def from_faces(self, points):
        """How far points (n, 3) within are from flat faces and the planes that cut the sweep off: (n,)."""
        least = np.full(len(points), np.inf)
        for limit in self.plane.way.limits:
            least = np.minimum(least, np.abs(dot(points - limit.point, limit.normal)))
        for panel, x in self.faces:
            least = np.minimum(least, self.in_figure(points, panel, x))
        return least

    def turning(self):
        """In which panels all planes are parallel, and in which they have a line in common or are: two (k,) bool.

        Such a line is all that they turn back in.
        """
        planes = self.series[:, NORMAL] / np.array([1.0, 1.0, 1.0, np.abs(self.plane.box).max()])[:, None]
        parallel = np.abs(planes[:, :3, 1:]).sum(axis=(1, 2)) <= UPRIGHT
        return parallel, np.linalg.svd(planes, compute_uv=False)[:, 2] <= UPRIGHT

    def turned_back(self, falling, parallel):
        """Where planes turn back with all of the figure, so that it is a boundary: panels and places in them, (p, 2).

        That is so of parallel planes, and where the motion jumps.
        """
        panel = np.flatnonzero(parallel & ~falling)
        which, x = real(derivative(self.series[panel, NORMAL.stop - 1]))
        within = np.stack((panel[which], x), axis=1)
        after = np.append(np.arange(1, self.smooth), 0 if self.plane.way.closed else self.smooth - 1)
        space = at_both(self.series[: self.smooth, SPACE])[1].reshape(-1, 4, 3)
        lengths = (self.panels.end - self.panels.start)[: self.smooth, None]
        begin, end = (part / lengths for part in at_both(derivative(self.series[: self.smooth, NORMAL])))
        arrive, leave = (dot(space, rate[:, None, :3]) - rate[:, None, 3] for rate in (end, begin[after]))
        jumps = np.abs(arrive - leave).max(axis=1) > JUMP * np.abs(np.stack((arrive, leave))).max(axis=(0, 2))
        back = np.flatnonzero(jumps & (arrive * leave <= 0).any(axis=1) & ~self.cuts[: self.smooth].any(axis=(1, 2)))
        return np.concatenate((within, np.stack((back, np.ones(len(back))), axis=1)))

    @cached_property
    def skin(self):
        """The edges of the contour but those that stay where they are, as on an axis: None where all move.

        What they sweep are lines, which are no boundary but that of faces at the ends.
        """
        loops = getattr(self.region, "region", None)
        if not isinstance(loops, Loops) or self.kind > ALIKE:
            return None
        basis = powers(PLACES).T
        normal, x, y = ((self.series[:, axis] @ basis).swapaxes(1, 2).reshape(-1, 4) for axis in (NORMAL, X, Y))
        scales = (self.series[:, SCALES] @ basis).swapaxes(1, 2).reshape(-1, 2)
        back = np.linalg.inv(np.stack((normal[:, :3], x[:, :3], y[:, :3]), axis=1))
        rest = ~loops.arcs
        for ends in (loops.start, loops.end):
            images = ends[:, None] * scales
            planes = np.stack(
                np.broadcast_arrays(normal[:, 3], images[..., 0] + x[:, 3], images[..., 1] + y[:, 3]), axis=-1
            )
            places = np.einsum("nij,mnj->mni", back, planes)
            rest &= np.ptp(places, axis=1).max(axis=1) <= self.tolerance
        return Skin(loops, ~rest) if rest.any() else None

    @cached_property
    def kind(self):
        """How the figure stands: as it is, scaled alike along all directions, scaled, or leaning."""
        basis = powers(PLACES).T
        normal, x, y = ((self.series[:, axis][:, :3] @ basis).swapaxes(1, 2) for axis in (NORMAL, X, Y))
        scales = self.series[:, SCALES] @ basis
        off = [np.abs(dot(a, b) - (a is b)).max() for a, b in ((x, x), (y, y), (x, y))]
        if max(off) > UPRIGHT:
            return LEANING
        if np.abs(np.diff(np.abs(scales), axis=1)).max() > UPRIGHT * self.plane.widest:
            return SCALED
        return AS_IT_IS if np.abs(scales - 1).max() <= UPRIGHT else ALIKE


class Skin:
    """Some edges of loops."""

    def __init__(self, loops, kept):
        self.loops, self.kept = loops, kept

    def distance(self, points, parameters):
        """How far points (n, 2) are from the nearest of these: (n,)."""
        return nearest_of(self.loops, *points.T, kept=self.kept)


class Undomed:
    """The plane without its round ends, for the neighbourhoods of points."""

    def __init__(self, plane):
        self.labels = plane.swept

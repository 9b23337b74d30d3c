# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Points taken back by the motion of a contour into its own plane, and how far they are from its boundary there."""

from functools import cached_property

import numpy as np

from ...vectors import dot, norms
from ..motion.panels import PLACES, powers, slopes
from ..motion.planes import MIDDLE, NORMAL, SCALES, SPACE, X, Y

NEAR = 30.0  # tolerances in the contour's plane: nearer to its boundary the distance from the surface is asked for
UNCHANGED = 1e-10  # of its size: what stays so is the same
FAR = 1e150


class TakenBack:
    """What the planes of panels that pass through places tell of them: where these are in the contour's own plane.

    Parameters
    ----------
    region : Loops, Disc, ...
        Of the contour's plane.
    panels : Panels
    widest : float
        The largest scale of the contour.
    reach : float
        How far it then gets from its origin, in metres.
    """

    def __init__(self, region, panels, widest, reach):
        self.region, self.panels, self.widest, self.reach = region, panels, widest, reach

    def images(self, places, at):
        """Places taken back into the contour's plane, and the same before the scale is: two (n, 2)."""
        raw = np.stack([dot(places, at[:, axis][:, :3]) - at[:, axis][:, 3] for axis in (X, Y)], axis=1)
        return raw / np.where(at[:, SCALES] == 0, 1 / FAR, at[:, SCALES]), raw

    def at(self, panel, x, of=powers, first=X.start):
        """The channels from one on, but those of space: (n, 14), 0 before."""
        made = np.zeros((len(x), SPACE.start))
        made[:, first:] = np.einsum("ncj,nj->nc", self.panels.series[panel, first : SPACE.start], of(x))
        return made

    def from_region(self, places, panel, x, parameter, tolerance):
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

    def depths(self, places, panel, x, parameter, tolerance):
        """The same, of a round contour that stays as it is by how far its middle is where that is not near: (n,)."""
        if self.round_ is None:
            return self.from_region(places, panel, x, parameter, tolerance)
        depth = norms(places - np.einsum("ncj,nj->nc", self.middles[panel], powers(x))) - self.round_
        near = np.flatnonzero(np.abs(depth) <= NEAR * tolerance)
        if len(near):
            depth[near] = self.from_region(places[near], panel[near], x[near], parameter[near], tolerance)
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

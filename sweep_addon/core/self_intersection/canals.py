# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Self-intersection of canal surfaces: circles that run backward on their balls, and stretches that meet."""

from functools import lru_cache

import numpy as np

from ..contours import Circle
from ..envelopes.envelope import Envelope, backward, turned
from ..grids.grid import Grid
from ..rings.ends import Flat, Open
from ..shapes.generalized_cylinder import GeneralizedCylinder
from ..stations.cells import bend
from ..vectors import norms
from .cylinders import of_cylinder
from .detect import ENOUGH, LESS, meeting, meetings
from .lattice import Lattice
from .local import Local
from .places import Place, Places

BISECTIONS = 16  # a hundred-thousandth of the size is left, or two


@lru_cache(maxsize=16)
def of_canal(shape):
    """The places where a canal surface meets itself: `Places`.

    One of balls of one size without round ends is a round tube, and decided as such.
    """
    envelope = Envelope(shape)
    if envelope.balls.is_constant and not (shape.is_plane or any(shape.round_ends) and not envelope.closed):
        start, end = (Flat() if flat else Open() for flat in shape.flat_ends)
        contour = Circle(envelope.balls.largest, shape.points)
        if not len(envelope.stations.corners):
            return of_cylinder(GeneralizedCylinder(contour, shape.trajectory, shape.samples, start=start, end=end))
    local = Folds(envelope.balls, envelope.stations)
    folds, turns = local.folds(), [(u, u) for u in envelope.circles.turning_back]
    lattice = lattice_of(envelope)
    places = [*map(local.place, folds), *map(local.corner, turns), *meetings(lattice, [*folds, *turns])]

    def safe():
        limit = 0.0 if turns else local.least_factor()
        return largest(shape, lattice, limit, not places) if limit else limit

    return Places(places, safe, "radii")


def largest(shape, lattice, limit, known):
    """The factor of the radius up to which it is clean, by bisection: circles of each size stand elsewhere.

    Parameters
    ----------
    shape : CanalSurface
    lattice : Lattice
        Of its present size.
    limit : float
        The factor at which it folds.
    known : bool
        Whether it is clean as it is.
    """

    def clean(factor):
        looked_at = lattice_of(Envelope(shape, factor))
        while thinner := looked_at.coarser(ENOUGH):
            looked_at = thinner
        return not meeting(looked_at)

    low, high = (1.0, 1.0) if known else (0.0, min(1.0, limit))
    most = min(limit, 2 * lattice.size / max(lattice.radii.max(), 1e-300))
    while known and high < most:  # a little more is looked at first: the more overlaps the longer it takes
        low, high = high, min(2 * high, most)
        if not clean(high * LESS):
            break
        if high == most:
            return limit
    if not known and limit < 1 and clean(high * LESS):
        return limit
    for _ in range(BISECTIONS if high > low else 0):
        middle = (low + high) / 2
        low, high = (middle, high) if clean(middle) else (low, middle)
    return low


class Folds(Local):
    """Where the circles of balls run backward."""

    def __init__(self, balls, stations):
        super().__init__(stations, None, None, balls.largest)
        self.balls = balls

    @property
    def curved(self):
        """Whether any circle may run backward."""
        return not self.balls.is_constant or super().curved

    def folding(self, s):
        u = self.measure.parameter(s)
        return self.balls.folding(u, s, norms(bend(self.trajectory, u)))

    def safe_factors(self, s):
        """By what factor the radius may be multiplied: the least root of the same, which is a square in its square."""
        u = self.measure.parameter(s)
        radius, (slope, change) = self.balls.radius(u, s), self.balls.slopes(u, s)
        bent, grown = (radius * norms(bend(self.trajectory, u))) ** 2, radius * change
        root = 2 * (slope**2 + grown) + bent + np.sqrt(np.maximum(bent * (4 * grown + bent), 0.0))
        real = np.isfinite(slope) & (root > 0) & (bent * (4 * grown + bent) >= 0)
        return np.sqrt(np.divide(2.0, root, out=np.full(len(root), np.inf), where=real))

    def place(self, ends):
        found = super().place(ends)
        return Place("local", found.parameters, found.point, backward(*ends, self.trajectory.domain))

    def corner(self, ends):
        """The place of a corner."""
        point = self.trajectory.evaluate(np.array(ends[:1]))[0]
        return Place("local", (ends,), tuple(point.tolist()), turned(ends[0], self.trajectory.domain))


def lattice_of(envelope):
    """The lattice of all circles, those that are points among them."""
    found, (e2, e3), section = envelope.circles, envelope.sides, envelope.section
    centres, sizes = found.centres, found.sizes
    grid = Grid(
        rings=len(sizes),
        tips=tuple(np.flatnonzero(sizes == 0).tolist()),
        closed=envelope.closed,
        creases=(),
        offsets=tuple(section.offsets.tolist()),
        sharp=(),
        caps=(None, None),
        gaps=tuple(section.gaps.tolist()),
    )
    x, y = section.points.T[:, :, None]

    def at(asked):
        wide = sizes[asked][..., None]
        turned = np.multiply.outer(x[:, 0], wide * e2[asked]) + np.multiply.outer(y[:, 0], wide * e3[asked])
        return centres[asked] + turned

    end = envelope.trajectory.domain[1]
    return Lattice.of(grid, at, centres, centres, found.axis, sizes, found.u, end)

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sets of points that lie in the plane z = 0: sweeps of contours within their plane, and what discs visit there."""

import numpy as np

from ...contours import Mixed
from ...declared.options import Side
from ...declared.parameters import require
from ..labels import ON, OUT
from ..plane.loops import Loops
from ..plane.regions import curved, of_sections, region
from ..plane.strands import Strands
from ..plane.swathes import RoundSwathe, Swathe

STILL = np.zeros(2)
CORNERS = np.array([(-1, -1), (-1, 1), (1, -1), (1, 1)])
SQUARES, HALVINGS, MOST = 9, 24, 1 << 14  # a side at first, where it is looked what is left; and squares at most


class Flat:
    """A figure of the plane, which points are on or out of.

    Parameters
    ----------
    figure : Swathe, RoundSwathe or Band
        With ``far(points, tolerance)`` and a ``box`` in the plane.
    """

    is_sheet, overlaps = True, False

    def __init__(self, figure):
        self.figure, self.box = figure, np.column_stack((figure.box, np.zeros(2)))

    def labels(self, points, tolerance):
        """ON or OUT for points (n, 3): (n,) int8."""
        labels, (low, high) = np.full(len(points), OUT, dtype=np.int8), self.box
        near = np.flatnonzero(((points >= low - tolerance) & (points <= high + tolerance)).all(axis=1))
        far = np.hypot(self.figure.far(points[near, :2], tolerance), points[near, 2])
        labels[near[far <= tolerance]] = ON
        return labels


class Band:
    """What of the plane is within a distance of the boundary of an area, or of the area, or in it but farther.

    Parameters
    ----------
    area : Disc, Superdisc or Loops
    radius : float
        In metres.
    side : Side
    """

    def __init__(self, area, radius, side):
        self.area, self.radius, self.side = area, radius, side
        out = 0.0 if side is Side.INSIDE else radius
        self.box = area.box + np.array([[-out], [out]])
        self.edges = Swathe(area, None, STILL, STILL) if isinstance(area, Loops) else None

    def far(self, points, tolerance):
        """How far points (n, 2) are from it, or less beside an edge of what is inside, 0 within: (n,)."""
        inside, far = self.asked(points, tolerance)
        if self.side is Side.INSIDE:
            return np.where(inside, np.maximum(self.radius - far, 0.0), self.radius + far)
        within = inside & (self.side is Side.OUTSIDE)
        return np.where(within, 0.0, np.maximum(far - self.radius, 0.0))

    def asked(self, points, tolerance):
        """Whether points (n, 2) are in the area, and how far they are from its boundary.

        Of what differs from the radius by more than the tolerance it need only be told whether it is more or less.
        """
        if self.edges is None:
            depth = self.area.distance(*points.T)
            return depth < 0, np.abs(depth)
        return self.area.depth(points) < 0, self.edges.lattice(self.radius, tolerance).least(self.edges.apart, points)

    def is_nothing(self):
        """Whether surely no place of the area is as deep as the radius: squares that may have one are cut in four."""
        low, high = self.area.box
        step, place = (high - low) / SQUARES, np.arange(SQUARES) + 0.5
        middles = low + step * np.stack(np.meshgrid(place, place), axis=-1).reshape(-1, 2)
        for _ in range(HALVINGS):
            inside, far = self.asked(middles, self.radius)
            if (inside & (far >= self.radius)).any():
                return False
            deepest = np.where(inside, far, 0.0) + np.hypot(*step) / 2
            middles, step = middles[deepest >= self.radius], step / 2
            if not len(middles):
                return True
            if len(middles) > MOST:
                break
            middles = (middles[:, None] + step / 2 * CORNERS).reshape(-1, 2)
        return False


def swept(contour, start, end):
    """What a contour visits whose origin moves along a segment of its plane: a `Flat`.

    Parameters
    ----------
    contour : Contour or Mixed
    start, end : (2,) float array
    """
    area, strands = parts(contour)
    if not isinstance(area, Loops | None):
        return Flat(RoundSwathe(area, start, end))
    edges = [part for part in (area, strands) if part]
    begun, ended, bulges = (
        np.concatenate(part) for part in zip(*((e.start, e.end, e.bulges) for e in edges), strict=True)
    )
    return Flat(Swathe(Loops(begun, ended, bulges, np.arange(len(bulges))), area, start, end))


def parts(contour):
    """The area of a contour, and its lines and arcs that bound none, as `Loops`; None where there is none."""
    if isinstance(contour, Mixed):
        sections = contour.sections()
        areas, lines = ([s for s in sections if s.closed is closed] for closed in (True, False))
        return of_sections(areas) if areas else None, Strands.of_sections(lines).edges if lines else None
    found = region(contour)
    return (None, found.edges) if isinstance(found, Strands) else (found, None)


def banded(contour, radius, side):
    """What a disc visits that moves along the boundary of a closed contour, on a side where anything is: a `Flat`."""
    band = Band(curved(contour), radius, side)
    left = side is not Side.INSIDE or not band.is_nothing()
    require(left, "must leave something of the area inside", radius, "radius")
    return Flat(band)

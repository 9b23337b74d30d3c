# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Self-intersection of generalized cylinders: what the tests ask of a shape, and what they find, put together."""

from functools import lru_cache

import numpy as np

from ..contours import Circle, Fit, fitted
from ..contours.section import section_of
from ..declared.parameters import Array
from ..rings.bevels import bevels
from ..rings.ends import Flat, Open
from ..rings.mitres import legs
from ..stations.cells import bend, cut
from ..stations.frames import axes
from ..stations.sampling import lengths, standing
from ..trajectories.arc_length import arc_length
from ..vectors import dot, norms
from .detect import met, together
from .folds import between, short_legs
from .lattice import WIDEST, Lattice
from .local import Local, folded
from .places import Place, Places
from .thickness import thickest

ROUNDING = 1e-9  # of the radius: less is no crossing


@lru_cache(maxsize=16)
def of_cylinder(shape):
    """The places where a generalized cylinder meets itself: `Places`."""
    unit = "radius" if isinstance(shape.contour, Circle) and not shape.morph else "scale"
    size = shape.contour.radius if unit == "radius" else 1.0
    along = laws(shape)
    radius = round_radius(shape, along)
    if not radius:
        return places_of(shape, size, unit)
    best = thickest(along.trajectory)

    def places():
        return places_of(shape, size, unit, along, radius).places or [nearest(along.trajectory, best)]

    clean = best.radius >= radius * (1 - ROUNDING)
    return Places(() if clean else places, lambda: size * best.radius / radius, unit, at_once=True)


def places_of(shape, size, unit, tube=None, radius=0.0):
    """The places as the local test and the triangles tell of them: `Places`.

    A round tube, whose laws and radius are given, is known to meet itself: its rings are looked at as far apart as the
    points of its contour are, which the mesh is as far from the true shape between as between closer ones. No others
    are laid out.
    """
    if tube:
        section = section_of(shape.contour, shape.fit)
        s = lengths(tube.trajectory, shape.samples, *tube.asks(norms(section.points).max()))
        kept = spaced(tube.trajectory, s, section.edge_lengths.max() * radius / size)
    swept = shape.swept(standing(tube.trajectory, Array(s[kept])) if tube else None)
    change = swept.along.change
    farthest = swept.along.farthest(float(norms(change.points if change else swept.body.section.points).max()))
    reaching = change.support if change else support(shape.contour)
    local = Local(swept.stations, carried(shape, swept), reaching, farthest)
    lattice = lattice_of(swept)
    if tube:
        local.grid = local.measure.at(cut(local.measure))
        lattice = lattice.numbered(kept, len(s))
    return together(lattice, local, Legs(swept, lattice), size, unit)


def spaced(trajectory, s, step):
    """Which of the stations of a smooth trajectory are that many metres apart, or turn as thinned rings may: (k,) int.

    Parameters
    ----------
    trajectory : Trajectory
    s : (n,) float array
        The arc lengths of all stations; the first and the last are kept.
    step : float

    It is told how much the trajectory turns by the cells in which its folds are looked for, not by all stations.
    """
    measure = arc_length(trajectory)
    cells = cut(measure)
    turns = norms(np.diff(trajectory.tangents(cells), axis=0))
    turned = np.interp(s, measure.at(cells), np.concatenate(([0.0], np.cumsum(turns))))
    passed = np.floor(s / step) + np.floor(turned * (2 / WIDEST))
    return np.flatnonzero(np.concatenate(([True], np.diff(passed[:-1]) > 0, [True])))


def laws(shape):
    """The laws of a generalized cylinder, before anything is laid out along them: `Along`."""
    ends = (Flat(), Flat()) if shape.trajectory.closed else (shape.start, shape.end)
    return shape.laid_out(*shape.moving(), ends)[0]


def carried(shape, swept):
    """A function from stations to what the local test asks: curvature vectors, way off the trajectory, and axes."""

    def at(stations):
        scale_x, scale_y, twist, offset_x, offset_y = swept.along.at(stations.s, stations.u)
        e2, e3, _ = axes(swept.along.rails or shape.frame, stations, twist, swept.symmetry)
        aside, x, y = e2 * offset_x[:, None] + e3 * offset_y[:, None], e2 * scale_x[:, None], e3 * scale_y[:, None]
        if swept.along.change:
            x, y = (swept.along.change.weighted(axis, stations.t) for axis in (x, y))
        return bend(stations.trajectory, stations.u), aside, x, y

    return at


def round_radius(shape, along):
    """The radius of a round tube along a smooth trajectory whose reach says it all; 0 for any other shape."""
    tube = isinstance(shape.contour, Circle) and not along.trajectory.carries and not any(along.tapers)
    if (
        along.change
        or not tube
        or not (shape.trajectory.closed or all(isinstance(end, Flat | Open) for end in (shape.start, shape.end)))
    ):
        return 0.0
    scale_x, scale_y, _, *offset = along.everywhere()
    sizes = np.abs(np.concatenate((scale_x, scale_y)))
    if np.ptp(sizes) > ROUNDING * sizes.max() or np.any(offset) or len(along.trajectory.corners()):
        return 0.0
    return float(shape.contour.radius * sizes.max())


def nearest(trajectory, best):
    """The place of a tube that is hardly too thick: where its reach says."""
    u = np.array(best.parameters)
    point = trajectory.evaluate(u).mean(axis=0)
    if len(u) == 1:
        return folded(*u, *u, point, trajectory.domain)
    return met([(float(x), float(x)) for x in u], point, trajectory.domain)


def lattice_of(swept):
    """The lattice of a sweep."""
    grid, chart, rings = swept.chart.grid, swept.chart, swept.rings
    weights = np.column_stack((np.ones(len(swept.shape)), swept.shape))
    stations, (before, after) = swept.stations, grid.domes
    path, middles = rings[0].copy(), rings[0].copy()
    path[before : len(path) - after] = stations.points
    middles[:before], middles[len(path) - after :] = middles[before], middles[len(path) - after - 1]
    normals = np.concatenate((
        np.repeat(stations.tangent[:1], before, axis=0), stations.tangent,
        np.repeat(stations.tangent[-1:], after, axis=0)))  # fmt: skip
    stretched = np.linalg.norm(rings[1:], axis=(0, 2)) if len(rings) > 3 else widest(*rings[1:])
    radii = norms(rings[0] - path) + norms(swept.shape).max() * stretched

    def at(asked):
        return (weights @ rings[:, asked].reshape(len(rings), -1)).reshape(len(weights), *asked.shape, 3)

    whole = Lattice.of(grid, at, path, middles, normals, radii, chart.u, stations.trajectory.domain[1])
    if not len(stations.corners):
        return whole
    return whole.only(~(within_prisms(whole, stations, before) | cut_off(whole, stations, before)))


def cut_off(lattice, stations, before):
    """Which rings stand where a mitre of a straight leg already is: (n,) bool; the leg goes on without them.

    Those of the circumscribed fit need it, which do not lean where a law changes them.
    """
    corners, s = stations.corners, stations.s
    half = np.arccos(np.clip(dot(stations.tangent[corners], stations.leave[corners]), -1, 1))
    length = lattice.radii.max() * np.tan(half)
    apart = np.abs(s[:, None] - s[corners])
    apart = np.minimum(apart, stations.total - apart) if stations.closed else apart
    swallowed = (apart < length).any(axis=1) & (norms(stations.bend) == 0)
    swallowed[[0, -1, *corners]] = False
    cut = np.zeros(len(lattice.u), bool)
    cut[before : before + len(s)] = swallowed
    return cut


def within_prisms(lattice, stations, before):
    """Which rings only divide a prism, a leg between mitres whose contour stays as it is: (n,) bool.

    They lean as these mitres ask that are; the mitres of a larger contour are longer. The first station is the ring
    after so many.
    """
    steps = np.arange(len(stations.onward))
    legs = stations.leave[steps]
    change = lattice.points(before + steps + 1) - lattice.points(before + steps)
    change -= dot(change, legs)[..., None] * legs
    straight = norms(stations.arrive[stations.onward] - legs) <= ROUNDING
    straight &= norms(change).max(axis=0) <= ROUNDING * lattice.size
    within = np.zeros(len(lattice.u), bool)
    within[before + steps[1:]] = straight[1:] & straight[:-1]
    within[before + stations.corners] = False
    return within


def widest(x, y):
    """The most by which pairs of axes, (n, 3) twice, stretch any direction of their plane: (n,)."""
    xx, yy, xy = dot(x, x), dot(y, y), dot(x, y)
    return np.sqrt((xx + yy) / 2 + np.hypot((xx - yy) / 2, xy))


def support(contour):
    """How far a contour reaches in directions: (n, 2) to (n,), of a round one as the curve does."""
    return getattr(contour, "support", None) or fitted(contour, Fit.INSCRIBED).support


class Legs:
    """The stretches from corner to corner, and what the mitres there need of them."""

    def __init__(self, swept, lattice):
        stations, before = swept.stations, swept.chart.grid.domes[0]
        corners = stations.corners
        self.stations, self.factor, self.short = stations, np.inf, []
        if not len(corners):
            return
        bevel, (first, last, lengths) = bevels(stations), legs(stations)
        kept = (bevel[first] < 0) | (bevel[first] != bevel[last])
        first, last, lengths = first[kept], last[kept], lengths[kept]
        leaving, arriving = (
            np.einsum("mkx,kx->mk", lattice.at(before + corner) - stations.points[corner], way[corner])
            for corner, way in ((first, stations.leave), (last, stations.arrive))
        )
        needed, self.factor = short_legs(leaving, arriving, lengths)
        self.short = [
            (stations.u[first[leg]], stations.u[last[leg]], lengths[leg], needed[leg])
            for leg in np.flatnonzero(needed > lengths * (1 + ROUNDING))
        ]

    def places(self):
        for a, b, has, needs in self.short:
            middle = self.stations.trajectory.evaluate(np.array([a, b])).mean(axis=0)
            leg = between(a, b, self.stations.trajectory.domain)
            said = f"the leg from {leg} is {has:.4g} m long, and its mitres need {needs:.4g} m."
            yield Place("corner", ((float(a), float(b)),), tuple(middle.tolist()), said)

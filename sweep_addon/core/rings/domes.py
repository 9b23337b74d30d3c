# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Domes: the rings of a round end, beyond the trajectory, that shrink as those of a ball do to a tip."""

from dataclasses import replace

import numpy as np

from ..contours import Fit
from ..declared.frozen import individual
from ..declared.parameters import at, require
from ..stations.cells import WIDEST_TURN, chord_angle
from ..stations.sampling import MOST_STATIONS, Tolerance
from ..vectors import dot, norms
from .ends import Round

SEEN = 1e-9  # of the contour's size squared: what the centroid must see of every edge


@individual
class Dome:
    """The rings of a round end, from the first beyond the trajectory to the tip.

    Parameters
    ----------
    radius, height : (k,) float array
        The size of each ring, 1 at the trajectory's end and 0 at the tip, and how far beyond it stands, in metres.
    centre : (2,) float array
        The point of the contour over which the tip is.
    reach : float
        How far the contour is from there, all in all, in metres.
    """

    radius: np.ndarray
    height: np.ndarray
    centre: np.ndarray
    reach: float

    def __len__(self):
        return len(self.radius)

    @property
    def length(self):
        """The way up the dome to each ring, where the contour is a circle of its reach: (k,) float array."""
        radius, height = np.append(1.0, self.radius) * self.reach, np.append(0.0, self.height)
        return np.cumsum(np.hypot(np.diff(radius), np.diff(height)))

    def rings(self, last, middle, outward):
        """The place, the axes and what else a ring has, (3 or more, k, 3), from those of the trajectory's last.

        The tip is over the middle of the contour, from where the fit may have moved the last ring.
        """
        place, axes = last[0], last[1:]
        over = (1 - self.radius)[:, None] * (middle - place + self.centre @ axes[:2])
        places = place + over + self.height[:, None] * outward
        return np.stack((places, *(self.radius[:, None] * axis for axis in axes)))


NONE = Dome(np.zeros(0), np.zeros(0), np.zeros(2), 0.0)


def domes_of(ends, body, true, samples, fit):
    """The domes of the ends, without a ring where an end is of another kind or the contour is a point.

    Parameters
    ----------
    ends : tuple of two End
    body : Body
        The contours of the sweep, its domes left out.
    true : tuple of two Section
        Those inscribed in the contour at the start and at the end.
    samples : Sampling
    fit : Fit

    Raises
    ------
    ShapeError
        Where the contour has a hole or several outlines, or where its centroid does not see all of it: the rings would
        cross.
    """
    domes = [NONE, NONE]
    for side, key in ((0, "start"), (-1, "end")):
        if isinstance(ends[side], Round) and not body.tips[side]:
            section = body.ends[side]
            with at(key):
                require_seen(section)
            scale = np.abs(body.scales[side])
            grown = float(norms(np.cross(*body.rings[1:, side])) / scale.prod())
            height = ends[side].height * half_breadth(stretched(true[side], scale))
            domes[side] = dome(stretched(section, scale), section.centroid, height, samples, fit, grown)
    return tuple(domes)


def stretched(section, scale):
    return replace(section, points=section.points * scale)


def require_seen(section):
    """Refuse a section whose rings, drawn together towards its centroid, would cross."""
    others = "must be flat, open or taper where"
    require(section.closed, f"{others} the contour is open", "round")
    require((section.areas > 0).all(), f"{others} the contour has holes, which a dome would close", "round")
    require(len(section.areas) == 1, f"{others} the contour has several outlines: sweep each by itself", "round")
    sides = section.points - section.centroid
    x, y = sides.T
    seen = x * y[section.following] - y * x[section.following] > SEEN * section.size**2
    require(seen.all(), f"{others} the contour's centroid does not see all of its outline", "round")


def dome(section, centre, height, samples, fit, grown):
    """The dome of a section that the fit has grown to so many times its area."""
    reach = norms(section.points - section.centroid)
    radius, rise = quarter(steps(samples, max(reach.max(), height), len(reach)), fit, grown)
    return Dome(radius, height * rise, centre, float(reach.mean()))


def quarter(steps, fit, grown):
    """The radii and the heights of rings on a quarter of a circle, the last one a tip: two (k,).

    Circumscribed, the steps are tangents of the circle, from one that goes straight on to one halfway before the tip.
    For the true volume, 2 / 3 of radius squared times height, the vertices move out by the same part: their frusta have
    a volume that is a cubic of it.
    """
    shift = 0.5 if fit is Fit.CIRCUMSCRIBED else 0.0
    angle = (np.arange(1, steps + 1) - shift) * (np.pi / 2 / (steps - shift))
    radius, height, out = np.append(np.cos(angle[:-1]), 0.0), np.sin(angle), 1.0
    if fit is Fit.CIRCUMSCRIBED:
        out = 1 / radius[0]
    elif fit is Fit.AREA_TRUE:
        upper = np.diff(height) @ (radius[:-1] ** 2 + radius[:-1] * radius[1:] + radius[1:] ** 2)
        lowest = height[0] * np.array([radius[0] ** 2, radius[0] * np.sqrt(grown), grown])
        roots = np.roots([upper + lowest[0], *lowest[1:], -2.0])
        out = roots[np.abs(roots - 1).argmin()].real
        radius /= np.sqrt(grown)
    return out * radius, out * height


def half_breadth(section):
    """How far the nearest side is from the centroid, in metres.

    An edge of a smooth outline is a chord: the curve is farther out by one over the cosine of half of what it turns
    from edge to edge, of a circle exactly.
    """
    sides = section.points - section.centroid
    edges = sides[section.following] - sides
    foot = -dot(sides, edges) / section.edge_lengths**2
    turns = np.where(section.sharp, 0.0, section.turns.clip(0.0))
    turns = np.minimum(turns, turns[section.following])
    nearest = np.linalg.norm(sides + foot[:, None] * edges, axis=1) / np.cos(turns / 2)
    across = (foot > 0) & (foot < 1)
    return float(min(np.linalg.norm(sides, axis=1).min(), nearest[across].min(initial=np.inf)))


def steps(samples, radius, points):
    """How many rings there are from the contour of so many points to the tip of a dome as round as a radius."""
    if isinstance(samples, Tolerance):
        wanted = np.pi / 2 / chord_angle(samples.chord, radius)
        most = f"must be larger: a round end takes {wanted:,.0f} contours of {MOST_STATIONS:,} at most"
        require(wanted <= MOST_STATIONS, most, samples.chord, "samples.chord")
    else:
        wanted = min(points / 4, samples.contours)  # as round as the contour of a circle
    return int(np.ceil(max(wanted, np.pi / 2 / WIDEST_TURN) - 1e-9))


def with_domes(domes, stations, rings, body):
    """The rings of a sweep with those of its domes.

    Parameters
    ----------
    domes : tuple of two Dome
        Of the start and of the end.
    stations : Stations
    rings : (3, n, 3) float array
        The place and the axes of the ring at each station, as the fit has moved them.
    body : Body
        The same before that, which are points, and whether the sweep runs against its trajectory, beside it.

    Returns
    -------
    rings : (3, n + k, 3) float array
    tips : (n + k,) bool array
    u, s : (n + k,) float array
        The trajectory's parameter, which ends where the trajectory does, and the arc length, which goes on over a dome.
    """
    parts = [rings.swapaxes(0, 1), body.tips, stations.u, stations.s]
    for dome, side, sign in zip(domes, (0, -1), (-1, 1), strict=True):
        if not len(dome):
            continue
        outward = (-sign if body.backward else sign) * stations.tangent[side]
        beyond = (
            dome.rings(rings[:, side], body.rings[0, side], outward).swapaxes(0, 1),
            dome.radius == 0,
            np.full(len(dome), stations.u[side]),
            stations.s[side] + sign * dome.length,
        )
        pairs = zip(parts, beyond, strict=True)
        parts = [np.concatenate((part, more) if sign > 0 else (more[::-1], part)) for part, more in pairs]
    return parts[0].swapaxes(0, 1), *parts[1:]

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Volume-true rings: a coarse mesh that holds what the true sweep holds."""

import numpy as np

from ..contours.fit import Fit
from ..stations.frames import FixedUp
from ..stations.leaps import leaping_steps
from ..stations.rotations import turned
from ..vectors import cross, dot, norms, unit
from .bevels import fanned
from .mitres import leaned
from .steps import ahead, handed, mitred, require_short, to_both

FARTHEST = 3.0  # rises of the chords: a station moves no farther, for at an inflection it turns by nothing
MOST_GROWN = 2.0  # areas: a step of half a turn holds a third of what it should


def volume_true(stations, rings, along, centroid, turn, reach):
    """Rings between which a mesh has the volume of the true sweep, up to the fourth power of the steps.

    Parameters
    ----------
    stations : Stations
    rings : tuple of three (n, 3) float arrays
        At each station the way off it and the contour's x and y axes, scaled; all of them across the tangent.
    along : Along
        The laws, for the scale between the stations.
    centroid : (2,) float array
        Of the area-true contour, in metres.
    turn : float
        The angle in radians by which a closed sweep comes back turned: one that maps the contour to itself.
    reach : float
        How far its farthest point is from its reference point, in metres.

    Returns
    -------
    (3, n, 3) float array
        The places of the rings, and the axes, stretched; the ends keep their planes.

    Source
    ------
    Weyl: On the Volume of Tubes, Am. J. Math. 61, 1939: area A times length L, however a tube bends, if the centroid
    of its contour is on the trajectory; else each length is that of the centroid's path (Pappus).

    Between two rings the mesh holds A times the leg from centroid to centroid times the mean section across it. Each
    factor is made true, in three steps:

    - A mitre. A ring in the bisector plane of its legs, stretched by 1 / cos(half the turn) in the plane of the turn,
      is the section of both legs: they are prisms.
    - Longer legs. The chord of an arc of length l and curvature k lacks k^2 l^3 / 24. A station that moves by d away
      from the centre of curvature lengthens its legs by d times the turn k l: so d = k l^2 / 24.
    - True sections. Between scales a and b, turned by w against each other, the mean section is (a^2 + a b cos w + b^2)
      / 3, which a twist makes smaller than the law asks and a hollow law larger: the rings grow by what is lacking.

    What is left out is the squares of these corrections, which are squares of the steps. Only where a contour whose
    centroid is off the trajectory also turns or is scaled, the length of its way is right to the square of the steps.
    """
    rings = np.stack(rings)
    aside, x, y = rings
    # a level frame leaps right before a mitre, which the ring there leans to as others on its leg do
    leaping = leaping_steps(None if isinstance(along.frame, FixedUp) else along.frame, stations)
    places = stations.points + outward(stations, aside + centroid[0] * x + centroid[1] * y, leaping)
    before, after = chords(stations, places, leaping)
    bevels, fans = fanned(stations, rings)
    bisectors = unit(before + after)
    rings = np.stack([turned(part, stations.tangent, bisectors) for part in rings])
    if len(stations.corners):
        rings = leaned(stations, rings, reach)
    rings = mitred(rings, before, after)
    rings[1:] *= np.sqrt(growth(stations, places, rings[1:], along, turn))
    rings[:, bevels] = fans
    rings[0] += places
    return rings


def chords(stations, places, leaping):
    """Unit vectors along the legs before and after each place: two (n, 3).

    An end is a mitre of its leg with the mirror image of that behind the plane of the end. A step within a leap is no
    leg: those at both its sides meet there.
    """
    legs = unit(stations.steps(places))
    if stations.closed:
        before, after = np.roll(legs, 1, axis=0), legs
    else:
        ends, tangents = legs[[0, -1]], stations.tangent[[0, -1]]
        mirrored = 2 * dot(ends, tangents)[:, None] * tangents - ends
        before, after = np.concatenate((mirrored[:1], legs)), np.concatenate((legs, mirrored[1:]))
    start, end = np.flatnonzero(leaping), stations.onward[leaping]
    for _ in range(2 if len(start) else 0):  # a contour may stand within a leap
        after[start], before[end] = after[end], before[start]
    return before, after


def outward(stations, centres, leaping):
    """How the stations move, (n, 3), so that the path of the centroid becomes as long as it is along the true curve.

    Those at both sides of a leap move as one.
    """
    require_short(stations, Fit.AREA_TRUE)
    before, after = chords(stations, stations.points, leaping)
    turn = after - before
    sine = norms(turn)
    away = -turn / np.where(sine, sine, 1.0)[:, None]
    share, most = lacking(stations, before, after)
    # A mitre shortens legs by the tangent of half its turn times how far inside the centroid is, an arc by the angle.
    half = np.arcsin(sine / 2)
    inside = -dot(centres, away) * 2 * (np.tan(half) - half)
    inside[stations.corners] = 0.0
    move = np.divide(share + inside, sine, out=np.zeros_like(share), where=sine > 0)
    moves = np.clip(move, -most, most)[:, None] * away
    pairs = np.stack((np.flatnonzero(leaping), stations.onward[leaping]))
    moves[pairs] = moves[pairs].mean(axis=0)
    return moves


def lacking(stations, before, after):
    """What the legs at each station lack in length, and how far it may move: two (n,).

    A leg's two stations share its lack as the squares of the angles between its chord and the curve.
    """
    starts, onward, steps = stations.starts, stations.onward, stations.lengths
    chord = norms(stations.steps(stations.points))
    start = norms(stations.leave[starts] - after[starts])
    end = norms(stations.arrive[onward] - before[onward])
    squares = start**2 + end**2
    lack = np.clip(steps - chord, 0.0, squares * steps)  # of a straight leg the difference is rounding
    rate = lack / np.where(squares, squares, 1.0)
    share = to_both(stations, rate * start**2, rate * end**2, np.add)
    if not stations.closed:
        share[[0, -1]] *= 2  # the mirrored leg lacks as much
    return share, FARTHEST / 4 * to_both(stations, start * steps, end * steps, np.maximum)


def growth(stations, places, axes, along, turn):
    """By how much the area of each ring must grow for the mean sections between them to be true: (n, 1)."""
    starts, onward, legs = stations.starts, stations.onward, stations.steps(places)
    (x, y), (x_next, y_next) = axes[:, starts], ahead(stations, axes, handed(stations, axes) * turn)
    mixed = cross(x, y_next) + cross(x_next, y)
    first, last = (dot(legs, 4 * own + mixed) / 12 for own in (cross(x, y), cross(x_next, y_next)))
    area = np.multiply(*along.at(stations.s, stations.u)[:2])
    middle = area[starts]
    if any(along.tapers) or not along.is_constant:
        middle = np.multiply(*along.at(stations.s[starts] + stations.lengths / 2)[:2])
    true = norms(legs) * (area[starts] + 4 * middle + area[onward]) / 6
    held = first + last
    lack = np.divide(true - held, held, out=np.zeros_like(held), where=held != 0)
    share, weight = (to_both(stations, factor * first, factor * last, np.add) for factor in (lack, 1.0))
    return 1 + np.clip(share / np.where(weight, weight, np.inf), -0.5, MOST_GROWN)[:, None]

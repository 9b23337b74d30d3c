# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fit: how a mesh stands to the true shape, and first the polygon that is swept to the curve of its contour."""

from dataclasses import replace
from enum import Enum

import numpy as np

from ..declared.coercing import pick
from ..declared.parameters import at, require, spelled
from ..later import later
from ..vectors import dot

crossings = later("core.contours.crossing", "crossings")

ROUNDING = 1e-12  # of the size: a lower rise is none
CLOSE = 1e-9  # of the area: a worse one is wrong


class Fit(Enum):
    INSCRIBED = "The vertices lie on the true shape"
    AREA_TRUE = "The contour has the true area, the mesh the true volume, however coarse they are"
    CIRCUMSCRIBED = "The mesh contains the true shape"


def fitted(contour, fit):
    """The section of a contour, each edge that stands for a piece of a curve moved out parallel to itself.

    Parameters
    ----------
    contour : Circle, Outline, ...
        One with curves has ``apexes()``, the point of the curve that is farthest from each edge, and ``area``, which
        the curves enclose. Straight edges stay on their lines.
    fit : Fit or str
        One of its members, or the name of one: "area-true".

    Returns
    -------
    Section
        With the same number of points.

    For its area an edge moves by two thirds of the rise of its curve, which is exact for a parabola, and then by the
    part of that which makes the whole area exact. So a circle or an ellipse is scaled. Where a curve changes from left
    to right the corner moves across only. Where pieces meet at an angle that is slightly hollow, a circumscribed
    polygon can miss a curve by what that angle opens on the way that the corner moves.

    Raises
    ------
    ShapeError
        Where the moved edges cross or cannot have the area, because curves are close and their edges few.

    Examples
    --------
    >>> from .ovals import Circle
    >>> round(fitted(Circle(points=5), "area-true").area, 12) == round(np.pi, 12)
    True
    """
    fit = member(fit)
    section = contour.section()
    require(section.closed or fit is Fit.INSCRIBED, "must be inscribed where the contour is open", spelled(fit), "fit")
    apexes = contour.apexes() if fit is not Fit.INSCRIBED and hasattr(contour, "apexes") else None
    if apexes is None:
        return section
    rise = rises(section, apexes)
    if fit is Fit.CIRCUMSCRIBED:
        section = moved(section, moves(section, np.maximum(rise, 0), rise, np.max))
    else:
        first, more = (moves(section, 2 / 3 * out, rise, np.mean) for out in (rise, np.abs(rise)))
        section = moved(section, first)
        section = moved(section, part(section, more, contour.area) * more)
    good = fit is Fit.CIRCUMSCRIBED or abs(section.area - contour.area) < CLOSE * contour.area
    good = good and not len(crossings(section.points, section.following))
    require(good, "must be inscribed where curves are as close and edges as few as here", spelled(fit), "fit")
    return section


def all_fitted(contour, fit):
    """The sections of a contour, fitted: one, or those of the areas and of the lines of a mixed one."""
    if not hasattr(contour, "sections"):
        return (fitted(contour, fit),)
    fit = member(fit)
    require(fit is Fit.INSCRIBED, "must be inscribed for a mixed contour, which has no curves", spelled(fit), "fit")
    return contour.sections()


def member(fit):
    """The fit that was meant: scripts may give its name, as jobs do."""
    if isinstance(fit, Fit):
        return fit
    with at("fit"):
        return pick({spelled(each): each for each in Fit}, fit)


def moved(section, vectors):
    return replace(section, points=section.points + vectors)


def rises(section, apexes):
    """(m,) float array: how far the curve over each edge rises to its right, in metres; hollows are negative."""
    rise = dot(apexes - section.points, right(section))
    return np.where(np.abs(rise) > ROUNDING * section.size, rise, 0)


def right(section):
    """(m, 2) float array: unit vectors to the right of each edge, away from the area."""
    along = (section.points[section.following] - section.points) / section.edge_lengths[:, None]
    return along[:, ::-1] * (1, -1)


def moves(section, out, rise, over):
    """(m, 2) float array: how the points move when the edges move out, (m,) metres.

    A point stays on both its edges: it moves across them, on the bisector of their normals, and along. It moves along
    at most as far as a corner does that turns by half of what their curves bend; then they ask for two moves across,
    of which ``over`` takes one.
    """
    preceding = np.empty_like(section.following)
    preceding[section.following] = np.arange(len(preceding))
    normal, lengths = right(section), section.edge_lengths
    double = normal + normal[preceding]
    across = double / np.maximum(np.hypot(*double.T), ROUNDING)[:, None]
    cosine, sine = np.hypot(*double.T) / 2, np.sin(section.turns / 2)
    bend = 2 * np.arctan2(2 * np.abs(rise), lengths)  # from the edge to its curve where they meet
    least = np.maximum(np.sin((bend + bend[preceding]) / 4), ROUNDING)
    along = (out - out[preceding]) * np.sign(sine) / np.maximum(2 * np.abs(sine), 2 * least)
    along[rise * rise[preceding] < 0] = 0
    longer = np.maximum(lengths, lengths[preceding])
    asked = over([out - along * sine, out[preceding] + along * sine], axis=0)
    asked = np.clip(asked / np.maximum(cosine, ROUNDING), -longer, longer)
    return asked[:, None] * across + along[:, None] * across[:, ::-1] * (-1, 1)


def part(section, vectors, area):
    """What part of some moves gives a section an area: the root near 0 of a square equation."""
    third = replace(section, points=vectors).area
    second = moved(section, vectors).area - section.area - third
    lacking = area - section.area
    return 2 * lacking / (second + np.sqrt(max(second**2 + 4 * third * lacking, 0))) if lacking else 0.0

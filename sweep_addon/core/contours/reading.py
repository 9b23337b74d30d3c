# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading: what contours from drawings and from fonts have in common."""

from importlib import import_module

import numpy as np

from ..declared.coercing import coerce
from ..declared.parameters import LARGEST, Parameter, ShapeError, at, require
from .filling import filled
from .flatten import flatten_cubics
from .outline import Outline
from .section import Section


def argument(name, value, type=float, **limits):
    """The value of an argument that was meant, or a refusal that names it."""
    with at(name):
        return coerce(Parameter(name, type, **limits), value)


def library(name, package):
    """A module of an optional library, or a refusal that says how to get it."""
    try:
        return import_module(name)
    except ImportError as error:
        sentence = f"cannot be read without the library {package}, which is missing here: pip install {package}"
        raise ShapeError(sentence) from error


def outline(paths, figure, even_odd, tolerance, centred):
    """The outline around what closed paths of cubic Bezier segments fill.

    Parameters
    ----------
    paths : list of (n, 4, 2) float arrays
        The segments of each closed path, in metres.
    figure, even_odd
        As `filled` has them: the figure of each path, and the fill rule of each figure.
    tolerance : float
        Largest distance from the curves; 0 is a thousandth of the size.
    centred : bool
        Whether the centroid of the area is moved to the origin.
    """
    tolerance, centred = argument("tolerance", tolerance, minimum=0.0), argument("centred", centred, bool)
    control = np.concatenate(paths)
    largest = float(np.abs(control).max())
    require(largest <= LARGEST, f"must have finite numbers up to {LARGEST:g} in size", largest)
    size = float(np.hypot(*np.ptp(control[:, 0], axis=0)))
    points, first = flatten_cubics(control, tolerance or max(size, 1e-300) / 1000)
    begins = np.cumsum([0, *(len(path) for path in paths)])[:-1]
    loops = filled(np.split(points, first[begins[1:]]), np.asarray(figure), np.asarray(even_odd))
    require(loops, "must fill an area", 0.0)
    centre = Section.from_loops(loops).centroid if centred else np.zeros(2)
    return Outline(loops=[loop - centre for loop in loops])

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Contours: what moves in a sweep, planar figures about a reference point.

Each kind is a value with a ``section()``: closed loops of points that bound an area.

Examples
--------
>>> Circle(radius=1.0, points=6).section().points.shape
(6, 2)
"""

from importlib import import_module

from .aerofoil import Aerofoil
from .fit import Fit, all_fitted, fitted
from .mixed import Mixed
from .outline import Outline
from .ovals import Circle, Ellipse, Superellipse
from .rectangle import Rectangle
from .region import Region
from .regular import RegularPolygon, Star
from .screw_thread import ScrewThread

Contour = Circle | Ellipse | Rectangle | RegularPolygon | Star | Superellipse | Aerofoil | ScrewThread | Outline
PlanarSet = Contour | Mixed  # what may also be of mixed dimension

__all__ = [
    "Aerofoil",
    "Circle",
    "Contour",
    "Ellipse",
    "Fit",
    "Mixed",
    "Outline",
    "Rectangle",
    "Region",
    "RegularPolygon",
    "ScrewThread",
    "Section",
    "Star",
    "Superellipse",
    "all_fitted",
    "fitted",
    "from_dxf",
    "from_svg",
    "from_text",
    "offset",
    "recover_arcs",
]


def __dir__():
    return __all__  # what a console offers


LATER = {
    "from_dxf": ".dxf",
    "from_svg": ".svg",
    "from_text": ".fonts",
    "offset": ".offsetting",
    "recover_arcs": ".arc_recovery",
    "Section": ".section",
}


def __getattr__(name):
    # What reads files, asks manifold3d or only makes is loaded when it is asked for: declaring a sweep needs none.
    if name not in LATER:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(LATER[name], __package__), name)

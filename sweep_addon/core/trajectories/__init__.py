# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trajectories: the curves along which a generator moves."""

from .arc import Arc
from .bezier import Bezier
from .formula import Closing, Formula
from .gpx import from_gpx
from .helix import Helix
from .line import Line
from .nurbs import Nurbs
from .polyline import Polyline
from .sampled import Sampled
from .table import from_csv
from .torus_knot import TorusKnot

Trajectory = Line | Arc | Helix | TorusKnot | Polyline | Bezier | Nurbs | Sampled | Formula

__all__ = [
    "Arc",
    "Bezier",
    "Closing",
    "Formula",
    "Helix",
    "Line",
    "Nurbs",
    "Polyline",
    "Sampled",
    "TorusKnot",
    "Trajectory",
    "from_csv",
    "from_gpx",
]


def __dir__():
    return __all__  # what a console offers

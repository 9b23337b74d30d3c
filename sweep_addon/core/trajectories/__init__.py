# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trajectories: the curves along which a generator moves."""

from importlib import import_module

from .about_an_axis import Arc, Helix, TorusKnot
from .bezier import Bezier
from .formula import Closing, Formula
from .line import Line
from .nurbs import Nurbs
from .polyline import Polyline
from .sampled import Sampled

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


LATER = {"from_csv": ".table", "from_gpx": ".gpx"}


def __getattr__(name):
    # Readers of files are loaded when they are asked for: most sweeps need neither.
    if name not in LATER:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(LATER[name], __package__), name)

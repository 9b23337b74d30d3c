# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Coarseness: what is to be told of a tolerance that leaves few corners of a bend, as of one of a centimetre."""

from functools import lru_cache

import numpy as np

from ..vectors import norms
from .sampling import Tolerance

SEEN = np.radians(46)  # in one step: a round corner of a right angle has two of 45 degrees wherever it is small
SMOOTH = 1 - np.cos(np.radians(3.6))  # of the bend's radius: a chord of fifty to a full turn
FITS = 0.05  # of the contour: a chord this long over such a turn is of a bend in which the contour does not fit


def told_coarse(stations, samples, reach):
    """What is to be told where the trajectory turns so much from one station to the next that it looks broken.

    Only a tolerance is told: who says a number of contours, or a finer tolerance for renders, has seen what is between.

    Parameters
    ----------
    stations : Stations
    samples : Sampling
    reach : float
        How far the contour is from its reference point, in metres. Where it does not fit in the bend it folds there,
        which is told of, and more contours would not help.

    Returns
    -------
    tuple of str

    Examples
    --------
    >>> from sweep_addon.core.trajectories import Helix
    >>> from sweep_addon.core.stations.sampling import place
    >>> told_coarse(place(Helix(radius=0.01, pitch=0.004), Tolerance()), Tolerance(), 0.0005)
    ('Samples: the path turns by 50 degrees between two of them; a chord of about 0.02 mm makes it smooth.',)
    """
    if not isinstance(samples, Tolerance) or samples.render or samples.chord <= FITS * reach:
        return ()
    turn, radius = widest(stations)
    if turn <= SEEN:
        return ()
    chord = np.format_float_positional(float(f"{1000 * SMOOTH * radius:.1g}"), trim="-")
    between = f"the path turns by {np.degrees(turn):.0f} degrees between two of them"
    return (f"Samples: {between}; a chord of about {chord} mm makes it smooth.",)


@lru_cache(maxsize=16)
def widest(stations):
    """The largest turn from a station to the next in radians, corners left out, and the radius of the bend there."""
    turns = 2 * np.arcsin(np.minimum(norms(stations.ended(stations.arrive) - stations.leave[stations.starts]) / 2, 1.0))
    step = turns.argmax()
    return float(turns[step]), float(stations.lengths[step] / max(turns[step], 1e-300))

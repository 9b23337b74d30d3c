# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Scales: what multiplies lengths, angles and diameters that modules do not say, from where it stands on its way on."""

import numpy as np

from ...declared.parameters import ShapeError, require

LENGTH, ANGLE, WIDTH = "@Sl", "@Sa", "@Sw"


def scaled(walk, name, places, since=None):
    """What the scales of a name on the way to each place come to.

    Parameters
    ----------
    walk : Walk
    name : str
    places : (m,) int array
        Of modules, in the order of the word.
    since : (m,) int array, optional
        Places whose scales, and those before, do not count; -1 where all do.

    Returns
    -------
    (m,) float array, or 1.0 where there are none

    Raises
    ------
    ShapeError
        For a scale that is not positive.
    """
    if not walk.named.get(name):
        return 1.0
    chosen = walk.chosen(name, given=True)
    where = np.flatnonzero(chosen)
    if not len(where):
        return 1.0
    factors = walk.word.columns[0][where]
    if not (factors > 0).all():
        raise ShapeError(f"must be positive, got {factors[~(factors > 0)][0]:g}", name)
    same = (factors == factors[0]).all()  # where all are the same they are counted, and nothing is rounded
    logs = np.ones(len(where)) if same else np.log(factors)
    total = np.append(walk.branches.sums(logs, walk.branches.first(chosen))[1], 0.0)
    powers = total[walk.branches.before(places, chosen)]
    if since is not None:
        known = since >= 0
        powers[known] -= total[walk.branches.before(since[known], chosen)]
    with np.errstate(over="ignore"):
        found = factors[0] ** np.rint(powers) if same else np.exp(powers)
    require(np.isfinite(found).all(), "must come to a finite scale", found.max(initial=0), name)
    return found

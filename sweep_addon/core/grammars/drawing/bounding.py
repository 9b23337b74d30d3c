# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bounds of what a turtle is told: numbers of which a figure can be drawn."""

import numpy as np

from ...declared.parameters import LARGEST, ShapeError


def bounded(values, measure, sentence):
    """The values, or a refusal where their sizes are so large that what is drawn of them may be no number.

    Parameters
    ----------
    values : (n,) float array or float
    measure : callable
        Of the sizes what counts: their sum, or the greatest.
    sentence : str
        What must hold, with a place for the limit.

    Examples
    --------
    >>> try:
    ...     bounded(np.array([1e300, 1e300]), np.sum, "go at most {} m in all")
    ... except ShapeError as refusal:
    ...     print(refusal)
    figure: must go at most 1e+12 m in all, got 2e+300
    """
    with np.errstate(over="ignore"):
        size = measure(np.abs(values)) if np.size(values) else 0.0
    if not size <= LARGEST:
        raise ShapeError(f"must {sentence.format(f'{LARGEST:g}')}, got {size:g}", "figure")
    return values

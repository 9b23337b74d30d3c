# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Breadth: a figure much flatter than it is long has points that nothing can tell apart, and is refused."""

from ..declared.parameters import require

FLATTEST = 1e-6  # single precision, which Blender keeps, tells the two sides of such a figure just apart


def require_broad(contour, one, other):
    """Refuse a contour of which one of two lengths is less than a millionth of the other.

    Parameters
    ----------
    contour : declared value
    one, other : str
        The names of its parameters; the sentence is about the shorter one.
    """
    shorter, longer = sorted((one, other), key=lambda name: getattr(contour, name))
    least = FLATTEST * getattr(contour, longer)
    value = getattr(contour, shorter)
    require(value >= least, f"must be at least {least:.9g}, a millionth of {longer}", value, shorter)

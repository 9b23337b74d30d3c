# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Symmetry: the turns about the reference point that map a section to itself."""

import numpy as np

ALIKE = 1e-6  # of the size


def turned_onto(section, turns):
    """Where the points come to lie when a section is turned by a part of a whole turn.

    Parameters
    ----------
    section : Section
    turns : float
        The section is turned by 2 pi / turns, counter-clockwise, about the reference point.

    Returns
    -------
    (m,) int array or None
        The point onto which each point is turned; None if the section is not mapped to itself.

    Examples
    --------
    >>> from .ovals import Circle
    >>> turned_onto(Circle(points=6).section(), 3).tolist(), turned_onto(Circle(points=6).section(), 4)
    ([2, 3, 4, 5, 0, 1], None)
    """
    points = section.points @ (1, 1j)
    turned = points * np.exp(2j * np.pi / turns)
    onto = np.empty(len(points), dtype=int)
    for start, end in zip(section.offsets[:-1].tolist(), section.offsets[1:].tolist(), strict=True):
        first = int(np.abs(points - turned[start]).argmin())
        loop = section.loop_of[first]
        target, count = section.offsets[loop], end - start
        if section.offsets[loop + 1] - target != count:
            return None
        onto[start:end] = target + (first - target + np.arange(count)) % count
        if np.abs(points[onto[start:end]] - turned[start:end]).max() > ALIKE * section.size:
            return None
    return onto if (section.sharp[onto] == section.sharp).all() else None


def symmetry(section):
    """In how many turns a section is mapped to itself: the largest n so that 2 pi / n maps it; 1 without symmetry.

    Examples
    --------
    >>> from .rectangle import Rectangle
    >>> symmetry(Rectangle(1, 2).section()), symmetry(Rectangle(2, 2).section())
    (2, 4)
    """
    many = len(section.points)
    for parts in range(1, many // 2 + 1):
        if many % parts == 0 and turned_onto(section, many // parts) is not None:
            return many // parts
    return 1

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lengths and places in the words of people."""

SHORT = 0.01  # metres, below which they are told in millimetres


def in_units(metres):
    """A length in the unit in which people would read it.

    >>> in_units(0.401), in_units(1.9e-5)
    ('0.401 m', '0.019 mm')
    """
    return f"{metres:.3g} m" if metres >= SHORT else f"{metres * 1e3:.3g} mm"


def place(point):
    """A point (3,) in metres.

    >>> place([0.1, -0.0, 2.0])
    '(0.1, 0, 2) m'
    """
    return f"({', '.join(f'{along + 0.0:.4g}' for along in point)}) m"

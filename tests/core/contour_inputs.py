# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Inputs that several tests of contours share, and what they are held against."""

import json
from pathlib import Path

import numpy as np

from sweep_addon.core.contours import Outline

DATA = Path(__file__).parents[1] / "data"
OUTLINES = json.loads((DATA / "outlines.json").read_text())["outlines"]
FONT = DATA / "fonts" / "dejavu-sans-subset.ttf"


def drawn(outline, tolerance=0.0):
    """An outline of outlines.json as a contour; its millimetres are taken for metres."""
    x, y, bulge = np.array(outline["vertices"]).T
    return Outline(loops=[np.stack([x, y], axis=1)], bulges=[bulge], tolerance=tolerance)


def square(size, x=0.0, y=0.0):
    return np.array([(x, y), (x + size, y), (x + size, y + size), (x, y + size)], dtype=float)


def ngon(sides, radius, x=0.0, y=0.0):
    angle = 2 * np.pi * np.arange(sides) / sides
    return np.stack([x + radius * np.cos(angle), y + radius * np.sin(angle)], axis=1)


def star(rng, points, inner=0.5, outer=1.5):
    """A polygon in view of the origin: it turns round it in random steps at random distances."""
    step = rng.random(points) + 0.2
    angle = 2 * np.pi * np.cumsum(step) / step.sum()
    return rng.uniform(inner, outer, points)[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)


def shoelace(loop):
    x, y = np.asarray(loop, dtype=float).T
    return (x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def superellipse(half, exponent, angle):
    """Places of a superellipse seen under angles (n,), and unit vectors away from it, by its equation: two (n, 2)."""
    direction = np.stack((np.cos(angle), np.sin(angle)), axis=1)
    places = half * direction / (np.abs(direction) ** exponent).sum(axis=1, keepdims=True) ** (1 / exponent)
    slope = np.sign(direction) * np.abs(direction) ** (exponent - 1) / half
    return places, slope / np.linalg.norm(slope, axis=1, keepdims=True)

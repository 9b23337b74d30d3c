# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The camera's place: as close as shows all of a shape, so that the shape fills the picture."""

import numpy as np

NEAREST = 0.5  # of the shape's size: how near the camera may come to it


def axes(azimuth, elevation):
    """The camera's axes as rows: to the right, up, and away from it, (3, 3) float array.

    Parameters
    ----------
    azimuth, elevation : float
        Where the camera stands, seen from the shape, in radians from the x axis and from the xy plane.
    """
    back = [np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)]
    right = [-np.sin(azimuth), np.cos(azimuth), 0.0]
    return np.array([right, np.cross(back, right), np.negative(back)])


def fit(points, axes, slopes):
    """Where a camera stands that just shows all points.

    Parameters
    ----------
    points : (n, 3) float array
    axes : (3, 3) float array
        The camera's axes to the right, up, and away.
    slopes : (float, float)
        Half the picture's width and height at a distance of 1.

    Returns
    -------
    (3,) float array

    Each side of the picture is a plane through the camera that must have all points on one side. Of the planes in
    their directions, those that touch the points meet in a line for left and right, and one for top and bottom:
    the farther of the two lines says how far away the camera stands. A shape that points at the camera is not met.
    """
    right, up, away = axes @ np.asarray(points, dtype=float).T
    size = np.linalg.norm(np.ptp(points, axis=0))
    place, distance = [], away.min() - NEAREST * size
    for coordinate, slope in ((right, slopes[0]), (up, slopes[1])):
        above, below = (coordinate - slope * away).max(), (-coordinate - slope * away).max()
        place.append((above - below) / 2)
        distance = min(distance, -(above + below) / (2 * slope))
    return np.array([*place, distance]) @ axes


def turned(points, steps=64):
    """Points that stand for a shape turned about the z axis through its middle, so that one camera shows every turn."""
    points = np.asarray(points, dtype=float)
    low, high = points.min(axis=0), points.max(axis=0)
    middle = (low + high) / 2
    radius = np.hypot(*(points - middle).T[:2])
    level = ((points[:, 2] - low[2]) / max(high[2] - low[2], 1e-30) * steps).astype(int)
    widest = np.full(steps + 1, -np.inf)
    np.maximum.at(widest, level, radius)
    heights = np.linspace(low[2], high[2], steps + 1)[widest >= 0]
    angle = np.linspace(0, 2 * np.pi, steps, endpoint=False)
    rings = widest[widest >= 0][:, None] * np.exp(1j * angle)
    levels = np.broadcast_to(heights[:, None], rings.shape)
    return np.stack([rings.real, rings.imag, levels], axis=-1).reshape(-1, 3) + [*middle[:2], 0]

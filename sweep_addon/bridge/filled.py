# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What texts fill, whose letters may overlap as in many fonts, and drawings whose splines cross a little."""

from functools import lru_cache

import numpy as np

from ..core.contours import Outline, reading
from ..core.contours.flatten import cubics_from_lines, flatten_cubics
from ..core.contours.mending import mended
from ..core.declared.parameters import require
from .curves import closed_cubics, coordinates


def paths(splines):
    """Splines as closed paths of cubics, (n, 4, 2) float arrays; those of underlines and polygons are straight."""
    return [closed_cubics(spline)[..., :2] if spline.type == "BEZIER" else straight(spline) for spline in splines]


def drawn_paths(splines):
    """The same of a curve; none where some of its splines are not cyclic, or of a kind that no drawing has."""
    closed = all(spline.use_cyclic_u and spline.type in {"BEZIER", "POLY"} for spline in splines)
    return paths(splines) if closed else []


def straight(spline):
    points = coordinates(spline.points, "co", 4)[:, :2]
    return cubics_from_lines(np.stack((points, np.roll(points, -1, axis=0)), axis=1))


def around_letters(paths):
    """The outline around what paths fill; a letter that turns back on itself, or runs into another, may do so."""
    return made_once(united, *told(paths))


def mended_outline(paths):
    """The outline of paths that cross and touch by less than can be seen; refuses those that cross more."""
    require(paths, "must be splines that are cyclic", 0)
    return made_once(without_slips, *told(paths))


def told(paths):
    """Paths as values that can be compared: their numbers, and how many cubics each has."""
    return np.concatenate(paths).tobytes(), tuple(map(len, paths))


@lru_cache(maxsize=16)  # while a parameter is dragged, the curve stays
def made_once(make, numbers, counts):
    control = np.frombuffer(numbers).reshape(-1, 4, 2)
    return make(np.split(control, np.cumsum(counts)[:-1]))


def united(paths):
    return reading.outline(paths, np.zeros(len(paths), dtype=int), [False], tolerance=0.0, centred=False)


def without_slips(paths):
    control = np.concatenate(paths)
    require(np.isfinite(control).all(), "must have finite numbers", "others")
    size = np.ptp(control[:, 0], axis=0).max()
    return Outline(mended([flatten_cubics(path, max(size / 1000, 1e-9))[0] for path in paths]))

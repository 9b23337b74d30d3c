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


def letters(splines):
    """The splines of a text as paths, and which of them are lines under it: a tuple of 0 and 1."""
    return paths(splines), tuple(int(spline.type != "BEZIER") for spline in splines)


def straight(spline):
    points = coordinates(spline.points, "co", 4)[:, :2]
    return cubics_from_lines(np.stack((points, np.roll(points, -1, axis=0)), axis=1))


def around_letters(paths, under):
    """The outline around what paths fill; a letter that turns back on itself, or runs into another, may do so.

    Lines under a text are filled by themselves: letters of many fonts run round the other way, and would have holes
    there.
    """
    return made_once(united, *told(paths), under)


def mended_outline(paths):
    """The outline of paths that cross and touch a little; refuses those that cross more."""
    require(paths, "must be splines that are cyclic", 0)
    return made_once(without_slips, *told(paths))


def told(paths):
    """Paths as values that can be compared: their numbers, and how many cubics each has."""
    return np.concatenate(paths).tobytes(), tuple(map(len, paths))


@lru_cache(maxsize=16)  # while a parameter is dragged, the curve stays
def made_once(make, numbers, counts, *others):
    control = np.frombuffer(numbers).reshape(-1, 4, 2)
    return make(np.split(control, np.cumsum(counts)[:-1]), *others)


def united(paths, under):
    size = max((extent(path) for path, line in zip(paths, under, strict=True) if not line), default=0.0)
    return reading.outline(paths, under, [False, False], tolerance=size / 1000, centred=False)


def without_slips(paths):
    require(all(np.isfinite(path).all() for path in paths), "must have finite numbers", "others")
    return Outline(mended([flatten_cubics(path, max(extent(path) / 1000, 1e-9))[0] for path in paths]))


def extent(path):
    """The size of a letter or a spline: its chords keep within a thousandth of that, however long a text is."""
    return float(np.ptp(path, axis=(0, 1)).max())

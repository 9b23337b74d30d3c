# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Detecting: the stretches of a lattice that meet, the ends that one goes through, and all places of a shape."""

from functools import partial

import numpy as np

from ..stations.search import GOLDEN
from ..vectors import dot, norms
from .cells import any_cross, candidates, crossing, through_face
from .folds import between
from .places import Place, Places
from .stretches import BANDS, coarse

HALVED = 2.0 ** np.array((5, 11, 16))  # of the size is left, closer and closer: a hundred-thousandth, or two
LESS = 1 - 1e-9
ALIKE = 1e-6  # of a distance
FIRST = 8  # pairs of stretches that are looked at first where one that meets is enough
FEW, SHOWING = 300, 32  # pairs of stretches that are all looked at closely, and that show whether many meet
ENOUGH = 1500  # rings that tell the largest safe size: it takes many looks


def together(lattice, local, legs=None, size=1.0, unit="scale"):
    """All places of a shape: `Places`.

    Parameters
    ----------
    lattice : Lattice
    local : Local
    legs : optional
        With ``places()`` of those that are too short, and the ``factor`` up to which none is.
    size : float
        What of the shape a factor of 1 is, in the unit of `Places`.
    unit : str
    """
    folds = local.folds()
    corners = list(legs.places()) if legs else []
    places = [*map(local.place, folds), *corners, *meetings(lattice, folds)]

    def safe():
        limit = min(local.factor(), legs.factor if legs else np.inf)
        return size * largest(lattice, limit, not places)

    return Places(places, safe, unit)


def meetings(lattice, folded):
    """Where a lattice meets itself beside its folds.

    Parameters
    ----------
    lattice : Lattice
    folded : sequence of (float, float)
        Parameters between which it folds.

    Returns
    -------
    list of Place
    """
    return [*stretches_met(*crossings(lattice, folded)), *ends_met(lattice, folded)]


def crossings(lattice, folded):
    """The cells of a lattice that cross, and the lattice of fewer rings whose cells they are."""
    lattice, pairs = coarse(lattice, folded)
    rough, some = lattice, pairs[:: max(len(pairs) // SHOWING, 1)]
    if len(pairs) > FEW and any_cross(lattice, *candidates(lattice, some)):  # it does meet; where, fewer rings tell too
        some = pairs
        while len(some) > FEW and (thinner := rough.coarser()):
            rough, some = coarse(thinner, folded)
        found = crossing(rough, *candidates(rough, some))
        if len(found.bands):
            return rough, found
    return lattice, crossing(lattice, *candidates(lattice, pairs))


def stretches_met(lattice, found):
    """A place for each group of crossing cells whose bands are neighbours on both sides."""
    if not len(found.bands):
        return []
    step = norms(np.diff(lattice.path, axis=0)).mean()
    block = max(BANDS, int(2 * lattice.radii.max() / step))  # as long as the contour is wide
    count = max(lattice.bands // block, 1)
    first, last = found.bands.T * count // lattice.bands
    numbers, which = np.unique(first * count + last, return_inverse=True)
    group = groups(np.stack(np.divmod(numbers, count), axis=1), count, lattice.closed)[which]
    places = []
    for number in range(group.max() + 1):
        members = group == number
        bands, points = found.bands[members], found.points[members]
        ranges = [span(lattice, side, points) for side in sides(lattice, bands).T]
        cells = cells_of(lattice, bands.ravel(), found.columns[members].ravel())
        places.append(met(ranges, nearest(points), lattice.u[[0, -1]], cells))
    return places


def sides(lattice, bands):
    """Pairs of bands (k, 2), those first that are beside the least of all: over a closed start they change sides."""
    if not lattice.closed:
        return bands
    least = bands[(bands[:, 0] * lattice.bands + bands[:, 1]).argmin()]
    apart = np.abs(bands[:, :, None] - least)  # (k, 2, 2)
    apart = np.minimum(apart, lattice.bands - apart)
    other = apart[:, 0, 1] + apart[:, 1, 0] < apart[:, 0, 0] + apart[:, 1, 1]
    return np.where(other[:, None], bands[:, ::-1], bands)


def met(ranges, point, domain, cells=()):
    """The place of two stretches of a trajectory with that domain."""
    (a, b), (c, d) = sorted(ranges)
    said = f"the sweep from {between(a, b, domain)} meets that from {between(c, d, domain)}, at {spot(point)}."
    return Place("global", ((a, b), (c, d)), tuple(point.tolist()), said, cells)


def spot(point):
    return "(" + ", ".join(f"{x:.3g}" for x in point + 0.0) + ")"


def nearest(points):
    """That of some points which is nearest to the middle of them; of several as near the last by x, y and z."""
    apart = norms(points - points.mean(axis=0))
    points = points[apart <= apart.min() * (1 + ALIKE)]  # where all is symmetric rounding would choose
    return points[np.lexsort(points.round(9).T[::-1])[-1]]


def cells_of(lattice, bands, columns):
    """Cells by the numbers of their first and last ring and their column: (k, 3) int array."""
    columns_of = lattice.grid.columns
    bands, columns = np.divmod(np.unique(bands * columns_of + columns), columns_of)
    return np.stack((lattice.rings[bands], lattice.rings[bands + 1], columns), axis=1)


def span(lattice, bands, points):
    """The parameters from the first to the last of points on bands; round a closed start, from the larger one."""
    start, step = lattice.path[bands], lattice.path[bands + 1] - lattice.path[bands]
    squared = dot(step, step)
    share = dot(points - start, step) / np.where(squared > 0, squared, 1.0)
    u = lattice.u[bands] + share.clip(0.0, 1.0).round(9) * (lattice.u[bands + 1] - lattice.u[bands])
    some = np.unique(bands) if lattice.closed else ()
    if len(some) > 1:
        gap = np.diff(some).argmax()
        if some[gap + 1] - some[gap] > some[0] + lattice.bands - some[-1]:  # it goes on from the end to the start
            before = bands <= some[gap]
            return float(u[~before].min()), float(u[before].max())
    return float(u.min()), float(u.max())


def groups(keys, count, closed):
    """Numbers of the groups of pairs (k, 2) whose members are neighbours: each takes the least number beside it."""
    numbers = keys[:, 0] * count + keys[:, 1]  # rising: the pairs are in order
    group = np.arange(len(keys))
    steps = [(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1)]
    beside = []
    for step in steps:
        other = keys + step
        other = np.sort(other % count, axis=1) if closed else other
        wanted = other[:, 0] * count + other[:, 1]
        at = np.searchsorted(numbers, wanted).clip(0, len(numbers) - 1)
        valid = (numbers[at] == wanted) & (closed | ((other >= 0) & (other < count)).all(axis=1))
        beside.append(np.where(valid, at, np.arange(len(keys))))
    while True:
        least = np.minimum.reduce([group[at] for at in beside])
        least = least[least]
        if (least == group).all():
            return np.unique(group, return_inverse=True)[1].ravel()
        group = least


def ends_met(lattice, folded):
    """A place for each flat face at an end, and the stretch that goes through it."""
    places, nearness = [], lattice.held(folded)
    for cap, ring, name in zip(lattice.grid.caps, (0, len(lattice.u) - 1), ("start", "end"), strict=True):
        if cap is None:
            continue
        bands = np.flatnonzero(near_face(lattice, ring, nearness))
        through, columns, points = through_face(lattice, ring, bands)
        order = np.argsort(through, kind="stable")
        for run in np.split(order, np.flatnonzero(np.diff(through[order]) > BANDS) + 1):
            if not len(run):
                continue
            a, b = span(lattice, through[run], points[run])
            point, at = nearest(points[run]), float(lattice.u[ring])
            said = f"the face at the {name} meets the sweep from {between(a, b, lattice.u[[0, -1]])}, at {spot(point)}."
            cells = cells_of(lattice, through[run], columns[run])
            places.append(Place("ends", tuple(sorted(((at, at), (a, b)))), tuple(point.tolist()), said, cells))
    return places


def near_face(lattice, ring, nearness):
    """Bands whose balls meet that round the face at a ring and its plane, and are not its own: (n - 1,) bool."""
    rings, way = np.arange(len(lattice.u)), lattice.path - lattice.path[ring]
    near = nearness.near(np.minimum(rings, ring), np.maximum(rings, ring))
    apart = norms(way) > lattice.radii + lattice.radii[ring]
    over = np.abs(way @ lattice.normals[ring]) > lattice.radii
    far = near | apart | over
    return ~(far[1:] & far[:-1])


def largest(lattice, limit, known):
    """The factor of the contours up to which a lattice is clean, of a thousand rings or two.

    Parameters
    ----------
    lattice : Lattice
    limit : float
        The factor at which it folds.
    known : bool
        Whether it is clean as it is.

    A lattice that is clean is scaled up to where it folds, or to where its contours are larger than the trajectory.
    Where it meets itself, those stretches alone are followed down to where they part, and the whole is looked at there:
    a few times, where a bisection would do so at every step.
    """
    while thinner := lattice.coarser(ENOUGH):
        lattice = thinner

    def meets(factor):
        """A function that tells of other factors whether what meets at this one does; None where nothing meets."""
        found = meeting(lattice.scaled(factor))
        return found and (lambda factor: found(lattice.scaled(factor)))

    low, high = (1.0, 1.0) if known else (0.0, min(1.0, limit))
    most = min(limit, 2 * lattice.size / max(lattice.radii.max(), 1e-300))
    still = None if known else meets(high * LESS if high == limit else high)
    while known and not still and high < most:  # a little more first: the more overlaps the longer it takes
        low, high = high, min(2 * high, most)
        still = meets(high * LESS)
    if not still:
        return limit if high == most else high
    for width in (high - low) / HALVED:
        while still:
            parted, high = where_parted(still, low, high, width)
            below = meets(parted) if parted > low else None
            if not below:
                low = parted
                break
            high, still = parted, below
    return low


def where_parted(still, low, high, width):
    """Where a test that holds at the higher factor ends to hold, and where it still does, no more than a width above.

    It is looked for from above, in longer and longer steps: what meets next often does as long as what has met before.
    """
    step, below = width, max(high - width, low)
    while below > low and still(below):
        high, step = below, 4 * step
        below = max(high - step, low)
    while high - below > width:
        middle = (below + high) / 2
        below, high = (below, middle) if still(middle) else (middle, high)
    return below, high


def meeting(lattice):
    """A function that tells of the same lattice, scaled otherwise, whether it meets itself where this one does.

    None where this one is clean. Where much meets, a few pairs of stretches from everywhere show it.
    """
    looked_at, pairs = coarse(lattice, ())
    pairs = pairs[np.argsort(np.arange(len(pairs)) * GOLDEN % 1)]
    start, size = 0, FIRST
    while start < len(pairs):
        some = pairs[start : start + size]
        if any_cross(looked_at, *candidates(looked_at, some)):
            return partial(stretches_cross, rings=looked_at.rings, pairs=some)
        start, size = start + size, 4 * size
    return (lambda other: bool(ends_met(other, ()))) if ends_met(lattice, ()) else None


def stretches_cross(lattice, rings, pairs):
    """Whether any of pairs of stretches, of some rings of a lattice by their numbers, cross."""
    lattice = lattice.only(np.isin(lattice.rings, rings))
    return any_cross(lattice, *candidates(lattice, pairs))

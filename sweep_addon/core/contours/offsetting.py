# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a disc visits that moves along the boundary of an area: an outline again, of lines and true arcs."""

import numpy as np

from ..declared.frozen import individual
from ..declared.parameters import require
from ..distance import Tree, nearest
from ..meshes.booleans import library
from ..meshes.runs import following
from ..vectors import dot
from .arcs import apexes, arc_points, chords, tangent_turns
from .outline import Outline, size
from .reading import argument

SMOOTH = 1e-7  # radians: edges that turn by less go on into each other
SAME = 1e-8  # of the size: arcs whose centres and radii differ by less are one
FINE = 2e-5  # of the size: how far chords may be from what is offset
LEAST = 1e-6  # of the size: shorter pieces of an offset are rounding
MOST_SIDES = 4096  # of a round corner
PARALLEL = 1e-12  # radians: lines or circles that cross at less only touch
ROUNDS = 12  # of Newton's method, which doubles the digits in each
HALF_TURN = 0.999 * np.pi  # larger arcs are two


def offset(contour, distance, both=False):
    """Move the boundary of an area outwards by a distance, or inwards, with round corners.

    Parameters
    ----------
    contour : Contour
        Closed. Its arcs are taken for arcs, and a circle for a circle and not for its polygon.
    distance : float
        In metres; a negative one moves inwards.
    both : bool
        Whether what a disc visits is wanted that moves along the boundary: all within the distance, on both sides.

    Returns
    -------
    Outline
        Of lines and arcs, which touch the true offset: pieces that trim each other end where they cross.

    Raises
    ------
    ShapeError
        For an open contour, inwards where nothing is left, or where manifold3d is missing.

    Source
    ------
    The topology is that of Clipper's offset of fine chords; each piece of it is replaced by the line or the arc at that
    distance from the line, arc or corner that is nearest.

    Examples
    --------
    A disc of radius 1 m moves along a circle of radius 5 m: between circles of 4 and 6 m.

    >>> from .ovals import Circle
    >>> ring = offset(Circle(5.0), 1.0, both=True)
    >>> round(ring.area / np.pi, 9), len(ring.loops)
    (20.0, 2)
    """
    distance = argument("distance", distance)
    require(distance, "must not be 0", distance, "distance")
    require(hasattr(contour, "section"), "must be a contour", contour, "contour")
    require(contour.section().closed, "must be closed", "an open one", "contour")
    found = boundary(contour, (abs(distance), -abs(distance)) if both else (distance,))
    require(found, "must leave something inside", distance, "distance")
    return found


def boundary(contour, amounts):
    """The boundaries of a closed contour moved outwards by some amounts: an `Outline`, or None where none is left."""
    source = chained(contour)
    found = [exact(source, loop, amount) for amount in amounts for loop in moved(source, amount)]
    found = [(points, bulges) for points, bulges in found if len(points) > 1]
    if not found:
        return None
    loops, bulges = zip(*found, strict=True)
    return Outline(loops=loops, bulges=bulges)


@individual
class Chain:
    """Lines and arcs and the corners between them, and the chords that stand for them.

    Parameters
    ----------
    points : (m, 2) float array
        Where chords start, loop by loop.
    offsets : (k + 1,) int array
    chord, joint : (m,) int arrays
        The piece that each chord is of, and the one that its start is of: a corner is a piece too.
    line : (p,) bool array
    centre : (p, 2) float array
        Of an arc or a corner; of a line its unit normal.
    radius : (p,) float array
        Of an arc, 0 of a corner; of a line the height along its normal.
    size : float
    """

    points: np.ndarray
    offsets: np.ndarray
    chord: np.ndarray
    joint: np.ndarray
    line: np.ndarray
    centre: np.ndarray
    radius: np.ndarray
    size: float

    def __len__(self):
        return len(self.points)


def edges(contour):
    """Corners (n, 2), offsets and bulges (n,) of a contour; one of curves has an arc over each of its chords."""
    if isinstance(contour, Outline):
        return contour.edges()
    section = contour.section()
    points, tops = section.points, contour.apexes() if hasattr(contour, "apexes") else None
    if tops is None:
        return points, section.offsets, np.zeros(len(points))
    chord = points[section.following] - points
    rise = tops - points - chord / 2
    turned = chord[:, 0] * rise[:, 1] - chord[:, 1] * rise[:, 0]
    bulges = -2 * turned / np.maximum(dot(chord, chord), np.finfo(float).tiny)
    return points, section.offsets, np.where(np.abs(bulges) > SMOOTH, bulges, 0.0)


def chained(contour):
    """The `Chain` of a contour."""
    start, offsets, bulges = edges(contour)
    ahead = following(offsets)
    end = start[ahead]
    whole = size(np.concatenate((start, apexes(start, end, bulges))))
    count = chords(start, end, bulges, FINE * whole)
    line, centre, radius = carriers(start, end, bulges)
    turns = np.abs(tangent_turns(start, end, bulges, ahead))
    before = np.empty_like(ahead)
    before[ahead] = np.arange(len(ahead))
    same = (line == line[before]) & (turns < SMOOTH)
    same &= (np.abs(centre - centre[before]).max(axis=1) < SAME * np.where(line, 1, whole)) | line
    same &= (np.abs(radius - radius[before]) < SAME * whole) | line
    piece = np.arange(len(start))
    for i in np.flatnonzero(same):  # in order: what goes on is of the piece before
        piece[i] = piece[before[i]]
    for i in np.flatnonzero(same & (piece != piece[before])):  # round the start of a loop
        piece[piece == piece[i]] = piece[before[i]]
    corner = np.where(turns < SMOOTH, piece, len(start) + np.arange(len(start)))
    first = np.cumsum(np.append(0, count))
    chord = np.repeat(piece, count)
    joint = chord.copy()
    joint[first[:-1]] = corner
    return Chain(
        points=arc_points(start, end, bulges, count),
        offsets=first[offsets],
        chord=chord,
        joint=joint,
        line=np.append(line, np.zeros(len(start), dtype=bool)),
        centre=np.concatenate((centre, start)),
        radius=np.append(radius, np.zeros(len(start))),
        size=whole,
    )


def carriers(start, end, bulges):
    """Of each edge whether it is a line, its normal or its centre, and its height or its radius."""
    chord = end - start
    length = np.hypot(*chord.T)
    normal = np.stack((chord[:, 1], -chord[:, 0]), axis=1) / length[:, None]
    line = bulges == 0
    safe = np.where(line, 1.0, bulges)
    away = length * (1 - safe**2) / (4 * safe)  # of the centre from the chord, to its left
    centre = (start + end) / 2 - away[:, None] * normal
    radius = length * (1 + safe**2) / (4 * np.abs(safe))
    return line, np.where(line[:, None], normal, centre), np.where(line, dot(normal, start), radius)


def moved(source, amount):
    """Loops of points (n, 2): the offset of the chords by Clipper."""
    manifold3d = library()
    sides = np.pi / np.arccos(max(1 - FINE * source.size / abs(amount), -1.0))
    region = manifold3d.CrossSection(np.split(source.points, source.offsets[1:-1]), manifold3d.FillRule.EvenOdd)
    sides = int(np.clip(np.ceil(sides), 16, MOST_SIDES))
    return region.offset(amount, manifold3d.JoinType.Round, circular_segments=sides).to_polygons()


def exact(source, loop, amount):
    """The lines and arcs of which a loop of chords (n, 2) is made: corners (k, 2) and bulges (k,).

    The offset of chords ends half a step before or after that of their arc, so that Clipper may round a corner which is
    hollow, or come to a piece that the arc hides. Once it is exact such a run goes backwards: it is left out, and those
    beside it end where they cross.
    """
    loop = np.asarray(loop)
    loop = loop[np.hypot(*(np.roll(loop, -1, axis=0) - loop).T) > 0]
    piece = nearest_pieces(source, (loop + np.roll(loop, -1, axis=0)) / 2)
    starts = long_runs(loop, piece, np.flatnonzero(piece != np.roll(piece, 1)), LEAST * source.size)
    places = loop[starts]
    while len(starts) > 1:
        runs = Runs.of(source, loop, starts, piece[starts], abs(amount))
        points = joints(places, runs.rolled(1), runs, abs(amount), source.size)
        turned = turns(loop, starts, runs.centre)
        angles = adjusted(points, runs.centre, turned)
        ways = [np.roll(part, -1, axis=0) - part for part in (points, loop[starts])]
        wrong = np.where(runs.line, dot(*ways) < 0, angles * turned < 0)
        if not wrong.any():
            return split(points, np.where(runs.line, 0.0, angles), runs.centre)
        ahead = np.roll(wrong, 1)
        kept = ~wrong
        places = np.where(ahead[:, None], np.roll(points, 1, axis=0), places)[kept]
        starts = starts[kept]
    return whole_circle(source, loop, piece[starts[0] if len(starts) else 0], abs(amount))


@individual
class Runs:
    """The pieces that the boundary of an offset follows, one after the other, each on one side.

    Parameters
    ----------
    line, centre, radius : arrays
        As `Chain` has them.
    side : (k,) float array
        1 where the offset is outside of the circle or along the normal of the line, else -1.
    """

    line: np.ndarray
    centre: np.ndarray
    radius: np.ndarray
    side: np.ndarray

    @classmethod
    def of(cls, source, loop, starts, piece, distance):
        middle = (starts + (np.roll(starts, -1) - starts) % len(loop) // 2) % len(loop)
        carriers = source.line[piece], source.centre[piece], source.radius[piece]
        far = away(*carriers, (loop[middle] + loop[(middle + 1) % len(loop)]) / 2)
        return cls(*carriers, np.where(far > 0, 1.0, -1.0))

    @property
    def corner(self):
        return ~self.line & (self.radius == 0)

    def rolled(self, by):
        return Runs(*(np.roll(getattr(self, name), by, axis=0) for name in self.__dataclass_fields__))

    def beside(self, places, distance):
        """Where places on the pieces come to by the offset."""
        return places + (distance * self.side)[:, None] * slope(self.line, self.centre, places)


def nearest_pieces(source, places):
    """The piece of which the nearest chord or joint is to each place: (n,) int array."""
    ahead = following(source.offsets)
    ends = np.stack((source.points, source.points[ahead], source.points[ahead]), axis=1)
    found = nearest(Tree.of(np.pad(ends, ((0, 0), (0, 0), (0, 1)))), np.pad(places, ((0, 0), (0, 1))))
    joint = np.where(found.parts == 4, found.faces, ahead[found.faces])
    return np.where(found.parts < 4, source.chord[found.faces], source.joint[joint])


def long_runs(loop, piece, starts, least):
    """The starts of those runs of one piece that are no rounding; those of one piece that then follow are one."""
    ends = np.roll(starts, -1)
    long = np.hypot(*(loop[ends] - loop[starts]).T) > least if len(starts) > 1 else np.ones(len(starts), dtype=bool)
    starts = starts[long]
    return starts[piece[starts] != piece[np.roll(starts, 1)]]


def away(line, centre, radius, places):
    """How far places are from lines and circles, on one side positive; the gradient is `slope`."""
    return np.where(line, dot(places, centre), np.hypot(*(places - centre).T)) - radius


def slope(line, centre, places):
    out = places - centre
    return np.where(line[:, None], centre, out / np.maximum(np.hypot(*out.T), np.finfo(float).tiny)[:, None])


def joints(places, one, other, distance, size):
    """Where the offsets of some runs and of others meet near places (n, 2).

    That of a piece and of its own corner touch beside the corner; there Newton's method would find half of the digits.
    """
    carriers = [(r.line, r.centre, r.radius + distance * r.side) for r in (one, other)]
    found, closest = meeting(places, *carriers), touching(places, *carriers)
    off = np.maximum(*(np.abs(away(*carrier, found)) for carrier in carriers))
    moved, least = (np.hypot(*(to - places).T) for to in (found, closest))
    lost = (off > SAME * size) | (moved > 2 * least + FINE * size)
    found[lost] = closest[lost]
    for corner, piece in ((one, other), (other, one)):
        off = np.abs(away(piece.line, piece.centre, piece.radius, corner.centre))
        beside = piece.beside(corner.centre, distance)
        own = corner.corner & (off < SAME * size) & (np.hypot(*(beside - places).T) < distance / 2)
        found[own] = beside[own]
    return found


def meeting(places, one, other):
    """Where lines or circles cross near places (n, 2), by Newton's method; anywhere if they only touch."""
    for _ in range(ROUNDS):
        f, g = away(*one, places), away(*other, places)
        a, b = slope(*one[:2], places), slope(*other[:2], places)
        turn = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
        step = np.stack((f * b[:, 1] - g * a[:, 1], g * a[:, 0] - f * b[:, 0]), axis=1)
        places = places - step / np.where(np.abs(turn) < PARALLEL, np.inf, turn)[:, None]
    return places


def touching(places, one, other):
    """The places nearest to others (n, 2) where lines or circles would touch, were they near enough to."""
    line = one[0][:, None]
    centre = np.where(line, other[1], one[1])
    radius = np.where(one[0], other[2], one[2])
    apart = other[1] - one[1]
    way = apart / np.maximum(np.hypot(*apart.T), np.finfo(float).tiny)[:, None]
    way = np.where(line, one[1], np.where(other[0][:, None], other[1], way))
    ends = [centre + sign * radius[:, None] * way for sign in (1, -1)]
    nearer = np.hypot(*(ends[0] - places).T) < np.hypot(*(ends[1] - places).T)
    found = np.where(nearer[:, None], *ends)
    steps = [away(*c, found)[:, None] * slope(*c[:2], found) for c in (one, other)]
    return found - (steps[0] + steps[1]) / 2


def turns(loop, starts, centre):
    """The angles (k,) by which runs of a loop turn about their centres."""
    run = np.searchsorted(starts, np.arange(len(loop)), side="right") - 1
    a, b = loop - centre[run], np.roll(loop, -1, axis=0) - centre[run]
    angle = np.arctan2(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0], dot(a, b))
    return np.bincount(run % len(starts), angle, len(starts))


def adjusted(points, centre, turned):
    """The angles from each point to the next about centres, whole turns as others (k,) have them."""
    a, b = points - centre, np.roll(points, -1, axis=0) - centre
    angle = np.arctan2(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0], dot(a, b))
    return angle + 2 * np.pi * np.round((turned - angle) / (2 * np.pi))


def split(points, angles, centre):
    """Corners and bulges of arcs of some angles, those of more than half a turn in two."""
    large = np.flatnonzero(np.abs(angles) > HALF_TURN)
    x, y = (points - centre)[large].T
    cos, sin = np.cos(angles[large] / 2), np.sin(angles[large] / 2)
    middles = centre[large] + np.stack((cos * x - sin * y, sin * x + cos * y), axis=1)
    angles = angles.copy()
    angles[large] /= 2
    return np.insert(points, large + 1, middles, axis=0), np.tan(np.insert(angles, large + 1, angles[large]) / 4)


def whole_circle(source, loop, piece, distance):
    """The corners and bulges of a loop that is one circle."""
    centre, out = source.centre[piece], np.hypot(*(loop - source.centre[piece]).T).mean()
    radius = source.radius[piece] + (distance if out > source.radius[piece] else -distance)
    ways = np.array([(1.0, 0.0), (-1.0, 0.0)])
    left = turns(loop, np.zeros(1, dtype=int), centre[None])[0] > 0
    return centre + abs(radius) * ways, np.full(2, 1.0 if left else -1.0)

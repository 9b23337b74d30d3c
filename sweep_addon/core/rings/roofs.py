# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Roofs: the faces that the edges of a drafted section leave where some vanish, part or join on their way.

Each edge leaves one plane face, with as many corners as anything happened at its ends. Its border is known from the
wavefront: the ways of vertices, upwards on its right, downwards on its left; the edge itself; and the ridges and levels
where it ended, backwards. Each of these borders two faces, so the surface is closed whatever happened.
"""

from functools import lru_cache
from math import atan2, pi

import numpy as np

from ..contours.section import Section
from ..declared.frozen import individual
from ..declared.parameters import ShapeError
from ..grids.laying import CAP, SIDE
from ..meshes.mesh import Topology
from ..meshes.runs import following
from ..progress import within
from ..vectors import dot
from . import caps
from .events import ALIKE, followed
from .wavefront import UNDECIDED, Wavefront

MOST = 4096  # points of a section: each is looked at beside each edge
LOOKED = 0.4  # of the time of a roof of many points: after it all know what they meet
MOST_NODES = 1_000_000  # of all steps, a hundredth of a millisecond each
BOTTOM, TOP = -1, -2  # the source of the faces of caps
CORNER = np.cos(np.radians(20))  # edges that turn by more are sharp, as those of a section


@individual
class Roof:
    """The surface of a section drafted down and up from its plane.

    Parameters
    ----------
    nodes : (n, 3) float array
        Its vertices, x and y as in the section's plane, z the height.
    topology : Topology
    source : (f,) int array
        The edge of the section that each face is of; -1 of a cap at the start, -2 of one at the end.
    gone : tuple of two float
        The heights, downwards and upwards, at which nothing is left; infinite where something is.
    levels : dict of float to list of (k, 2) arrays
        The loops of the contour at the heights that were asked for; none where all is gone.
    """

    nodes: np.ndarray
    topology: Topology
    source: np.ndarray
    gone: tuple
    levels: dict


@lru_cache(maxsize=16)
def roof(section, slopes, heights, closed, listener):
    """The surface that a section leaves.

    Parameters
    ----------
    section : Section
        Closed.
    slopes : tuple of float
        The tangent of the taper of each loop.
    heights : tuple of float
        Rising, those at which faces are cut, 0 among them.
    closed : tuple of two bool
        Whether caps close the start and the end.
    listener : Listener
        Is told which part is done, from 0 to 1; what it raises ends the work.

    Returns
    -------
    Roof

    Raises
    ------
    ShapeError
        Where it is not defined, or rounding decides what meets.

    Examples
    --------
    The hip roof of a rectangle, two trapezoids and two triangles:

    >>> from ..contours import Rectangle
    >>> from ..progress import Listener
    >>> hipped = roof(Rectangle(3, 2).section(), (1.0,), (0.0, 1.0), (True, True), Listener())
    >>> np.diff(hipped.topology.offsets).tolist(), hipped.nodes[4:].tolist()
    ([4, 4, 3, 4, 3], [[-0.5, 0.0, 1.0], [0.5, 0.0, 1.0]])
    """
    speeds, flat = np.array(slopes)[section.loop_of], np.zeros((len(section.points), 1))
    nodes, faces, gone = [np.concatenate((section.points, flat), axis=1)], [], []
    levels = {0.0: np.split(section.points, section.offsets[1:-1])}
    for number, (side, shut) in enumerate(zip((-1, 1), closed, strict=True)):
        progress = within(listener.tell, number / 2 * (heights[0] < 0), (number + 1) / 2 if heights[-1] > 0 else 1.0)
        asked = sorted(side * height for height in heights if side * height > 0)
        if not asked:
            faces += cap_of(section, np.arange(len(section.points)), side) if shut else []
            gone.append(np.inf)
            continue
        front = Wavefront(section, speeds, asked[-1], within(progress, 0.0, LOOKED))
        gone.append(followed(front, asked, within(progress, LOOKED, 1.0)))
        places, first = np.array(front.nodes), sum(map(len, nodes))
        faces += risen(front, section, places, first, side, shut)
        nodes.append(places[len(section.points) :] * (1, 1, side))
        levels.update((side * height, loops) for height, loops in loops_of(front, places).items())
    listener.leave()
    return drawn(section, np.concatenate(nodes), faces, tuple(gone), levels)


def risen(front, section, places, first, side, shut):
    """The faces that a wavefront leaves upwards or, mirrored, downwards, and its cap if it is to be shut.

    Parameters
    ----------
    front : Wavefront
    section : Section
    places : (n, 3) float array
        Its nodes, those of the section first.
    first : int
        The number in the whole surface of its first node that is not of the section.
    side : int
        1 upwards, -1 downwards.
    shut : bool

    Returns
    -------
    list of (int, list of int)
        The source of each face, and the numbers of its corners.
    """
    count = len(section.points)
    number = np.concatenate((np.arange(count), first + np.arange(len(places) - count)))[merged(front, places, count)]
    found = [(source, loop[::side]) for source, loop in faces_of(front, section, number, places)]
    if not shut or not front.alive.any():
        return found
    loops = [part for loop in front.loops() for part in simple(number[front.node[loop]].tolist())]
    at = dict(zip(number[front.node[front.living()]].tolist(), front.living().tolist(), strict=True))
    numbers = np.concatenate(loops)
    points = front.at(np.array([at[node] for node in numbers.tolist()]), front.now)
    offsets = np.concatenate(([0], np.cumsum([len(loop) for loop in loops])))
    end = Section(points, offsets, np.full(len(points), False))
    if (end.areas > 0).all():
        return found + [(TOP if side > 0 else BOTTOM, loop[::side]) for loop in loops]
    if len(at) < len(numbers):
        raise ShapeError("must not end just where a hole touches: a little more or less will do")
    return found + cap_of(end, numbers, side)


def merged(front, places, count):
    """For each node the one that stands for it: those that edges shorter than single precision tells join are one."""
    pairs = np.array([each[:2] for kind in (front.rises, front.ridges, front.levels) for each in kind], dtype=int)
    lengths = np.linalg.norm(places[pairs[:, 0]] - places[pairs[:, 1]], axis=1)
    kept = list(range(len(places)))

    def found(node):
        while kept[node] != node:
            node = kept[node]
        return node

    for pair in np.flatnonzero(lengths <= ALIKE * front.size).tolist():
        low, high = sorted(map(found, pairs[pair].tolist()))
        if high >= count:  # points of the section stay apart
            kept[high] = low
    return np.array([found(node) for node in kept])


def faces_of(front, section, number, places):
    """The faces of a wavefront: pairs of the edge and the loop of its corners, seen from outside if z is upwards."""
    halves = {}
    for node, after in enumerate(section.following.tolist()):
        halves.setdefault((node, 0), []).append((node, after))
    for low, high, into, out, band in front.rises:
        halves.setdefault((into, band), []).append((low, high))
        halves.setdefault((out, band), []).append((high, low))
    for start, end, source, back, band in front.ridges:
        halves.setdefault((source, band), []).append((end, start))
        halves.setdefault((back, band), []).append((start, end))
    for start, end, source, band in front.levels:
        halves.setdefault((source, band), []).append((end, start))
        if band < front.rises[-1][-1]:
            halves.setdefault((source, band + 1), []).append((start, end))
    for (source, _), some in halves.items():
        for loop in traced(some, places, front.ways[source]):
            yield from ((source, part) for part in simple(number[loop].tolist()))


def traced(halves, places, way):
    """The loops of directed edges of one plane; where several leave a node, the one that closes the nearest wedge."""
    leaving, found = {}, []
    for start, end in halves:
        leaving.setdefault(start, []).append(end)

    def angle(start, end):
        x, y, height = places[end] - places[start]
        return atan2(height, x * way[0] + y * way[1])

    while leaving:
        loop = [next(iter(leaving))]
        while True:
            here = loop[-1]
            ends = leaving.get(here)
            if not ends:
                raise ShapeError(UNDECIDED)
            after = ends[0]
            if len(ends) > 1:
                back = angle(here, loop[-2]) if len(loop) > 1 else 0.0
                wedges = [(back - angle(here, end) - 1e-9) % (2 * pi) for end in ends]
                after = ends[wedges.index(min(wedges))]
            ends.remove(after)
            if not ends:
                del leaving[here]
            if after == loop[0]:
                break
            loop.append(after)
        found.append(loop)
    return found


def simple(loop):
    """The parts of a loop that come by each node once and have an area: what leads there and back again is none."""
    stack, place = [], {}
    for node in loop:
        if node in place:
            part = stack[place[node] :]
            for gone in part:
                del place[gone]
            del stack[-len(part) :]
            if len(part) > 2:
                yield part
        place[node] = len(stack)
        stack.append(node)
    if len(stack) > 2:
        yield stack


def loops_of(front, places):
    """The loops at each height where a wavefront was stopped: dict of float to list of (k, 2) arrays."""
    found, bands = {}, {}
    for start, end, _, band in front.levels:
        bands.setdefault(band, []).append((start, end))
    for pairs in bands.values():
        after, loops = dict(pairs), []
        while after:
            first, node = next(iter(after.items()))
            loop = [first]
            del after[first]
            while node != first:
                loop.append(node)
                node = after.pop(node)
            loops.append(places[loop, :2])
        found[float(places[pairs[0][0], 2])] = loops
    return found


def cap_of(section, numbers, side):
    """The faces that close an end whose points have these numbers, as `risen` gives them."""
    points, offsets = caps.faces(section)
    loops = np.split(numbers[list(points)], offsets[1:-1])
    return [(TOP if side > 0 else BOTTOM, loop[::side].tolist()) for loop in loops]


def drawn(section, nodes, faces, gone, levels):
    """The roof of the loops of nodes, and of their sources."""
    used, corners = np.unique(np.concatenate([loop for _, loop in faces]), return_inverse=True)
    offsets = np.concatenate(([0], np.cumsum([len(loop) for _, loop in faces])))
    source = np.array([source for source, _ in faces])
    start, end = corners.astype(np.int64), corners[following(offsets)].astype(np.int64)
    low, high = np.minimum(start, end), np.maximum(start, end)
    keys, edge = np.unique(low * len(used) + high, return_inverse=True)
    uses = np.stack([np.bincount(edge, way, len(keys)) for way in (start < end, start > end)])
    if (uses > 1).any():
        raise ShapeError(UNDECIDED)
    each, alone = np.repeat(source, np.diff(offsets)), (uses == 0).any(axis=0)
    beside = np.zeros((2, len(keys)), dtype=int)
    for side, way in enumerate((start < end, start > end)):
        beside[:, edge[way & alone[edge]]] = each[way & alone[edge]]
        beside[side, edge[way & ~alone[edge]]] = each[way & ~alone[edge]]
    edges = np.stack((keys // len(used), keys % len(used)), axis=1)
    topology = Topology(
        corners=corners.astype(np.int32),
        offsets=offsets.astype(np.int32),
        edges=edges.astype(np.int32),
        corner_edges=edge.astype(np.int32),
        sharp=sharp(section, beside, nodes[used, 2][edges]) | alone,
        material=np.where(source < 0, CAP, SIDE).astype(np.int32),
    )
    return Roof(nodes[used], topology, source, gone, levels)


def sharp(section, sources, heights):
    """Which edges between faces of two sources (2, e), their ends at heights (e, 2), are sharp.

    Those of caps and of the plane of the contour are, and those where the contour turns.
    """
    one, other = sources
    ways = (section.points[section.following] - section.points) / section.edge_lengths[:, None]
    turned = dot(ways[one], ways[other]) < CORNER
    for before, after in ((one, other), (other, one)):
        corner = section.following[before] == after
        turned = np.where(corner, section.sharp[after], turned)
    return turned | (sources < 0).any(axis=0) | (heights == 0).all(axis=1)

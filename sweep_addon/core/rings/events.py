# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Events of a wavefront: what meets at one height is welded, split where it lies on others, and linked anew.

All that is nearer than a tolerance at a height meets at once: an arc that shrinks to a point, walls that fall together,
corners of a symmetric outline. So there are no cases: points that meet are one node; edges are split at nodes that lie
on them; edges without length are gone; an edge and another one back along it are a ridge; and what is left at a node is
linked so that, where area vanishes, each wedge of area is one corner, and where it grows, each wedge between.
"""

from itertools import pairwise
from math import atan2, pi

import numpy as np

from ..declared.parameters import ShapeError
from ..progress import unheard
from .meetings import Meeting
from .wavefront import PARALLEL, TOUCHING, UNDECIDED

ALIKE = 1e-6  # of the size: at a height where faces end, what Blender's single precision hardly tells apart
NARROW = 1e-3  # radians: what is looked at for edges that lie on each other but for a tolerance


def followed(front, heights, progress=unheard):
    """Follow a wavefront up to rising heights, and stop it at each.

    Parameters
    ----------
    front : Wavefront
    heights : sequence of float
    progress : callable, optional
        Is told how much of the last height is behind, from 0 to 1; what it raises ends the work.

    Returns
    -------
    float
        The height at which all is gone; infinite where something is left.

    Examples
    --------
    The roof of a rectangle 3 m long and 2 m wide has one ridge:

    >>> from ..contours import Rectangle
    >>> from .wavefront import Wavefront
    >>> front = Wavefront(Rectangle(3, 2).section(), np.ones(4), 2.0)
    >>> followed(front, [0.5, 2.0]), len(front.ridges)
    (1.0, 1)
    """
    for height in heights:
        while (coming := front.due()) <= height:
            happen(front, coming, TOUCHING * front.size)
            progress(coming / heights[-1])
        while happen(front, height, ALIKE * front.size):
            pass
        progress(height / heights[-1])
        if not front.alive.any():
            return front.nodes[-1][2]
        front.stop(height)
    return np.inf


def happen(front, height, room):
    """All that happens at a height, of what is that near: whether there was anything."""
    front.now = height
    meeting = Meeting(front, room)
    meeting.shrunk()
    meeting.reached()
    if not meeting.group_of:
        return False
    pieces = Pieces(meeting)
    while pieces.go_on():
        front.count_event()
    front.count_event()
    pieces.settle()
    return True


class Piece:
    """A part of an edge: from a vertex to a vertex, or where groups meet -1 - their number instead."""

    def __init__(self, start, end, source, edge):
        self.start, self.end, self.source, self.edge = start, end, source, edge
        self.first, self.last = start, end  # the vertices


class Pieces:
    """The pieces of edges around a meeting, and what becomes of them."""

    def __init__(self, meeting):
        self.meeting, self.front = meeting, meeting.front
        self.pieces, self.ridges = [], []

    def go_on(self):
        """Weld what lies together, cancel what lies on each other: whether more meets than was known."""
        self.meeting.together()
        self.lay()
        return self.cancelled() or self.spiked()

    def reference(self, vertex):
        """What stands for a vertex as the end of a piece."""
        group = self.meeting.group_of.get(vertex)
        return vertex if group is None else -1 - group

    def lay(self):
        """All pieces of edges that something happens to."""
        front, meeting = self.front, self.meeting
        edges = {*meeting.splits, *meeting.group_of, *(int(front.behind[vertex]) for vertex in meeting.group_of)}
        self.pieces = []
        for edge in sorted(edges):
            source = int(front.out[edge])
            groups = [(float(front.ways[source] @ meeting.places[n]), -1 - n) for n in meeting.splits.get(edge, ())]
            between = [end for _, end in sorted(groups)]
            ends = [self.reference(edge), *between, self.reference(int(front.ahead[edge]))]
            self.pieces += [Piece(a, b, source, edge) for a, b in pairwise(ends) if a != b]

    def cancelled(self):
        """Take out pairs of pieces of which one leads back along the other: whether one ends where nothing happened."""
        found, self.ridges = {}, []
        for piece in self.pieces:
            back = found.get((piece.end, piece.start))
            if back:
                self.ridges.append((back.pop(), piece))
                if not back:
                    del found[piece.end, piece.start]
            else:
                found.setdefault((piece.start, piece.end), []).append(piece)
        self.pieces = [piece for some in found.values() for piece in some]
        loose = {end for one, _ in self.ridges for end in (one.start, one.end) if end >= 0}
        for vertex in loose:
            self.meeting.group(vertex)
        return bool(loose)

    def spiked(self):
        """Find pieces that begin to run along each other: the longer one is split where the shorter one ends."""
        for leaving, entering in self.corners().values():
            for out in leaving:
                for into in entering:
                    if self.beside(out.source, into.source) and self.split_spike(out, into):
                        return True
        return False

    def beside(self, one, other):
        """Whether two edges lead nearly opposite ways, and may meet."""
        front = self.front
        opposite = front.ways[one] @ front.ways[other] < 0 and front.speeds[one] + front.speeds[other] != 0
        return opposite and abs(front.ways[one] @ front.normals[other]) <= NARROW

    def split_spike(self, out, into):
        """Split the longer one of two pieces, one out of a node and one into it, at the end of the other: whether it
        lies on it."""
        meeting, ends = self.meeting, (out.end, into.start)
        here = meeting.places[-1 - out.start]
        reach = [(meeting.places[-1 - end] if end < 0 else meeting.place(end)) - here for end in ends]
        lengths = [float(np.hypot(*each)) for each in reach]
        shorter = int(lengths[1] < lengths[0])
        longer = (into, out)[shorter]
        same = abs(lengths[0] - lengths[1]) <= meeting.near
        off = abs(reach[shorter] @ self.front.normals[longer.source]) > meeting.near
        if off or (same and ends[0] == ends[1]):
            return False
        if same:
            meeting.merge(*(-1 - end if end < 0 else meeting.group(end) for end in ends))
        else:
            end = ends[shorter]
            meeting.splits.setdefault(longer.edge, set()).add(-1 - end if end < 0 else meeting.group(end))
        return True

    def corners(self):
        """The pieces that lead out of each group and into it: dict of pairs of lists."""
        found = {}
        for piece in self.pieces:
            if piece.start < 0:
                found.setdefault(piece.start, ([], []))[0].append(piece)
            if piece.end < 0:
                found.setdefault(piece.end, ([], []))[1].append(piece)
        return found

    def settle(self):
        """End what has met, and begin what goes on from there."""
        front, meeting = self.front, self.meeting
        node = {}
        for number, place in meeting.places.items():
            node[-1 - number] = len(front.nodes)
            front.nodes.append((*place.tolist(), front.now))
        for one, back in self.ridges:
            front.ridges.append((node[one.start], node[one.end], one.source, back.source, front.band))
        for vertex, number in meeting.group_of.items():
            front.ended(vertex, node[-1 - number])
        links = {place: self.linked(*ends) for place, ends in self.corners().items()}
        self.unite(links)
        fresh = []
        for place, pairs in links.items():
            known = {piece.source for pair in pairs for piece in pair}
            for into, out in pairs:
                if into is not out:
                    into.last = out.first = front.born(node[place], into.source, out.source)
                    fresh.append((into.last, known))
        self.lead_on()
        for vertex, known in fresh:
            front.watch_lines(vertex, known)

    def linked(self, leaving, entering):
        """Pair the pieces that lead into a node with those that lead out of it: each pair is a corner from now on."""
        if len(leaving) != len(entering):
            raise ShapeError(UNDECIDED)
        if len(leaving) == 1:
            return [(entering[0], leaving[0])]
        front = self.front
        sense = 1 if sum(front.speeds[piece.source] for piece in leaving + entering) >= 0 else -1

        def wedge(into, out):
            """The angle of the area between a way out and a way back; where area grows, of what is not area."""
            back, away = -front.ways[into.source], front.ways[out.source]
            return (sense * (atan2(back[1], back[0]) - atan2(away[1], away[0])) - PARALLEL) % (2 * pi)

        pairs = [(min(entering, key=lambda into, out=out: wedge(into, out)), out) for out in leaving]
        if len({id(into) for into, _ in pairs}) < len(pairs):
            raise ShapeError(UNDECIDED)
        return pairs

    def unite(self, links):
        """Make one piece of two of one edge that meet again: their pair is then a piece and itself, and no corner."""
        for place, pairs in links.items():
            for number, (into, out) in enumerate(pairs):
                if into.source == out.source and into is not out:
                    into.end = into.last = out.end
                    self.pieces.remove(out)
                    pairs[number] = (into, into)
                    if out.end in links:
                        links[out.end] = [(into if i is out else i, o) for i, o in links[out.end]]
                        pairs = links[place]

    def lead_on(self):
        """Lead each piece from its first vertex to its last."""
        front = self.front
        for piece in self.pieces:
            front.ahead[piece.first], front.behind[piece.last] = piece.last, piece.first
        if self.pieces:
            front.watch_edges(np.array([piece.first for piece in self.pieces]))

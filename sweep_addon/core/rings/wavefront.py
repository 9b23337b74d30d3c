# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The wavefront of a drafted section: its edges on their way inwards, beyond those that vanish, part and join.

Every edge stays on a line that moves parallel to itself, so each vertex moves evenly along the bisector of two lines
until something happens: an edge has no length left, or a vertex reaches an edge that is not its own. What becomes of
the contour there is decided by `events`. What is kept is where vertices were born and ended, and between which lines:
the edges of a polyhedron whose faces are those that the lines leave behind.
"""

import numpy as np

from ..declared.parameters import ShapeError
from ..progress import unheard
from ..vectors import dot

TOUCHING = 1e-9  # of the size: what is nearer has met
PARALLEL = 1e-9  # the sine of the angle between lines that never meet
SURE = 1e-5  # of the size: what is farther apart does not meet, however it rounds
BEYOND = 1.001  # times the height: what happens hardly beyond it is taken to be there
FEW = 100  # vertices end until edges of which nothing is left are looked for
MOST_EVENTS = 8  # for each edge: a contour has fewer, so rounding goes round in circles
UNDECIDED = "must not lead edges to where rounding decides how they meet"
NONE = np.zeros(0), np.zeros(0), np.zeros(0, dtype=int)  # of lines: when they are reached, how fast, and their edges
KEPT = {  # of each vertex: its shape, and what stands for none
    "place": ((2,), 0.0),  # where it was born
    "since": ((), 0.0),  # at which height
    "velocity": ((2,), 0.0),
    "into": ((), 0),  # the edge before it and the one after it
    "out": ((), 0),
    "ahead": ((), 0),  # the vertices at their other ends
    "behind": ((), 0),
    "node": ((), 0),
    "alive": ((), False),
    "vanish": ((), np.inf),  # when the edge after it has no length left, and how fast it shrinks
    "shrink": ((), 1.0),
    "reach": ((), np.inf),  # when it reaches the next line, and how fast it gets nearer
    "closing": ((), 1.0),
    "passed": ((), 0),  # how many lines that it comes to are behind it
}


class Wavefront:
    """The edges of a section as they move, each by its own speed.

    Parameters
    ----------
    section : Section
        Closed.
    speeds : (m,) float array
        How far each edge moves to its left in a metre of height.
    highest : float
        The height up to which it is followed.
    progress : callable, optional
        Is told which part of the vertices has looked for what it meets, from 0 to 1; what it raises ends the work.

    Attributes
    ----------
    nodes : list of (x, y, height)
        Where something happened; first the points of the section.
    rises : list of (node, node, edge, edge, band)
        The way of each vertex from its birth to its end, the edge before it and the edge after it.
    ridges : list of (node, node, edge, edge, band)
        Where two edges came to lie on each other, the first one forwards.
    levels : list of (node, node, edge, band)
        The edges as they were where the wavefront was stopped; bands are counted from stop to stop.
    """

    def __init__(self, section, speeds, highest, progress=unheard):
        edges = section.points[section.following] - section.points
        self.ways = edges / section.edge_lengths[:, None]
        self.normals = self.ways[:, ::-1] * (-1, 1)
        self.offsets, self.speeds = dot(self.normals, section.points), speeds
        self.size, self.highest, self.now, self.band = section.size, highest, 0.0, 0
        self.nodes = [(x, y, 0.0) for x, y in section.points.tolist()]
        self.rises, self.ridges, self.levels = [], [], []
        count = len(section.points)
        self.edges_left, self.among, self.gone_since = np.arange(count), np.arange(count), 0
        self.count, self.left, self.coming = 0, MOST_EVENTS * count, []
        self.room(4 * count)
        self.lying = [set() for _ in range(count)]  # the vertices from which pieces of each edge lead on
        behind = np.empty(count, dtype=int)
        behind[section.following] = np.arange(count)
        for node in range(count):
            self.born(node, behind[node], node)
        self.ahead[:count], self.behind[:count] = section.following, behind
        everything = np.arange(count)
        self.watch_edges(everything)
        for vertex in range(count):
            self.watch_lines(vertex)
            progress((vertex + 1) / count)

    def room(self, count):
        """Make room for so many vertices."""
        for name, (shape, empty) in KEPT.items():
            new = np.full((count, *shape), empty)
            if self.count:
                new[: self.count] = getattr(self, name)[: self.count]
            setattr(self, name, new)
        self.coming += [NONE] * (count - len(self.coming))

    def born(self, node, into, out):
        """A vertex that begins at a node between two edges, one that leads into it and one out of it: its number."""
        vertex = self.count
        if vertex == len(self.place):
            self.room(2 * vertex)
        self.count += 1
        x, y, self.since[vertex] = self.nodes[node]
        self.place[vertex], self.velocity[vertex] = (x, y), self.bisecting(into, out)
        self.into[vertex], self.out[vertex], self.node[vertex] = into, out, node
        self.alive[vertex] = True
        self.lying[out].add(vertex)
        return vertex

    def bisecting(self, into, out):
        """How fast the point moves in which two lines meet: (2,) in metres for each metre of height."""
        before, after, mean = self.normals[into], self.normals[out], (self.speeds[into] + self.speeds[out]) / 2
        across, along = before + after, before - after
        unlike = (self.speeds[into] - self.speeds[out]) / 2
        wide, narrow = across @ across, along @ along
        if wide <= PARALLEL**2 or (unlike and narrow <= PARALLEL**2):
            raise ShapeError("must be equal for loops whose edges meet in parallel")
        moved = 2 * mean / wide * across
        return moved + 2 * unlike / narrow * along if unlike else moved

    def at(self, vertices, height):
        """Where vertices (n,) are at a height: (n, 2)."""
        return self.place[vertices] + (height - self.since[vertices])[:, None] * self.velocity[vertices]

    def watch_edges(self, vertices):
        """Find when the edges that begin at some vertices have no length left."""
        ahead, way = self.ahead[vertices], self.ways[self.out[vertices]]
        length = dot(way, self.at(ahead, self.now) - self.at(vertices, self.now))
        shrink = -dot(way, self.velocity[ahead] - self.velocity[vertices])
        shrinks = shrink > PARALLEL * (np.abs(self.velocity[ahead]).sum(1) + np.abs(self.velocity[vertices]).sum(1))
        self.shrink[vertices] = np.where(shrinks, shrink, 1.0)
        self.vanish[vertices] = np.where(shrinks, self.now + length / self.shrink[vertices], np.inf)

    def watch_lines(self, vertex, known=()):
        """Find when a vertex reaches the lines of edges, but for those that are known to be where it begins.

        A hollow corner can run into an edge that lies before it, the area between; a corner can run into one from
        outside. Others meet no edge before its ends.
        """
        into, out = self.into[vertex], self.out[vertex]
        turn = self.ways[into] @ self.normals[out]
        there = self.there()
        normals, speeds = self.normals[there], self.speeds[there]
        distance = normals @ self.at(np.array([vertex]), self.now)[0] - self.offsets[there] - speeds * self.now
        away = normals @ self.velocity[vertex] - speeds
        room = TOUCHING * self.size
        meets = (turn >= -PARALLEL) & (distance > -room) & (away < 0)
        meets |= (turn <= PARALLEL) & (distance < room) & (away > 0)
        own = self.among[[into, out, *known]]
        meets[own[own >= 0]] = False
        which = np.flatnonzero(meets)
        when = self.now - distance[which] / away[which]
        soon = np.flatnonzero(when <= BEYOND * self.highest)
        soon = soon[np.argsort(when[soon], kind="stable")]
        which = which[soon]
        self.coming[vertex], self.passed[vertex] = (when[soon], np.abs(away[which]), there[which]), 0
        self.look(vertex)

    def there(self):
        """The edges of which a piece is left: (k,) int array."""
        if self.gone_since > FEW:
            self.edges_left = np.flatnonzero([bool(pieces) for pieces in self.lying])
            self.among[:] = -1
            self.among[self.edges_left] = np.arange(len(self.edges_left))
            self.gone_since = 0
        return self.edges_left

    def look(self, vertex):
        """The next line that a vertex reaches."""
        (when, closing, _), number = self.coming[vertex], self.passed[vertex]
        some = number < len(when)
        self.reach[vertex], self.closing[vertex] = (when[number], closing[number]) if some else (np.inf, 1.0)

    def passes(self, vertex):
        """The line that a vertex reaches next, which is then behind it."""
        source = int(self.coming[vertex][2][self.passed[vertex]])
        self.passed[vertex] += 1
        self.look(vertex)
        return source

    def ended(self, vertex, node):
        """A vertex ends at a node."""
        self.rises.append((int(self.node[vertex]), node, int(self.into[vertex]), int(self.out[vertex]), self.band))
        self.alive[vertex] = False
        self.vanish[vertex] = self.reach[vertex] = np.inf
        self.lying[self.out[vertex]].discard(vertex)
        self.gone_since += 1
        self.coming[vertex] = NONE

    def count_event(self):
        """Refuse more events than edges can have."""
        self.left -= 1
        if self.left < 0:
            raise ShapeError(UNDECIDED)

    def due(self):
        """The height at which something happens next, or infinite; lines reached beside their edges are passed over."""
        some = slice(self.count)
        vanishing = float(self.vanish[some].min())
        while True:
            vertex = int(self.reach[some].argmin())
            height = float(self.reach[vertex])
            if height >= vanishing or self.meets(vertex, height):
                return max(self.now, min(vanishing, height))
            self.passes(vertex)

    def meets(self, vertex, height):
        """Whether a piece of an edge may be where a vertex reaches its line: it is not far off."""
        source = int(self.coming[vertex][2][self.passed[vertex]])
        (x, y), room = self.ways[source].tolist(), SURE * self.size

        def along(vertex):
            lasted = height - self.since[vertex]
            place, velocity = self.place[vertex], self.velocity[vertex]
            return x * (place[0] + lasted * velocity[0]) + y * (place[1] + lasted * velocity[1])

        here = along(vertex)
        return any(along(piece) - room <= here <= along(int(self.ahead[piece])) + room for piece in self.lying[source])

    def living(self):
        """The vertices that are there: (n,) int array."""
        return np.flatnonzero(self.alive[: self.count])

    def stop(self, height):
        """End all vertices at a height, and begin as many there: the faces are cut."""
        self.now = height
        living = self.living()
        nodes = np.arange(len(self.nodes), len(self.nodes) + len(living))
        self.nodes += [(x, y, height) for x, y in self.at(living, height).tolist()]
        into, out = self.into[living].tolist(), self.out[living].tolist()
        self.rises += [
            (*each, self.band)
            for each in zip(self.node[living].tolist(), nodes.tolist(), into, out, strict=True)
        ]  # fmt: skip
        self.node[living] = nodes
        heads = self.node[self.ahead[living]].tolist()
        self.levels += [(*each, self.band) for each in zip(nodes.tolist(), heads, out, strict=True)]
        self.band += 1

    def loops(self):
        """The loops of living vertices, each in order: list of lists."""
        left, found = dict.fromkeys(self.living().tolist()), []
        while left:
            loop = [next(iter(left))]
            while (after := int(self.ahead[loop[-1]])) != loop[0]:
                loop.append(after)
            found.append(loop)
            for vertex in loop:
                del left[vertex]
        return found

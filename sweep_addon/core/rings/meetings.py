# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meetings of a wavefront: which of its vertices are at one place at a height, and which lie on edges of others."""

import numpy as np

NEAR = 10  # tolerances: what moves fast is as far apart when it meets


class Meeting:
    """What meets at the height where a wavefront is.

    Parameters
    ----------
    front : Wavefront
    room : float
        How near is together, in metres.

    Attributes
    ----------
    group_of : dict of int to int
        The number of the group of each vertex that meets others.
    groups : list of list of int
        The vertices of each group; empty where they have come to another one.
    splits : dict of int to set of int
        Which groups lie on the edge that begins at a vertex, between its ends.
    places : dict of int to (2,) array
        Where each group is.
    """

    def __init__(self, front, room):
        self.front, self.room, self.near = front, room, NEAR * room
        self.group_of, self.groups, self.splits, self.places = {}, [], {}, {}

    def place(self, vertex):
        """Where a vertex is now: (2,)."""
        front = self.front
        return front.place[vertex] + (front.now - front.since[vertex]) * front.velocity[vertex]

    def group(self, vertex):
        """The number of the group of a vertex, a new one if it has none."""
        if vertex not in self.group_of:
            self.group_of[vertex] = len(self.groups)
            self.groups.append([vertex])
        return self.group_of[vertex]

    def weld(self, one, other):
        """Make one group of those of two vertices."""
        kept, gone = self.group(one), self.group(other)
        if kept != gone:
            self.merge(kept, gone)

    def merge(self, kept, gone):
        """Make one group of two."""
        for vertex in self.groups[gone]:
            self.group_of[vertex] = kept
        self.groups[kept] += self.groups[gone]
        self.groups[gone] = []
        self.splits = {e: {kept if g == gone else g for g in groups} for e, groups in self.splits.items()}

    def shrunk(self):
        """Weld the ends of edges that have no length left."""
        front, some = self.front, slice(self.front.count)
        near = (front.vanish[some] - front.now) * front.shrink[some] <= self.room
        for vertex in np.flatnonzero(near).tolist():
            self.weld(vertex, int(front.ahead[vertex]))

    def reached(self):
        """Split edges at vertices that reach them, or weld these to their ends."""
        front, some = self.front, slice(self.front.count)
        near = (front.reach[some] - front.now) * front.closing[some] <= self.room
        for vertex in np.flatnonzero(near).tolist():
            while (front.reach[vertex] - front.now) * front.closing[vertex] <= self.room:
                self.touch(vertex, front.passes(vertex))

    def touch(self, vertex, source):
        """A vertex is on the line of an edge: weld or split the piece that it is on, if any."""
        front, way = self.front, self.front.ways[source]
        here, near = float(way @ self.place(vertex)), self.near
        for piece in sorted(front.lying[source]):
            end = int(front.ahead[piece])
            low, high = float(way @ self.place(piece)), float(way @ self.place(end))
            if vertex in (piece, end) or not low - near <= here <= high + near:
                continue
            if min(here - low, high - here) > near:
                self.splits.setdefault(piece, set()).add(self.group(vertex))
            else:
                self.weld(vertex, piece if here - low <= near else end)

    def together(self):
        """Find the places of groups; those at one place are one."""
        while True:
            numbers = [number for number, group in enumerate(self.groups) if group]
            self.places = {n: self.front.at(np.array(self.groups[n]), self.front.now).mean(axis=0) for n in numbers}
            pair = self.near_pair(sorted(numbers, key=lambda n: float(self.places[n][0])))
            if not pair:
                return
            self.merge(*pair)

    def near_pair(self, numbers):
        """Two groups at one place, of those that are sorted by x; or None."""
        places = np.array([self.places[number] for number in numbers])
        for ahead in range(1, len(numbers)):  # of a comb across x many are at one x
            x, y = (places[ahead:] - places[:-ahead]).T
            if not (x <= self.near).any():
                break
            together = np.flatnonzero((x <= self.near) & (np.abs(y) <= self.near))
            if len(together):
                pair = numbers[together[0]], numbers[together[0] + ahead]
                return min(pair), max(pair)
        return None

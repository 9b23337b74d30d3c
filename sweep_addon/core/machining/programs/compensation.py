# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compensation of the cutter's radius: the tool goes beside the contour that a program tells, left or right of it.

Each move along the contour becomes one beside it. Round a corner that is convex for the tool an arc is put between two
of them; at one that is concave both are cut short where they cross. So a move is made when the next one is known.
Places of the plane are complex numbers.

Source
------
The manual of LinuxCNC, "Cutter Compensation", whose moves these are.
"""

import cmath
import math
from dataclasses import dataclass

from ...declared.refusals import ShapeError
from .toolpath import ARC, FEED, RAPID, ROUND

ALONG = 0.05  # radians: at a corner that turns less, the tool goes straight on, as LinuxCNC does
NEAR = 1e-9  # metres: rounding of lengths


@dataclass
class Beside:
    """A move of the tool beside one of the contour, which the next one may cut short.

    Parameters
    ----------
    kind, line : int
    begin, end : complex
    ahead : complex
        The direction of the contour at its end.
    low, height : float
        How high it begins and ends.
    room : float
        How much of it may be cut off: metres, of an arc radians.
    centre : complex or None
    turn : int
        1 for an arc counter-clockwise, -1 clockwise.
    """

    kind: int
    line: int
    begin: complex
    end: complex
    ahead: complex
    low: float
    height: float
    room: float
    centre: complex | None = None
    turn: int = 0

    @property
    def radius(self):
        return abs(self.end - self.centre)

    def after(self, place):
        """How far a place of its line or circle is behind its begin, along it: metres, of an arc radians."""
        if self.centre is None:
            return ((place - self.begin) * self.ahead.conjugate()).real
        return swept(self.begin - self.centre, place - self.centre, self.turn)

    def before(self, place):
        """How far a place is before its end."""
        if self.centre is None:
            return ((self.end - place) * self.ahead.conjugate()).real
        return swept(place - self.centre, self.end - self.centre, self.turn)

    def length(self, along):
        return along if self.centre is None else along * self.radius


class Compensation:
    """The tool beside a contour while compensation is on, and the moves that are not made yet.

    Parameters
    ----------
    machine : Machine
        At the place of the contour from which it begins.
    radius : float
        Of the tool, in metres.
    side : int
        1 where the tool is left of the contour, -1 right.
    """

    def __init__(self, machine, radius, side):
        self.machine, self.radius, self.side = machine, radius, side
        self.plane, self.within = machine.plane, ROUND[machine.plane]
        self.last, self.upright = None, []

    @property
    def waiting(self):
        """How many moves are not made yet."""
        return (self.last is not None) + len(self.upright)

    def straight(self, place, kind, line):
        """Move straight to a place of the contour."""
        (begin, low), (end, height) = map(self.split, (self.machine.at, place))
        way, room = end - begin, abs(end - begin)
        if self.last and room <= NEAR:
            self.upright.append((height, kind, line))
            return
        if self.last is None:
            self.require_long(way)
            room = math.inf  # wherever it meets the next, the tool comes from where the contour is not
        ahead = way / abs(way)
        aside = self.aside(ahead)
        self.follow(Beside(kind, line, begin + aside, end + aside, ahead, low, height, room), ahead)

    def turn(self, place, centre, angle, line):
        """Move along an arc of the contour."""
        (begin, low), (end, height), (middle, _) = map(self.split, (self.machine.at, place, centre))
        turn = 1 if angle > 0 else -1
        leaving, ahead = (1j * turn * (each - middle) / abs(each - middle) for each in (begin, end))
        radius = abs(begin - middle)
        if radius <= self.radius + NEAR and turn == self.side:
            raise ShapeError(f"has an arc of radius {millimetres(radius)} inside which the tool does not fit")
        first, last = begin + self.aside(leaving), end + self.aside(ahead)
        move = Beside(ARC, line, first, last, ahead, low, height, abs(angle), middle, turn)
        if self.last is None:
            self.require_long(end - begin)
            move.begin, move.centre = begin, level(begin, move.end, middle)
            whole = math.ceil(abs(angle) / math.tau - NEAR) - 1
            move.room = math.tau * whole + (swept(begin - move.centre, move.end - move.centre, turn) or math.tau)
        self.follow(move, leaving)

    def aside(self, ahead):
        """From a place of the contour to where the tool is, where the contour has that direction."""
        return 1j * self.side * self.radius * ahead

    def require_long(self, way):
        """Refuse a first move no longer than the radius, which leads nowhere beside the contour."""
        if abs(way) <= self.radius:
            first, radius = millimetres(abs(way)), millimetres(self.radius)
            raise ShapeError(f"begins to compensate with a move of {first}, no more than the tool's radius, {radius}")

    def follow(self, move, leaving):
        """Join a move to the last one, which is then made."""
        if self.last:
            last, towards = self.last, self.side * cmath.phase(leaving / self.last.ahead)
            back = abs(towards) > math.pi - ALONG
            round_about = last if move.centre is None else move
            looped = round_about.turn not in (0, self.side)
            if back and looped or not back and towards > ALONG:
                cut_short(last, move)
                self.make()
            else:
                self.make()
                if back or towards < -ALONG:
                    self.go_round(move)
                elif move.centre is not None:
                    move.begin = last.end
                    part = swept(move.begin - move.centre, move.end - move.centre, move.turn)
                    move.room = part + math.tau * round((move.room - part) / math.tau)
        self.last = move

    def go_round(self, move):
        """Go round a corner of the contour, to where a move begins; rapidly that is straight."""
        (corner, _), begin, height = self.split(self.machine.at), self.last.end, move.low
        if move.kind == RAPID:
            self.add(move.begin, height, RAPID, move.line)
            return
        angle = -self.side * swept(begin - corner, move.begin - corner, -self.side)
        self.add(move.begin, height, ARC, move.line, (corner, height, angle))

    def make(self):
        """Make the last move, and those that lead up and down where it ends."""
        last, arc, kind = self.last, None, self.last.kind
        if last.room < -NEAR:
            raise ShapeError(f"goes into a corner that a tool of radius {millimetres(self.radius)} does not fit into")
        if last.centre is not None and last.room > NEAR:
            arc = last.centre, last.low, last.turn * last.room
        elif last.centre is not None:
            kind = FEED  # nothing is left of it
        self.add(last.end, last.height, kind, last.line, arc)
        for height, kind, line in self.upright:
            self.add(last.end, height, kind, line)
        self.upright = []

    def add(self, place, height, kind, line, arc=None):
        moved, tool = self.machine.moved, self.machine.tool
        if arc:
            centre, low, angle = arc
            moved.arcs.append((moved.count, self.joined(centre, low), self.joined(0.0, angle)))
        moved.add(self.joined(place, height), kind, line, tool)

    def split(self, place):
        """A place within the plane, and how high it is above it."""
        one, other = self.within
        return complex(place[one], place[other]), place[self.plane]

    def joined(self, place, height):
        """The coordinates of a place within the plane, so high above it."""
        coordinates = [height] * 3
        coordinates[self.within[0]], coordinates[self.within[1]] = place.real, place.imag
        return coordinates

    def finish(self):
        """Make what is not made yet: compensation ends, and the next move leads back to the contour."""
        if self.last:
            self.make()


def millimetres(length):
    return f"{length * 1e3:.6g} mm"


def swept(first, last, turn):
    """The angle from one direction to another, turning one way: from 0 to a whole turn, rounding left out."""
    angle = turn * cmath.phase(last / first) % math.tau
    return 0.0 if math.tau - angle < NEAR else angle


def level(begin, end, middle):
    """The centre of the arc that arrives at its end as one about the middle does, from where the tool is."""
    inward, back = (middle - end) / abs(middle - end), begin - end
    along = (back * inward.conjugate()).real
    if abs(along) < NEAR:
        raise ShapeError("begins to compensate with an arc that the tool cannot follow")
    return end + inward * abs(back) ** 2 / (2 * along)


def cut_short(last, move):
    """End a move and begin the next where they cross, as near to their corner as they do."""
    found = [(last.before(place), move.after(place), place) for place in crossings(last, move)]
    found = [each for each in found if each[0] > -NEAR and each[1] > -NEAR]
    if not found:
        raise ShapeError("goes into a corner that the tool does not fit into")
    end, begin, place = min(found, key=lambda each: last.length(each[0]) + move.length(each[1]))
    last.room, move.room = last.room - end, move.room - begin
    last.end = move.begin = place


def crossings(last, move):
    """Where the line or the circle of one move crosses that of another."""
    if last.centre is None and move.centre is None:
        across = (last.ahead.conjugate() * move.ahead).imag
        off = (last.ahead.conjugate() * (last.end - move.begin)).imag / across
        return [move.begin + off * move.ahead]
    if last.centre is not None and move.centre is not None:
        way = move.centre - last.centre
        apart = abs(way)
        if apart < NEAR:
            return []
        along = (apart + (last.radius**2 - move.radius**2) / apart) / 2
        return beside(last.centre + along * way / apart, way / apart * 1j, last.radius, along)
    line, circle = (move, last) if move.centre is None else (last, move)
    foot = line.end + line.ahead * ((circle.centre - line.end) * line.ahead.conjugate()).real
    return beside(foot, line.ahead, circle.radius, abs(foot - circle.centre))


def beside(foot, along, radius, away):
    """The places of a circle on a line, from its foot, which is so far away from the centre."""
    squared = radius**2 - away**2
    if squared < -NEAR * radius:
        return []
    half = math.sqrt(max(squared, 0.0))
    return [foot - half * along, foot + half * along]

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a machine holds while it runs a program: where it is, its modes, its offsets and the moves it has made."""

import math
from types import SimpleNamespace

import numpy as np

from ...declared.refusals import ShapeError
from .compensation import Compensation
from .toolpath import ARC, RAPID, Toolpath

MILLIMETRE, INCH = 0.001, 0.0254
MOST_MOVES = 3_000_000
MANY = 100_000  # single moves, after which they are made rows of an array
MODES = ("unit", "plane", "absolute", "absolute_centres", "feed_mode", "feed", "to_level", "system")
AXES = "xyz"


class Machine:
    """A machine of three axes, whose zero is that of its first work offset until a program moves that."""

    def __init__(self, diameter=None):
        self.diameter = diameter or {}.get  # of a tool by its number, in metres
        self.unit = MILLIMETRE
        self.motion = None  # ten times the number of its G code: 52 is G5.2
        self.plane = 2  # the axis across it
        self.absolute, self.absolute_centres = True, False
        self.feed_mode, self.feed = 940, 0.0
        self.to_level = True  # canned cycles return to where they began; else to R
        self.system = 0
        self.offsets = [[0.0, 0.0, 0.0] for _ in range(9)]
        self.rotations = [0.0] * 9  # in degrees
        self.shift = [0.0, 0.0, 0.0]  # of G92
        self.held_shift = [0.0, 0.0, 0.0]  # what G92.3 brings back
        self.tool, self.selected = 0, 0
        self.spindle, self.speed = 0, 0.0
        self.at = [0.0, 0.0, 0.0]
        self.known = [False] * 3
        self.lost = set()  # axes at the home of the machine, which only it knows
        self.away = set()  # axes at places of the machine, where no offset says how they lie to those of the program
        self.has_offsets = False
        self.homes = {}  # places of the machine by the number of their G code, 28 or 30
        self.first = None
        self.cycle = SimpleNamespace(level=None, words={})
        self.spline, self.order = [], 3  # the control points of a NURBS so far
        self.leaving = None  # of a cubic spline, from the one before
        self.beside = None  # `Compensation`, where the tool is beside the contour: then `at` is the contour's place
        self.off_contour = False  # it was, and no move has led back
        self.moved = Moved()

    def modes(self):
        return {name: getattr(self, name) for name in MODES}

    def restore(self, modes):
        vars(self).update(modes)

    def to_machine(self, place):
        """A place of the program, as the machine knows it."""
        x, y, z = (p + s for p, s in zip(place, self.shift, strict=True))
        x, y = turned(x, y, self.rotations[self.system])
        return [p + o for p, o in zip((x, y, z), self.offsets[self.system], strict=True)]

    def to_program(self, place, system=None):
        """A place of the machine, as the program knows it, here before G92 is taken off."""
        system = self.system if system is None else system
        x, y, z = (p - o for p, o in zip(place, self.offsets[system], strict=True))
        return [*turned(x, y, -self.rotations[system]), z]

    @property
    def place(self):
        """Where the tool is, as the program knows it, in metres."""
        return [p - s for p, s in zip(self.to_program(self.at), self.shift, strict=True)]

    def go(self, place, kind, line):
        """Move straight to a place of the program."""
        self.go_machine(self.to_machine(place), kind, line)

    def go_machine(self, place, kind, line):
        self.begin(kind)
        place = [within(p) for p in place]
        if self.beside:
            self.beside.straight(place, kind, line)
        else:
            self.moved.add(place, kind, line, self.tool, bool(self.lost or self.away))
        self.at, self.off_contour = place, False

    def turn(self, place, centre, angle, line):
        """Move to a place of the program round a centre, by an angle in radians about the axis across the plane."""
        self.begin(ARC)
        place, centre = [within(p) for p in self.to_machine(place)], self.to_machine(centre)
        if self.beside:
            self.beside.turn(place, centre, angle, line)
        elif self.off_contour:
            raise ShapeError("has an arc right after G40, where a straight move must lead back to the contour")
        else:
            axis = [0.0, 0.0, 0.0]
            axis[self.plane] = angle
            axis[:2] = turned(axis[0], axis[1], self.rotations[self.system])
            self.moved.arcs.append((self.moved.count, centre, axis))
            self.moved.add(place, ARC, line, self.tool)
        self.at = place

    def compensate(self, radius, side):
        """Go beside the contour from now on."""
        self.beside = Compensation(self, radius, side)

    def end_compensation(self):
        """Go back to the contour with the next move."""
        if self.beside:
            self.off_contour = self.beside.waiting > 0
            self.beside.finish()
            self.beside = None

    def leave(self, axes):
        """Let axes be where the program does not tell."""
        self.known = [known and axis not in axes for axis, known in enumerate(self.known)]

    def begin(self, kind):
        if kind != RAPID:
            self.away.clear()  # the program counts on them
        if self.first is None and (kind != RAPID or all(self.known)):
            self.first = self.moved.count + (self.beside.waiting if self.beside else 0)

    def toolpath(self):
        """All moves that were made."""
        return self.moved.toolpath(self.moved.count if self.first is None else self.first)


class Moved:
    """The moves so far: single ones in lists, runs of many as arrays."""

    def __init__(self):
        self.count, self.arcs, self.apart = 0, [], []
        self.runs, self.single = [], []

    def add(self, place, kind, line, tool, apart=False):
        if apart:
            self.apart.append(self.count)
        self.single.append((*place, kind, line + 1, tool))
        self.count += 1
        if len(self.single) >= MANY:  # which take five times the memory of their rows
            self.flush()
        self.bound()

    def add_run(self, rows):
        """Add many moves at once, as rows of place, kind, line and tool."""
        self.flush()
        self.runs.append(rows)
        self.count += len(rows)
        self.bound()

    def bound(self):
        if self.count > MOST_MOVES:
            raise ShapeError(f"makes more than {MOST_MOVES} moves, which is the most")

    def flush(self):
        if self.single:
            self.runs.append(np.array(self.single, dtype=np.float64))
            self.single = []

    def toolpath(self, first):
        self.flush()
        rows = np.concatenate(self.runs) if self.runs else np.zeros((0, 6))
        arcs = np.array([index for index, _, _ in self.arcs], dtype=np.int64)
        centres = np.array([centre for _, centre, _ in self.arcs], dtype=np.float64).reshape(-1, 3)
        turns = np.array([turn for _, _, turn in self.arcs], dtype=np.float64).reshape(-1, 3)
        points = np.ascontiguousarray(rows[:, :3])
        kinds, lines, tools = (rows[:, column].astype(np.int32) for column in (3, 4, 5))
        apart = np.array(self.apart, dtype=np.int64)
        return Toolpath(points, kinds.astype(np.int8), lines, tools, arcs, centres, turns, first, apart)


def turned(x, y, degrees):
    """A place of the plane, turned about its zero."""
    if not degrees:
        return x, y
    cosine, sine = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return cosine * x - sine * y, sine * x + cosine * y


def within(length):
    if not abs(length) <= 1e6:
        raise ShapeError(f"moves to {length:g} m, farther than any machine")
    return length

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The moves that LinuxCNC's interpreter makes of real programs, beside those that are read here."""

import gzip
import math
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from sweep_addon.core.declared.refusals import ShapeError
from sweep_addon.core.machining.programs.reading import Run

FOLDER = Path(__file__).resolve().parents[1] / "data" / "gcode"
ORACLES = sorted(FOLDER.glob("*.canon.gz"))
COMMAND = re.compile(r"(\w+)\((.*)\)")
PLANES = {"XY": (0, 1, 2), "XZ": (2, 0, 1), "YZ": (1, 2, 0)}
INCHES = {1: 0.125, 2: 0.0625, 3: 0.201, 4: 0.25, 6: 0.0625}  # diameters in the oracles' table; of others 0.1
ROUNDING = 2.5e-4  # of the unit: four decimals of a place, an offset, another offset, and both turned


@dataclass
class Move:
    """One move in metres: rapid (T), at a feed (F), an arc (A) or a spline (N), whose end an oracle does not tell."""

    kind: str
    end: object
    tool: int
    unit: float = 0.001
    centre: object = None
    axis: int = 2
    turns: int = 0  # whole and begun turns, counter-clockwise


def text_of(oracle):
    """The program that an oracle is of."""
    program = oracle.with_name(oracle.name.replace(".canon", ""))
    return gzip.open(program).read().decode("latin-1")


class Told:
    """The moves of an oracle, placed by the offsets that it tells, and the refusal it ends with."""

    def __init__(self, path):
        self.unit, self.offset, self.shift, self.rotation = 0.001, np.zeros(3), np.zeros(3), 0.0
        self.plane, self.tool, self.selected = PLANES["XY"], 0, 0
        self.moves, self.refusal = [], ""
        for line in gzip.open(path, "rt", encoding="latin-1"):
            if line.startswith("ERROR") and "File ended" not in line:
                self.refusal = line
            found = COMMAND.match(line)
            if found:
                getattr(self, f"take_{found[1].lower()}")(found[2].split(","))

    def place(self, numbers):
        x, y, z = np.array(numbers) * self.unit + self.shift
        c, s = math.cos(math.radians(self.rotation)), math.sin(math.radians(self.rotation))
        return np.array([c * x - s * y, s * x + c * y, z]) + self.offset

    def lengths(self, words):
        return np.array([float(word) for word in words]) * self.unit

    def take_use_length_units(self, words):
        self.unit = 0.0254 if "INCHES" in words[0] else 0.001

    def take_set_g5x_offset(self, words):
        self.offset = self.lengths(words[1:4])

    def take_set_g92_offset(self, words):
        self.shift = self.lengths(words[:3])

    def take_set_xy_rotation(self, words):
        self.rotation = float(words[0])

    def take_select_plane(self, words):
        self.plane = PLANES[words[0][-2:]]

    def take_select_tool(self, words):
        self.selected = int(words[0])

    def take_change_tool(self, words):
        self.tool = self.selected

    def take_straight_traverse(self, words, kind="T"):
        self.moves.append(Move(kind, self.place([float(word) for word in words[:3]]), self.tool, self.unit))

    def take_straight_feed(self, words):
        self.take_straight_traverse(words, "F")

    def take_arc_feed(self, words):
        one, other, centre_one, centre_other, turns, along = (float(word) for word in words[:6])
        end, centre = np.zeros((2, 3))
        end[list(self.plane)] = one, other, along
        centre[list(self.plane)] = centre_one, centre_other, along
        arc = Move("A", self.place(end), self.tool, self.unit, self.place(centre), self.plane[2], int(turns))
        self.moves.append(arc)

    def take_nurbs_feed(self, words):
        self.moves.append(Move("N", None, self.tool, self.unit))


def diameter(tool):
    """The diameter of a tool in the oracles' table, in metres."""
    return 0.0254 * INCHES.get(tool, 0.1)


def read_here(text):
    """The moves that this program reads, as far as it does, and its refusal."""
    try:
        run = Run(text, diameter)
    except ShapeError as refusal:
        return [], str(refusal)
    refused = ""
    try:
        run.through()
    except ShapeError as refusal:
        refused = str(refusal)
    return list(moves_of(run.machine.toolpath())), refused


def moves_of(path):
    arcs = {arc: i for i, arc in enumerate(path.arcs)}
    for i in range(len(path)):
        kind = "TFAN"[path.kinds[i]]
        move = Move(kind, path.points[i], path.tools[i])
        if kind == "N" and i + 1 < len(path) and path.kinds[i + 1] == 3 and path.lines[i + 1] == path.lines[i]:
            continue  # a chord, and not the last
        if i in arcs:
            turn = path.turns[arcs[i]]
            move.axis = int(np.abs(turn).argmax())
            whole = math.ceil(np.linalg.norm(turn) / math.tau - 1e-6)
            move.centre, move.turns = path.centres[arcs[i]], int(math.copysign(whole, turn[move.axis]))
        yield move


def same(here, told):
    """Whether two moves are the same but for the rounding of an oracle."""
    tolerance = ROUNDING * told.unit
    if here.kind != told.kind or here.tool != told.tool:
        return False
    if told.kind == "N":
        told.end = here.end
    if np.abs(here.end - told.end).max() > tolerance:
        return False
    if told.kind != "A":
        return True
    across = [axis for axis in range(3) if axis != told.axis]
    return here.turns == told.turns and np.abs(here.centre - told.centre)[across].max() <= tolerance


def differences(here, told):
    """The first moves that differ, as a list of one pair or none, and the numbers left over of both.

    A straight move to where the tool is already is passed over: the oracle tells some that no line asks for.
    """
    i = j = 0
    while i < len(here) and j < len(told):
        if same(here[i], told[j]):
            i, j = i + 1, j + 1
        elif stays(here, i, told[j].unit):
            i += 1
        elif stays(told, j, told[j].unit):
            j += 1
        else:
            return [(here[i], told[j])], (0, 0)
    while i < len(here) and stays(here, i, 0.001):
        i += 1
    while j < len(told) and stays(told, j, told[j].unit):
        j += 1
    return [], (len(here) - i, len(told) - j)


def stays(moves, i, unit):
    before = moves[i - 1].end if i else np.zeros(3)
    return moves[i].kind in "TF" and before is not None and np.abs(moves[i].end - before).max() <= ROUNDING * unit

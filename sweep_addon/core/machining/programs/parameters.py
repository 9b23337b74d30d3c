# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The parameters of a program: those it sets itself, and those that tell what the machine holds."""

from ...declared.refusals import ShapeError
from .machine import INCH, MILLIMETRE

LOCAL = 30  # the first so many are a subroutine's own
FREE = 5000  # up to this, a program's to set; beyond, the machine's
MOST_NAMES = 10_000


class Frame:
    """What a call of a subroutine has of its own."""

    def __init__(self, arguments=(), back=None, repeats=0):
        self.numbered = {n: value for n, value in enumerate(arguments, 1)}
        self.names = {}
        self.counters = {}
        self.back, self.repeats = back, repeats  # the line to go on at; how often the text is still to be run
        self.saved, self.restores = None, False  # modes that M70 or M73 keep


class Parameters:
    """Parameters by number and by name, some global and some of the subroutine that runs."""

    def __init__(self, machine):
        self.machine = machine
        self.numbered, self.names = {}, {}
        self.frames = [Frame()]

    @property
    def frame(self):
        return self.frames[-1]

    def names_of(self, name):
        return self.names if name.startswith("_") else self.frame.names

    def set(self, key, value):
        if isinstance(key, str):
            names = self.names_of(key)
            names[key] = value
            if len(names) > MOST_NAMES:
                raise ShapeError(f"sets more than {MOST_NAMES} names, which is the most")
        elif 1 <= key <= FREE:
            (self.frame.numbered if key <= LOCAL else self.numbered)[key] = value
        else:
            raise ShapeError(f"sets parameter #{key}, which is the machine's: a program may set #1 to #{FREE}")

    def get(self, key):
        if isinstance(key, str):
            found = self.names_of(key).get(key)
            return self.known(key) if found is None else found
        if 1 <= key <= FREE:
            return (self.frame.numbered if key <= LOCAL else self.numbered).get(key, 0.0)
        return self.told(key)

    def exists(self, name):
        return name in self.names_of(name) or name in KNOWN

    def known(self, name):
        if name not in KNOWN:
            raise ShapeError(f"asks for parameter #<{name}>, which is not set")
        return float(KNOWN[name](self.machine))

    def told(self, key):
        """What the machine tells by number: where it is, its offsets and its tool."""
        machine = self.machine
        if 5420 <= key <= 5422:
            return machine.place[key - 5420] / machine.unit
        if 5211 <= key <= 5213:
            return machine.held_shift[key - 5211] / MILLIMETRE
        if key == 5220:
            return machine.system + 1.0
        system, which = divmod(key - 5221, 20)
        if 0 <= system < 9 and which < 3:
            return machine.offsets[system][which] / MILLIMETRE
        if 0 <= system < 9 and which == 9:
            return machine.rotations[system]
        if key == 5400:
            return float(machine.tool)
        raise ShapeError(f"asks for parameter #{key}, which only a machine knows")


KNOWN = {
    "_x": lambda machine: machine.place[0] / machine.unit,
    "_y": lambda machine: machine.place[1] / machine.unit,
    "_z": lambda machine: machine.place[2] / machine.unit,
    "_abs_x": lambda machine: machine.at[0] / machine.unit,
    "_abs_y": lambda machine: machine.at[1] / machine.unit,
    "_abs_z": lambda machine: machine.at[2] / machine.unit,
    "_metric": lambda machine: machine.unit == MILLIMETRE,
    "_imperial": lambda machine: machine.unit == INCH,
    "_absolute": lambda machine: machine.absolute,
    "_incremental": lambda machine: not machine.absolute,
    "_feed": lambda machine: machine.feed,
    "_rpm": lambda machine: machine.speed,
    "_plane": lambda machine: {2: 170, 1: 180, 0: 190}[machine.plane],
    "_current_tool": lambda machine: machine.tool,
    "_selected_tool": lambda machine: machine.selected,
}

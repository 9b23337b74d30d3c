# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A program run from its first line to its end: what it says is done, and where it goes on."""

from ...declared.refusals import ShapeError
from . import plain
from .blocks import Block, block
from .codes import obey
from .expressions import whole
from .flow import linked
from .foreign import refuse_foreign
from .lines import at_line
from .machine import Machine
from .parameters import Frame, Parameters

MOST_STEPS = 1_000_000  # lines that loops run again
DEEPEST = 50  # subroutines within subroutines
NOTHING = Block()


def read(text, diameter=None):
    """The moves of a program of RS-274, as LinuxCNC makes them: expressions, subroutines, loops and canned cycles.

    Parameters
    ----------
    text : str
        The program. It is in millimetres until it says otherwise, and the zero of its first work offset is the
        machine's.
    diameter : callable, optional
        From the number of a tool to its diameter in metres, None where that is not known: `G41` and `G42` ask for it.

    Returns
    -------
    Toolpath

    Raises
    ------
    ShapeError
        What the program has that is wrong or not known here, with the number of its line: nothing is passed over.

    Source
    ------
    Kramer, Proctor, Messina: The NIST RS274NGC Interpreter, version 3, NISTIR 6556, 2000; and the manual of LinuxCNC,
    whose dialect it is.

    Examples
    --------
    >>> path = read("G20 F10\\nG0 X0 Y0 Z0.1\\nG1 Z-0.1\\n#1 = 3\\nX[#1/2]")
    >>> path.points.tolist()[-1]
    [0.038099999999999995, 0.0, -0.00254]
    >>> path.lines.tolist(), path.rapid.tolist()
    ([2, 3, 5], [True, False, False])

    A tool 6 mm wide goes beside what is told:

    >>> text = "G21 F100\\nT1 M6\\nG0 X0 Y0 Z0\\nG41 G1 X10 Y10\\nX30\\nG40 Y0"
    >>> (read(text, {1: 0.006}.get).points[-2] * 1000).round(9).tolist()
    [30.0, 13.0, 0.0]
    """
    refuse_foreign(text)
    run = Run(text, diameter)
    run.through()
    return run.machine.toolpath()


class Run:
    """A program while it runs: its lines, the machine, the parameters, and which line is next."""

    def __init__(self, text, diameter=None):
        self.lines = text.split("\n")
        first, last = within_marks(self.lines)
        self.lines = self.lines[:last]
        self.flow = linked(self.lines)
        self.machine = Machine(diameter)
        self.parameters = Parameters(self.machine)
        self.blocks = {}
        self.next = first
        self.farthest, self.steps = self.next, 0

    def through(self):
        """Run to the end of the program."""
        while self.next is not None and self.next < len(self.lines):
            line = self.next
            found = plain.run_of(self.machine, self.lines, line)
            self.next = line + max(1, len(found))
            with at_line(line):
                if found:
                    plain.move_along(self.machine, found, line)
                else:
                    self.obey(line)
                self.bound(line, max(1, len(found)))
                if self.next is None or self.next >= len(self.lines):
                    self.machine.end_compensation()

    def bound(self, line, count):
        """Count lines that are run again, of which no program needs more than some."""
        again = max(0, min(count, self.farthest - line))
        self.farthest = max(self.farthest, line + count)
        self.steps += again
        if self.steps > MOST_STEPS:
            raise ShapeError(f"is run on and on: more than {MOST_STEPS} lines are run again, which is the most")

    def obey(self, line):
        said = self.block(line)
        if said is NOTHING:
            return
        held = self.parameters
        if said.keyword:
            self.follow(said, line)
            return
        words = {letter: number(held) for letter, number in said.words.items()}
        codes = tuple([ten_times(number(held)) for number in said.codes])
        stops = tuple([whole(number(held), "M") for number in said.stops])
        for key, number in [(key(held), number(held)) for key, number in said.assignments]:
            held.set(key, number)
        keep_modes(self.machine, held.frame, stops)
        goes_on = obey(self.machine, codes, stops, words, line)
        if not goes_on:
            self.next = None
        elif 98 in stops:
            self.call_program(words)
        elif 99 in stops:
            self.end_call(again=True)

    def block(self, line):
        if line not in self.blocks:
            text = self.lines[line]
            said = block(text) if text.strip() else NOTHING
            empty = not (said.codes or said.stops or said.words or said.assignments or said.keyword)
            self.blocks[line] = NOTHING if empty else said
        return self.blocks[line]

    def follow(self, said, line):
        """Go on where a line of the flow leads."""
        follow = getattr(self, f"follow_{said.keyword}")
        follow(said, line, self.flow.constructs.get(line))

    def value(self, said):
        return said.arguments[0](self.parameters)

    def follow_label(self, said, line, construct):
        """The name of a program in the manner of Fanuc, which does nothing."""

    def follow_sub(self, said, line, construct):
        self.next = construct.end + 1

    def follow_if(self, said, line, construct):
        for part in construct.lines:
            said = self.block(part)
            if said.keyword in ("else", "endif") or self.value(said):
                self.next = part + 1
                return
            self.steps += 1  # loops look again at branches that they pass over

    def follow_elseif(self, said, line, construct):
        self.next = construct.end + 1  # a branch above has been run

    follow_else = follow_elseif

    def follow_endif(self, said, line, construct):
        """Go on."""

    follow_do = follow_endif

    def follow_while(self, said, line, construct):
        holds = self.value(said)
        if construct.keyword == "do" and holds:
            self.next = construct.lines[0] + 1
        elif construct.keyword == "while" and not holds:
            self.next = construct.end + 1

    def follow_endwhile(self, said, line, construct):
        self.next = construct.lines[0]

    def follow_repeat(self, said, line, construct):
        times = whole(self.value(said), "the times to repeat")
        self.parameters.frame.counters[line] = times
        if times <= 0:
            self.next = construct.end + 1

    def follow_endrepeat(self, said, line, construct):
        begin, counters = construct.lines[0], self.parameters.frame.counters
        counters[begin] = counters.get(begin, 0) - 1
        if counters[begin] > 0:
            self.next = begin + 1

    def follow_break(self, said, line, construct):
        self.next = self.around(said, line).end + 1

    def follow_continue(self, said, line, construct):
        self.next = self.around(said, line).end

    def around(self, said, line):
        """The loop of a label that a line is in."""
        label = said.label(self.parameters)
        loops = [loop for loop in self.flow.around[line] if loop.label == label]
        if not loops:
            raise ShapeError(f"has {said.keyword} outside of a loop of its label")
        return loops[-1]

    def follow_call(self, said, line, construct):
        label = said.label(self.parameters)
        if label not in self.flow.subs:
            raise ShapeError(f"calls subroutine o<{label}>, which the text does not have")
        arguments = [argument(self.parameters) for argument in said.arguments]
        self.enter(Frame(arguments, self.next), self.flow.subs[label].lines[0] + 1)

    def enter(self, frame, line):
        if len(self.parameters.frames) > DEEPEST:
            raise ShapeError(f"calls subroutines within subroutines more than {DEEPEST} deep, which is the most")
        self.parameters.frames.append(frame)
        self.next = line

    def follow_return(self, said, line, construct):
        value = self.value(said) if said.arguments else None
        self.end_call()
        self.parameters.names["_value_returned"] = 0.0 if value is None else 1.0
        self.parameters.names["_value"] = value or 0.0

    follow_endsub = follow_return

    def call_program(self, words):
        """Run a part of the text in the manner of Fanuc, from a label to M99, which sees the same parameters."""
        label = whole(words.get("p", 0), "P")
        times = whole(words.get("l", 1), "L")
        begin = self.flow.labels.get(label)
        if begin is None and label in self.flow.subs:
            begin = self.flow.subs[label].lines[0]
        if begin is None:
            raise ShapeError(f"calls program O{label}, which the text does not have")
        if times > 0:
            frame = Frame(back=self.next, repeats=times)
            frame.numbered, frame.names = self.parameters.frame.numbered, self.parameters.frame.names
            frame.begin = begin + 1
            self.enter(frame, begin + 1)

    def end_call(self, again=False):
        """Go back to where the subroutine was called; from the main program, to its end."""
        frames = self.parameters.frames
        frame = frames[-1]
        if len(frames) == 1:
            if not again:
                raise ShapeError("returns from a subroutine that was not called")
            self.next = None  # M99 in the main program begins it again, for as long as the machine is on
        elif again and frame.repeats > 1:
            frame.repeats -= 1
            self.next = frame.begin
        else:
            if frame.restores:
                self.machine.restore(frame.saved)
            frames.pop()
            self.next = frame.back


def within_marks(lines):
    """The first line of a program and that behind its last: what a line of % each encloses, or ends alone."""
    marks = [line for line, said in enumerate(lines) if said.strip() == "%"]
    begins = bool(marks) and not any(said.strip() for said in lines[: marks[0]])
    first = marks[0] + 1 if begins else 0
    ends = marks[1:] if begins else [mark for mark in marks if not any(said.strip() for said in lines[mark + 1 :])]
    return first, ends[0] if ends else len(lines)


def keep_modes(machine, frame, stops):
    """Keep the modes of the machine (M70, M73), forget them (M71) or bring them back (M72)."""
    for stop in stops:
        if stop in (70, 73):
            frame.saved, frame.restores = machine.modes(), stop == 73
        elif stop == 71:
            frame.saved, frame.restores = None, False
        elif stop == 72:
            if frame.saved is None:
                raise ShapeError("has M72 without modes that M70 keeps")
            machine.restore(frame.saved)


def ten_times(number):
    """Ten times the number of a G code."""
    return whole(number * 10, "ten times a G code")

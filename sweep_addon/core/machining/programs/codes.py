# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the words of a line do to a machine, in the order in which a machine obeys them."""

from functools import cache

from ...declared.refusals import ShapeError
from . import moving
from .cycles import CYCLES, cycle
from .expressions import whole
from .machine import AXES, INCH, MILLIMETRE, turned
from .toolpath import FEED, RAPID

MOST_TOOLS = 2**31 - 1  # as many as `Numbered` tells apart
MOTIONS = {0, 10, 20, 30, 50, 51, 52, 53, 800, *CYCLES}
HOMES = {280: 28, 281: 28, 300: 30, 301: 30}
ONCE = {40, 100, 520, 530, 920, 921, 922, 923, *HOMES}
PLANES = {170: 2, 180: 1, 190: 0}
UNITS = {200: INCH, 210: MILLIMETRE}
SYSTEMS = {540: 0, 550: 1, 560: 2, 570: 3, 580: 4, 590: 5, 591: 6, 592: 7, 593: 8}
SIDES = {400: 0, 410: 1, 411: 1, 420: -1, 421: -1}  # of the contour, on which the tool is
GROUPS = (
    MOTIONS, set(PLANES), set(UNITS), set(SYSTEMS), {900, 910}, {901, 911}, {930, 940, 950}, {980, 990}, set(SIDES),
    {430, 490}, {610, 611, 640}, {960, 970}, {80},
)  # fmt: skip
LAST = {0, 1, 2, 30, 60}
QUIET = {0, 1, 60, 7, 8, 9, 19, 48, 49, 50, 51, 52, 53, 62, 63, 64, 65, 67, 68}  # no part of them moves anything
KNOWN_STOPS = QUIET | {2, 3, 4, 5, 6, 30, 61, 70, 71, 72, 73, 98, 99}
NOT_READ = {
    70: "diameters of a lathe", 330: "a move that the spindle times", 331: "tapping that the spindle times",
    431: "a length of the tool", 432: "a length of the tool",
    520: "an offset that machines understand differently", 760: "threads of a lathe",
    870: "a cycle of boring from behind", 880: "a cycle that waits for a person",
    **{code: "a cycle of a lathe" for code in (700, 710, 711, 712, 720, 721, 722)},
    **{code: "a probe" for code in (310, 380, 382, 383, 384, 385)},
}  # fmt: skip
USES = {
    0: "xyzabcuvw@^", 10: "xyzabcuvw@^", 20: "xyzabcuvw@^ijkrp", 30: "xyzabcuvw@^ijkrp", 50: "xyijpq", 51: "xyij",
    52: "xypl", **dict.fromkeys(CYCLES, "xyzabcuvwrlpq"),
}  # fmt: skip


def obey(machine, codes, stops, words, line):
    """Do what a line says; whether the program goes on."""
    motion, once = sorted_out(codes, stops)
    if machine.beside:
        require_beside(machine, codes, stops, motion, once)
    set_feed(machine, codes, words)
    set_spindle_and_tool(machine, stops, words)
    set_modes(machine, codes)
    set_side(machine, codes, words)
    require_used(machine, once, motion, words)
    if once == 100:
        set_offsets(machine, words)
    elif once in (920, 921, 922, 923):
        shift(machine, once, words)
    elif once in (280, 300):
        moving.home(machine, HOMES[once], words, line)
    elif once in (281, 301):
        moving.set_home(machine, HOMES[once])
    else:
        move(machine, motion, once, words, line)
    return not any(stop in (2, 30) for stop in stops)


@cache
def sorted_out(codes, stops):
    """The code of a motion and the code that holds for its line alone, each or None; all codes must be known."""
    for code in codes:
        if code in NOT_READ:
            raise ShapeError(f"has G{code / 10:g}, {NOT_READ[code]}, which is not read")
        if not (code in ONCE or any(code in group for group in GROUPS)):
            raise ShapeError(f"has G{code / 10:g}, which is not known")
    for stop in stops:
        if stop not in KNOWN_STOPS:
            raise ShapeError(f"has M{stop:g}, which is not known")
    motion, *_, once = [one_of(codes, group) for group in (*GROUPS, ONCE)]
    return motion, once


def one_of(codes, group):
    """The code of a line that belongs to a group, or None."""
    found = [code for code in codes if code in group]
    if len(found) > 1:
        raise ShapeError(f"has {' and '.join(f'G{code / 10:g}' for code in found)}, of which only one can be meant")
    return found[0] if found else None


def set_feed(machine, codes, words):
    for code in codes:
        if code in (930, 940, 950):
            machine.feed_mode = code
            machine.feed = 0.0
    if "f" in words:
        if words["f"] < 0:
            raise ShapeError(f"needs F of at least 0, got {words['f']:g}")
        if machine.feed_mode != 930:
            machine.feed = words["f"]
    if "s" in words:
        machine.speed = words["s"]


def set_spindle_and_tool(machine, stops, words):
    if "t" in words:
        machine.selected = tool_number(words["t"], "T")
    for stop in stops:
        if stop == 6:
            machine.tool = machine.selected
        if stop == 61:
            machine.tool = machine.selected = tool_number(words.get("q", 0), "Q")
        if stop in (3, 4, 5):
            machine.spindle = {3: 1, 4: -1, 5: 0}[stop]


def tool_number(number, what):
    number = whole(number, what)
    if not 0 <= number <= MOST_TOOLS:
        raise ShapeError(f"needs the number of a tool for {what}, from 0 to {MOST_TOOLS}, got {number:g}")
    return number


def set_modes(machine, codes):
    for code in codes:
        if code in PLANES:
            machine.plane = PLANES[code]
        if code in UNITS:
            machine.unit = UNITS[code]
        if code in SYSTEMS:
            machine.system = SYSTEMS[code]
        if code in (900, 910):
            machine.absolute = code == 900
        if code in (901, 911):
            machine.absolute_centres = code == 901
        if code in (980, 990):
            machine.to_level = code == 980


def set_side(machine, codes, words):
    """Compensate the radius of the tool that D names, or that the spindle has, or whose diameter D is (G41.1, G42.1).

    One of a negative diameter is on the other side.
    """
    code = one_of(codes, SIDES)
    if code is None:
        return
    machine.end_compensation()
    if code == 400:
        return
    if machine.plane == 0 or machine.plane == 1 and machine.rotations[machine.system]:
        raise ShapeError(f"has G{code / 10:g} in another plane than those of G17 and, not turned, G18")
    if words.get("l"):
        raise ShapeError(f"has G{code / 10:g} with L, which is of lathes")
    diameter = told_diameter(machine, code, words)
    if diameter:
        machine.compensate(abs(diameter) / 2, SIDES[code] if diameter > 0 else -SIDES[code])


def told_diameter(machine, code, words):
    """The diameter for which a line compensates, in metres; D0 means none."""
    if code % 10:
        if "d" not in words:
            raise ShapeError(f"needs the diameter D of the tool for G{code / 10:g}")
        return words["d"] * machine.unit
    number = whole(words.get("d", machine.tool), "D")
    diameter = 0.0 if words.get("d") == 0 else machine.diameter(number)
    if diameter is None:
        raise ShapeError(f"has G{code // 10} for tool {number}, whose diameter is not told")
    return diameter


def require_beside(machine, codes, stops, motion, once):
    """Refuse what cannot be while the tool is beside the contour."""
    motion = machine.motion if motion is None else motion
    if 400 in codes:
        return
    if motion in (50, 51, 52, 53) or motion in CYCLES:
        raise ShapeError(f"has G{motion / 10:g} while G41 or G42 compensates: G40 ends that")
    wrong = [code for code in codes if code in SIDES or code in SYSTEMS]
    wrong += [code for code in codes if PLANES.get(code, machine.plane) != machine.plane]
    wrong += [code for code in codes if UNITS.get(code, machine.unit) != machine.unit]
    wrong += [once] if once not in (None, 40) else []
    if wrong:
        raise ShapeError(f"has G{wrong[0] / 10:g} while G41 or G42 compensates: G40 ends that")
    if 6 in stops or 61 in stops:
        raise ShapeError("changes the tool while G41 or G42 compensates: G40 ends that")


def require_used(machine, once, motion, words):
    """Refuse words that nothing on their line uses: who wrote them meant something."""
    axes = [letter for letter in words if letter in "xyzabcuvw@^"]
    motion = machine.motion if motion is None else motion
    if once not in (100, 920, 280, 300) and axes and USES.get(motion) is None:
        raise ShapeError(f"has {axes[0].upper()} without a G code that says how to move")
    if once is None and motion in USES and axes:
        unused = set(words) & set("ijkr") - set(USES[motion])
        if unused:
            raise ShapeError(f"has {min(unused).upper()}, which G{motion / 10:g} does not use")


def set_offsets(machine, words):
    """Set the zero of a work offset: L2 tells where it is, L20 what it makes of the place where the tool is."""
    kind = words.get("l")
    if kind not in (2, 20):
        raise ShapeError(f"has G10 L{words.get('l', 0):g}, of which L2 and L20 are read")
    number = whole(words.get("p", 0), "P")
    if not 0 <= number <= 9:
        raise ShapeError(f"needs P from 0 to 9, the number of a work offset, got {number}")
    moving.require_three_axes(words, True)
    system = number - 1 if number else machine.system
    if "r" in words:
        machine.rotations[system] = words["r"]
    offsets, machine.has_offsets = machine.offsets[system], True
    if kind == 2:
        for axis, letter in enumerate(AXES):
            if letter in words:
                offsets[axis] = words[letter] * machine.unit
        return
    require_place(machine, words)
    wanted = machine.to_program(machine.at, system)
    for axis, letter in enumerate(AXES):
        if letter in words:
            wanted[axis] = words[letter] * machine.unit + machine.shift[axis]
    x, y = turned(*wanted[:2], machine.rotations[system])
    machine.offsets[system] = [a - w for a, w in zip(machine.at, (x, y, wanted[2]), strict=True)]


def require_place(machine, words):
    """Refuse to call a place something that only the machine knows."""
    lost = [letter.upper() for axis, letter in enumerate(AXES) if letter in words and axis in machine.lost]
    if lost:
        raise ShapeError(f"sets {lost[0]} by the home of the machine, which the program does not tell")


def shift(machine, code, words):
    """Call the place where the tool is something else (G92), or no longer (G92.1, .2), or again (.3)."""
    if code == 920:
        moving.require_three_axes(words, True)
        if not any(letter in words for letter in AXES):
            raise ShapeError("needs X, Y or Z for G92")
        require_place(machine, words)
        here = machine.to_program(machine.at)
        for axis, letter in enumerate(AXES):
            if letter in words:
                machine.shift[axis] = here[axis] - words[letter] * machine.unit
        machine.held_shift = list(machine.shift)
    elif code == 923:
        machine.shift = list(machine.held_shift)
    else:
        machine.shift = [0.0] * 3
        if code == 921:
            machine.held_shift = [0.0] * 3


def move(machine, motion, once, words, line):
    """Make the move of a line, by its own G code or the last one's."""
    told = motion is not None
    motion = motion if told else machine.motion
    if motion == 53:
        moving.draw_control_points(machine, line)
    elif machine.spline and told and motion != 52:
        raise ShapeError("begins another move before G5.3 has ended its NURBS")
    moves = any(letter in words for letter in "xyzabcuvw@^")
    if once == 530:
        if motion not in (0, 10):
            raise ShapeError("has G53, which goes with G0 and G1")
        moving.in_machine(machine, words, RAPID if motion == 0 else FEED, line)
    elif motion in (0, 10) and moves:
        moving.straight(machine, words, RAPID if motion == 0 else FEED, line)
    elif motion in (20, 30) and (moves or told or any(letter in words for letter in "ijkr")):
        moving.arc(machine, words, motion == 20, line)
    elif motion in (50, 51) and moves:
        (moving.cubic if motion == 50 else moving.quadratic)(machine, words, line)
    elif motion == 52 and (moves or told):
        moving.control_point(machine, words)
    elif motion in CYCLES and (moves or told):
        cycle(machine, motion, words, line)
    if told:
        if motion != 50:
            machine.leaving = None
        machine.motion = None if motion in (53, 800) else motion

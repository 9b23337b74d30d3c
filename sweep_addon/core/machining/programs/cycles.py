# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Canned cycles, G73 and G81 to G89: drilling, boring and tapping, spelled out as the moves they are short for."""

from ...declared.refusals import ShapeError
from .machine import AXES, INCH
from .moving import ROUND, know, require_feed, require_three_axes
from .toolpath import FEED, RAPID

CYCLES = {730, 740, 810, 820, 830, 840, 850, 860, 890}
TAPPING = {740, 840}
FED_BACK = {850, 890, *TAPPING}  # those that return at the feed
DWELLING = {820, 860, 890}
PECKED = {730, 830}
BACK = 0.010 * INCH  # from the depth that was reached, so far a peck begins
STICKY = "rpq"
MOST_REPEATS = 100_000


def cycle(machine, code, words, line):
    """Drill, bore or tap at one or several places."""
    if code in TAPPING and machine.plane != 2:  # where LinuxCNC moves another axis than the one across
        raise ShapeError(f"has G{code // 10}, tapping, which is read in the plane of G17 alone")
    deep, first = AXES[machine.plane], machine.motion != code
    if first and machine.motion not in CYCLES:
        machine.cycle.level = machine.place[machine.plane]
    held = machine.cycle.words if not first else kept_height(machine)
    if deep not in words and deep not in held:
        raise ShapeError(f"needs {deep.upper()}, the depth of its canned cycle")
    held = {**held, **{letter: words[letter] for letter in (*STICKY, deep) if letter in words}}
    require_words(code, held)
    require_three_axes(words, machine.absolute)
    require_feed(machine, words, FEED)
    machine.cycle.words = held
    drill(machine, code, words, held, repeats(words), line)
    know(machine, words)


def kept_height(machine):
    """What the cycle before leaves to another one: R."""
    return {"r": machine.cycle.words["r"]} if machine.motion in CYCLES else {}


def repeats(words):
    number = words.get("l", 1)
    if number % 1 or not 0 <= number <= MOST_REPEATS:
        raise ShapeError(f"needs a whole number of repeats L up to {MOST_REPEATS}, got {number:g}")
    return int(number)


def require_words(code, held):
    if "r" not in held:
        raise ShapeError("needs R, the height above which its canned cycle moves fast")
    if code in DWELLING and "p" not in held:
        raise ShapeError(f"needs P, the time that G{code // 10} waits")
    if code in PECKED and not held.get("q", 0) > 0:
        raise ShapeError(f"needs Q, how deep each peck of G{code // 10} goes, of more than 0")


def drill(machine, code, words, held, times, line):
    across, place = machine.plane, list(machine.place)
    level = machine.cycle.level
    above = held["r"] * machine.unit + (0 if machine.absolute else level)
    bottom = held[AXES[across]] * machine.unit + (0 if machine.absolute else above)
    if above < bottom:
        raise ShapeError("has R, where its canned cycle begins to feed, below the depth it goes to")

    def go(height, kind):
        place[across] = height
        machine.go(place, kind, line)

    if level < above:
        go(above, RAPID)
        level = above
    clear = max(level, above) if machine.to_level else above
    for _ in range(times):
        for axis in ROUND[across]:
            if AXES[axis] in words:
                length = words[AXES[axis]] * machine.unit
                place[axis] = length if machine.absolute else place[axis] + length
        go(level, RAPID)
        if level != above:
            go(above, RAPID)
        for height, kind in plunges(code, above, bottom, clear, held.get("q", 0) * machine.unit):
            go(height, kind)
        level = clear


def plunges(code, above, bottom, clear, peck):
    """The heights that a cycle goes to, one after the other, and how."""
    if code in PECKED:
        if (above - bottom) / peck > MOST_REPEATS:
            raise ShapeError(f"needs Q of at least the depth by {MOST_REPEATS}")
        depth = above - peck
        while depth > bottom:
            yield depth, FEED
            if code == 830:
                yield clear, RAPID
            yield depth + BACK, RAPID
            depth -= peck
    yield bottom, FEED
    yield clear, FEED if code in FED_BACK else RAPID

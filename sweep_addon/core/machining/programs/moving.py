# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Moves from the words of a line: straight ones, arcs by their centre or radius, and splines."""

import math

import numpy as np

from ...declared.refusals import ShapeError
from ...trajectories.nurbs import Nurbs
from .machine import AXES, INCH
from .toolpath import FEED, RAPID, ROUND, SPLINE

ROTARY = "abcuvw"
CENTRE = "ijk"
FULL = 1e-6  # radians: an arc that is shorter goes all the way round
FINE = 1e-6  # metres that chords may be from a spline
MOST_CHORDS = 100_000
MOST_TURNS = 10_000
NEAR = 1e-9  # metres: rounding


def target(machine, words, absolute=None):
    """Where the axis words of a line lead, as the program knows it; those axes are known from then on."""
    absolute = machine.absolute if absolute is None else absolute
    require_three_axes(words, absolute)
    place = polar(machine, words, absolute) if "@" in words or "^" in words else list(machine.place)
    for axis, letter in enumerate(AXES):
        if letter in words:
            length = words[letter] * machine.unit
            place[axis] = length if absolute else place[axis] + length
    return place


def require_three_axes(words, absolute):
    for letter in ROTARY:
        if words.get(letter):
            way = "to" if absolute else "by"
            raise ShapeError(
                f"moves {letter.upper()} {way} {words[letter]:g}; programs of three axes are read, and others keep 0"
            )


def polar(machine, words, absolute):
    """A place by its distance from the zero of the program and the angle about it."""
    if "x" in words or "y" in words or machine.plane != 2:
        raise ShapeError("has @ or ^, which go without X and Y and in the plane of G17")
    x, y, z = machine.place
    radius, angle = math.hypot(x, y), math.degrees(math.atan2(y, x))
    if "@" in words:
        radius = words["@"] * machine.unit + (0 if absolute else radius)
    if "^" in words:
        angle = words["^"] + (0 if absolute else angle)
    return [radius * math.cos(math.radians(angle)), radius * math.sin(math.radians(angle)), z]


def know(machine, words):
    """Note which axes have been told a place."""
    if machine.absolute:
        told = {axis for axis, letter in enumerate(AXES) if letter in words}
        machine.lost -= told
        machine.away -= told
    machine.known = [
        known or letter in words or (letter != "z" and ("@" in words or "^" in words))
        for known, letter in zip(machine.known, AXES, strict=True)
    ]


def straight(machine, words, kind, line):
    require_feed(machine, words, kind)
    machine.go(target(machine, words), kind, line)
    know(machine, words)


def in_machine(machine, words, kind, line):
    """Move straight to a place of the machine, whatever its offsets.

    Where the program has set none, how that lies to its own zero only the machine knows: a fast move there is mostly up
    and out of the way. What moves at a feed before it has told another place counts on the zeros to be one.
    """
    if not machine.absolute:
        raise ShapeError("has G53, a place of the machine, where G91 says that places are relative")
    require_feed(machine, words, kind)
    require_three_axes(words, True)
    place = list(machine.at)
    for axis, letter in enumerate(AXES):
        if letter in words:
            place[axis] = words[letter] * machine.unit
    told = {axis for axis, letter in enumerate(AXES) if letter in words}
    if kind == RAPID and not machine.has_offsets:
        machine.away |= told
        machine.leave(told)
        machine.go_machine(place, kind, line)
    else:
        machine.go_machine(place, kind, line)
        know(machine, words)
    machine.lost -= told


def home(machine, number, words, line):
    """Move fast to the place that axis words lead to, and the axes they name on to the home: all where none is named.

    Where a program has not said with G28.1 or G30.1 where that is, nobody knows where these axes are from then on.
    """
    require_three_axes(words, machine.absolute)
    axes = [axis for axis, letter in enumerate(AXES) if letter in words] or [0, 1, 2]
    place = target(machine, {letter: words[letter] for letter in AXES if letter in words})
    if any(abs(p - h) > NEAR for p, h in zip(place, machine.place, strict=True)):
        straight(machine, words, RAPID, line)
    known = machine.homes.get(number)
    if known:
        machine.go_machine([known[a] if a in axes else machine.at[a] for a in range(3)], RAPID, line)
        machine.lost -= set(axes)
        return
    machine.lost |= set(axes)
    machine.leave(axes)
    machine.go_machine(machine.at, RAPID, line)


def set_home(machine, number):
    """Call the place where the tool is home."""
    if machine.lost:
        raise ShapeError("sets a home at one that the program does not tell")
    machine.homes[number] = list(machine.at)


def require_feed(machine, words, kind):
    if kind == RAPID:
        return
    if machine.lost:
        axis = AXES[min(machine.lost)].upper()
        raise ShapeError(f"moves at a feed while {axis} is at the home of the machine, which the program does not tell")
    if machine.feed_mode == 930:
        if words.get("f", 0) <= 0:
            raise ShapeError("moves at a feed without its F, which G93 needs with each move")
    elif machine.feed <= 0:
        raise ShapeError("moves at a feed before there is one: F")


def arc(machine, words, clockwise, line):
    """Move along an arc or a helix about the axis across the plane."""
    require_feed(machine, words, FEED)
    place, here = target(machine, words), machine.place
    one, other = ROUND[machine.plane]
    if "r" in words:
        centre = centre_by_radius(machine, words, here, place, clockwise)
    else:
        centre = centre_by_words(machine, words, here)
    spread = require_one_radius(here, place, centre, one, other)
    begin = math.atan2(here[other] - centre[other], here[one] - centre[one])
    finish = math.atan2(place[other] - centre[other], place[one] - centre[one])
    angle = (begin - finish if clockwise else finish - begin) % math.tau
    if angle * spread < FULL * spread:
        angle += math.tau
    angle += math.tau * (turns(words) - 1)
    centre[machine.plane] = here[machine.plane]
    machine.turn(place, centre, -angle if clockwise else angle, line)
    know(machine, words)


def turns(words):
    number = words.get("p", 1)
    if number % 1 or not 1 <= number <= MOST_TURNS:
        raise ShapeError(f"needs a whole number of turns P from 1 to {MOST_TURNS}, got {number:g}")
    return int(number)


def centre_by_words(machine, words, here):
    """The centre by I, J and K: from the start of the arc, or where G90.1 says so from the zero."""
    inside = ROUND[machine.plane]
    if CENTRE[machine.plane] in words:
        raise ShapeError(f"has {CENTRE[machine.plane].upper()}, which is across the plane of its arc")
    if not any(CENTRE[axis] in words for axis in inside):
        raise ShapeError("has an arc without its radius R or centre I, J, K")
    centre = list(here)
    for axis in inside:
        if machine.absolute_centres and CENTRE[axis] not in words:
            raise ShapeError("needs both words of the centre of its arc, where G90.1 says that they are absolute")
        offset = words.get(CENTRE[axis], 0.0) * machine.unit
        centre[axis] = offset if machine.absolute_centres else centre[axis] + offset
    return centre


def centre_by_radius(machine, words, here, place, clockwise):
    """The centre of the arc of this radius; a negative one is of the arc that is longer than a half circle."""
    if any(letter in words for letter in CENTRE):
        raise ShapeError("has both the radius R of an arc and words of its centre")
    one, other = ROUND[machine.plane]
    radius = words["r"] * machine.unit
    across = (place[one] - here[one], place[other] - here[other])
    chord = math.hypot(*across)
    if not chord:
        raise ShapeError("has an arc by its radius R that ends where it begins, so that any centre would do")
    tolerance = 0.0005 * INCH
    if chord / 2 - abs(radius) > tolerance:
        raise ShapeError(
            f"has an arc of radius {abs(words['r']):g} between ends that are {chord / machine.unit:g} apart"
        )
    height = math.sqrt(max(0.0, radius**2 - chord**2 / 4))
    side = -1 if clockwise == (radius > 0) else 1
    centre = list(here)
    centre[one] = (here[one] + place[one]) / 2 - side * height * across[1] / chord
    centre[other] = (here[other] + place[other]) / 2 + side * height * across[0] / chord
    return centre


def require_one_radius(here, place, centre, one, other):
    """Refuse ends at different distances from the centre, by more than what rounding of numbers does: the larger."""
    first, last = (math.hypot(end[one] - centre[one], end[other] - centre[other]) for end in (here, place))
    larger, error = max(first, last), abs(first - last)
    if larger < 1e-9 or min(first, last) < 1e-9:
        raise ShapeError("has an arc without radius")
    if error > 0.0005 * INCH * 100 or error > 0.001 * larger and error > 0.0005 * INCH:
        raise ShapeError(
            f"has an arc whose ends are {first * 1e3:.6g} mm and {last * 1e3:.6g} mm from its centre, which must agree"
        )
    return larger


def cubic(machine, words, line):
    """Move along a cubic spline of four points, of which I, J and P, Q tell the two in the middle."""
    here, place = start_of_spline(machine, words)
    if "i" in words and "j" in words:
        leaving = (words["i"], words["j"])
    elif machine.leaving:
        leaving = machine.leaving
    else:
        raise ShapeError("needs I and J for its first G5")
    if "p" not in words or "q" not in words:
        raise ShapeError("needs P and Q for G5")
    arriving = (words["p"], words["q"])
    control = [here, beside(machine, here, leaving), beside(machine, place, arriving), place]
    draw(machine, control, None, 4, line)
    machine.leaving = (-arriving[0], -arriving[1])
    know(machine, words)


def quadratic(machine, words, line):
    """Move along a parabola of three points, of which I and J tell the middle one."""
    here, place = start_of_spline(machine, words)
    middle = beside(machine, here, (words.get("i", 0.0), words.get("j", 0.0)))
    draw(machine, [here, middle, place], None, 3, line)
    know(machine, words)


def start_of_spline(machine, words):
    require_feed(machine, words, FEED)
    if machine.plane != 2:
        raise ShapeError("has a spline, which goes in the plane of G17")
    here, place = machine.place, target(machine, words)
    if place[2] != here[2]:
        raise ShapeError("has a spline with Z, which stays in the plane of G17")
    return here, place


def beside(machine, place, offset):
    return [place[0] + offset[0] * machine.unit, place[1] + offset[1] * machine.unit, place[2]]


def control_point(machine, words):
    """Take in a control point of a NURBS, which G5.3 draws."""
    here, _ = start_of_spline(machine, {letter: words[letter] for letter in words if letter in "xyzf"})
    if not machine.spline:
        alone = "x" not in words and "y" not in words
        machine.spline = [(here, words.get("p", 1.0) if alone else 1.0)]
        machine.order = 3
        if alone:
            return
    if "x" not in words or "y" not in words or words.get("p", 0) <= 0:
        raise ShapeError("needs X, Y and a weight P of more than 0 for each control point of G5.2")
    machine.order = int(words.get("l", machine.order))
    place = target(machine, {letter: words[letter] for letter in "xy"})
    machine.spline.append((place, words["p"]))
    know(machine, words)


def draw_control_points(machine, line):
    """Move along the NURBS of all control points so far."""
    if not machine.spline:
        raise ShapeError("ends a NURBS with G5.3 that no G5.2 begins")
    control, weights = zip(*machine.spline, strict=True)
    machine.spline = []
    draw(machine, list(control), list(weights), machine.order, line)


def draw(machine, control, weights, order, line):
    """Move along chords of a spline, as many as keep within a thousandth of a millimetre of it."""
    scale = 1e3  # in millimetres, whose sizes a spline is made for
    try:
        curve = Nurbs(np.array(control) * scale, **({"weights": weights} if weights else {}), order=order)
    except ShapeError as error:
        raise ShapeError(f"has a spline that cannot be drawn: its {error}") from None
    for place in chords(curve, FINE * scale) / scale:
        machine.go(place.tolist(), SPLINE, line)


def chords(curve, tolerance):
    """Points of a curve after its start, near enough to each other for chords within a tolerance of it."""
    begin, finish = curve.domain
    count = 16 * round(finish - begin)
    while True:
        places = curve.evaluate(np.linspace(begin, finish, 2 * count + 1))
        middles = (places[:-2:2] + places[2::2]) / 2
        if np.linalg.norm(places[1::2] - middles, axis=1).max() <= tolerance or count > MOST_CHORDS:
            return places[2::2]
        count *= 2

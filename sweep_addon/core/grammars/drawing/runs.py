# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turns in a row as one rotation.

Where all modules of a name turn by the same angle there are few different runs, and each is multiplied once. Else each
has the product of its own turns.
"""

import numpy as np

from . import turns
from .limbs import ABOUT, SPIN, SPINS, TURNS
from .products import LONG, Rotations, columns, multiplied, products_of_runs, put, taken
from .scaling import ANGLE

BITS = 4  # that say which turn it is: 1 more than its place among the spins, 0 is none
MOST = 1 << 12  # different runs


def rotations(walk, kind, begins, token):
    """The rotations of the tokens of a walk.

    Parameters
    ----------
    walk : Walk
    kind : (k,) uint8 array
        Of the modules of its limbs.
    begins : (t,) int array
        Where among these tokens begin, each of which has the turns that follow each other there.
    token : callable
        Gives the tokens of places.

    Returns
    -------
    Rotations
    """
    single = of_kinds(walk)
    found = None if single is None else different(kind, begins, single)
    if found:
        return Rotations(*found, columns(found[0]))
    spin = np.flatnonzero(kind >= SPIN)
    spins = of_modules(walk, walk.limbs.places.take(spin))
    return Rotations(products_of_runs(spins, token(spin), len(begins)))


def of_kinds(walk):
    """(2, 1 + s) complex array: the rotations of no turn and of each of the spins; None where some turn unequally."""
    if walk.numbers(ANGLE):
        return None
    found = np.zeros((2, 1 + len(SPINS)), dtype=complex)
    found[0] = 1
    for number, (name, told) in enumerate(SPINS, 1):
        if any((count > 0) == told for _, count in walk.named.get(name, ())):
            angle = told_by_all(walk, name) if told and name != ABOUT else walk.system.angle
            if angle is None:
                return None
            found[:, number] = rotation(name, angle)
    return found


def told_by_all(walk, name):
    """The angle in degrees that modules of a name with parameters tell, 0 where there are none; None if they differ."""
    places = np.flatnonzero(walk.chosen(name, given=True))
    angles = walk.word.columns[0].take(places)
    if not len(angles):
        return 0.0
    return None if (angles != angles[0]).any() else walk.angles(places[:1])[0]


def different(kind, begins, single):
    """The rotations of different runs, and which of them each token has; None where they are many or long.

    A run with one more turn is the number of the run before, and that of the turn as its last digit.

    >>> from sweep_addon.core.grammars.drawing.limbs import CLOSES, MOVE, OPENS
    >>> kinds = {"[": OPENS, "]": CLOSES, "F": MOVE, "a": SPIN, "b": SPIN + 1}
    >>> kind = np.array([kinds[letter] for letter in "FabFa[Fab]"], dtype=np.uint8)
    >>> single = np.array([[1, 1j, 0.6 + 0.8j], [0, 0, 0]])
    >>> rotations, which = different(kind, begins=np.array([0, 1, 4, 6, 7]), single=single)
    >>> which.tolist(), rotations[0].round(9).tolist()
    ([0, 3, 1, 0, 3], [(1+0j), 1j, (0.6+0.8j), (-0.8+0.6j)])
    """
    turn_of = np.zeros(len(kind) + 1, dtype=np.uint8)  # and none behind the last
    np.maximum(kind, SPIN - 1, out=turn_of[:-1])
    turn_of[:-1] -= SPIN - 1
    known, run = single, turn_of.take(begins).astype(np.intp)
    token = np.flatnonzero(run)
    place = begins.take(token)
    for _ in range(LONG):
        place += 1
        turn = turn_of.take(place)
        longer = np.flatnonzero(turn)
        if not len(longer):
            return known, run
        token, place, count = token.take(longer), place.take(longer), known.shape[1]
        number = (run.take(token) << BITS) + turn.take(longer)
        which = np.zeros(count << BITS, dtype=np.intp)
        which[number] = 1
        numbers = np.flatnonzero(which)
        if count + len(numbers) > MOST:
            return None
        which[numbers] = np.arange(count, count + len(numbers))
        run[token] = which.take(number)
        more = multiplied(taken(known, numbers >> BITS), taken(single, numbers % (1 << BITS)))
        known = np.concatenate((known, more), axis=1)
    return None


def rotation(name, angle):
    """The rotation of a turn by an angle in degrees."""
    if name == ABOUT:
        return turns.rotation(2, 180.0)
    axis, sense = TURNS[name]
    return turns.rotation(axis, sense * angle)


def of_modules(walk, places):
    """(2, n) complex array: the rotations of modules, looked up where the angle is always the same."""
    symbols, system = walk.symbols[places], walk.system
    tables = np.empty((2, len(walk.word.tables.symbols)), dtype=complex)
    for name in (*TURNS, ABOUT):
        for number in walk.numbers(name):
            tables[:, number] = rotation(name, system.angle)
    found = taken(tables, symbols)
    scaled = bool(walk.numbers(ANGLE))
    for name in TURNS:
        for number, count in walk.named.get(name, ()):
            at = np.flatnonzero(symbols == number) if count or scaled else ()
            if len(at):
                angle = np.broadcast_to(walk.angles(places[at]), at.shape)
                angle = angle[0] if (angle == angle[0]).all() else angle
                put(found, at, rotation(name, angle))
    return found

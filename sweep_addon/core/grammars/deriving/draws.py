# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random numbers that hang on a seed and on the ancestors of a module alone, and on nothing else in the word.

Each module has a key, made of its parent's key and of which of the parent's modules of its name it is; a module that is
replaced by one other hands its key on. A number is a hash of key and step. So the numbers are the same on every
machine and in whatever order modules are looked at, and a production that is changed alters what grows out of its own
modules alone.

Source
------
Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators, OOPSLA 2014: the finaliser of splitmix64.
"""

from hashlib import blake2b

import numpy as np

LEVELS = 512  # moments in each step: of its productions, and of the levels of what follows

GOLDEN = 0x9E3779B97F4A7C15
ALL = 2**64 - 1
ROUNDS = [tuple(map(np.uint64, pair)) for pair in ((30, 0xBF58476D1CE4E5B9), (27, 0x94D049BB133111EB), (31, 0))]
BLOCK = 1 << 14  # numbers
FEW = 8  # bounds that are compared one by one
DRAWS = 1024  # of one module that have numbers of their own at each moment


def mixed(numbers):
    """Spread (n,) uint64 numbers evenly, each by itself."""
    return mix(numbers.copy())


def mix(numbers):
    """The same in place, block by block, so that they stay in a processor's cache on the way."""
    other = np.empty(min(len(numbers), BLOCK), dtype=np.uint64)
    for start in range(0, len(numbers), BLOCK):
        part = numbers[start : start + BLOCK]
        shifted = other[: len(part)]
        for shift, factor in ROUNDS:
            np.right_shift(part, shift, out=shifted)
            part ^= shifted
            if factor:
                part *= factor
    return numbers


def root(seed):
    """(1,) uint64: the key of the axiom."""
    return mixed(np.array([(seed + 1) * GOLDEN & ALL], dtype=np.uint64))


def salt(name, ordinal):
    """What makes the key of the so-manieth module of a name among those that replace one module."""
    return int.from_bytes(blake2b(f"{ordinal} {name}".encode(), digest_size=8).digest(), "little")


def salts(names):
    """(k,) uint64: the salts of the modules of a successor."""
    seen, found = {}, []
    for name in names:
        seen[name] = seen.get(name, -1) + 1
        found.append(salt(name, seen[name]))
    return np.array(found, dtype=np.uint64)


def even(keys, moment, draw):
    """(n,) float64: numbers from 0 to below 1, of a draw at a moment.

    >>> even(root(seed=3), moment=0, draw=0).round(6).tolist()
    [0.305195]
    """
    place = np.array([(moment * DRAWS + draw + 1) * GOLDEN & ALL], dtype=np.uint64)
    found = mix(keys + place)
    found >>= np.uint64(11)
    return found * 2.0**-53


def drawn(bounds, numbers):
    """(n,) uint8 or int array: how many of some rising bounds each number has reached."""
    if len(bounds) > FEW:
        return np.searchsorted(bounds, numbers, side="right")
    found = np.zeros(len(numbers), dtype=np.uint8)
    for bound in bounds:
        found += numbers >= bound
    return found

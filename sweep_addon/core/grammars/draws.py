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

GOLDEN = 0x9E3779B97F4A7C15
ALL = 2**64 - 1
DRAWS = 1024  # of one module that have numbers of their own at each moment


def mixed(numbers):
    """Spread (n,) uint64 numbers evenly, each by itself."""
    numbers = (numbers ^ (numbers >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    numbers = (numbers ^ (numbers >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return numbers ^ (numbers >> np.uint64(31))


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
    return (mixed(keys + place) >> np.uint64(11)) * 2.0**-53

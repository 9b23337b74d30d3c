# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What people are told of a cut that may be meant, but often is not: tools that are missing or too wide, and no cut."""

import numpy as np

WIDEST = 1.0  # metres, which no mill has


def decided(machined, known):
    """A sentence for each such thing: a tuple of str.

    Parameters
    ----------
    machined : Machined
    known : list of int
        Numbers of tools that the stock has.
    """
    said = [*missing(set(np.unique(machined.path.tools[machined.moves]).tolist()), known), *wide(machined)]
    said += left_out(machined.path)
    if (machined.by < 0).all():
        said.append("Nothing of the stock is cut: no move comes into it.")
    return tuple(said)


def left_out(path):
    """A sentence on moves to places of the machine, and back."""
    lines = np.unique(path.lines[path.apart[path.apart >= path.first]]).tolist()
    if not lines:
        return []
    where = f"line {lines[0]}" if len(lines) == 1 else f"{len(lines)} lines, from line {lines[0]} on"
    return [
        f"Moves to places of the machine and back (G28, G53) are not looked at, by {where}: where they are it knows."
    ]


def missing(used, known):
    """A sentence on tools that are called by numbers that no tool has, where it matters which.

    >>> missing({2, 4, 5}, [2])
    ['Tools 4 and 5 of the program are not among `tools`: the default one is taken for them.']
    """
    unknown = [str(number) for number in sorted(used.difference(known))]
    if not unknown or len(used) == 1 and (used == {0} or not known):
        return []
    if len(unknown) == 1:
        return [f"Tool {unknown[0]} of the program is not among `tools`: the default one is taken for it."]
    which = f"{', '.join(unknown[:-1])} and {unknown[-1]}"
    return [f"Tools {which} of the program are not among `tools`: the default one is taken for them."]


def wide(machined):
    """A sentence on the widest tool, where it is wider than the stock, as one in millimetres is."""
    widest = max(2 * tool.radius for tool, _ in machined.tools)
    side = max((machined.high - machined.low)[:2])
    if widest <= min(side, WIDEST):
        return []
    beside = f"the stock {side:.3g} m" if widest > side else "no mill is as wide"
    return [f"A tool is {widest:.3g} m wide, {beside}: lengths are in metres."]

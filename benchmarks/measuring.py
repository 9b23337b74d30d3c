# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Medians of things measured in turns, and the tables that show them."""

import gc
import random
import statistics
import sys
import time
from pathlib import Path


def medians(actions, repeats, times=2):
    """The median milliseconds of each action: done after the others, and done again.

    Parameters
    ----------
    actions : dict of callables
        Each takes a number that is never the same, so that it can do something new.
    repeats : int
        Rounds that count; one before them does not.
    times : int
        How often an action is done in its turn.

    Returns
    -------
    after, again : dict of float
        The first time of a turn also meets what the action before it left in caches and in memory; the last, as a rule
        the second, is what a slider does that is being dragged.

    The actions take turns, so that whatever else the machine is doing falls on all of them alike, in an order that is
    drawn anew for each round: else one would always come after the slowest. What they hold is
    frozen: else Python would search the million lists of one peer for garbage in the turn of another.
    """
    gc.collect()
    gc.freeze()
    after, again = ({name: [] for name in actions} for _ in range(2))
    order, drawn = list(actions), random.Random(0)
    for number in range(repeats + 1):
        drawn.shuffle(order)
        for name in order:
            action = actions[name]
            turn = [timed(action, times * number + time) for time in range(times)]
            after[name].append(turn[0])
            again[name].append(turn[-1])
    return tuple({name: statistics.median(found[1:]) for name, found in taken.items()} for taken in (after, again))


def timed(action, number):
    """The milliseconds of an action."""
    start = time.perf_counter()
    action(number)
    return 1000 * (time.perf_counter() - start)


def table(titles, rows):
    """A Markdown table; all columns but the first are numbers and stand to the right."""
    lines = [titles, ["---", *["---:"] * (len(titles) - 1)], *rows]
    return "\n".join(f"| {' | '.join(map(str, line))} |" for line in lines)


def short(number):
    """A number in three digits: 1,234, 12.3, 0.123."""
    digits = 0 if abs(number) >= 100 else 1 if abs(number) >= 10 else 2 if abs(number) >= 1 else 3
    return f"{number:,.{digits}f}"


def verdict(value, target, unit=""):
    """What was asked for, and whether it was reached."""
    return f"{short(value)}{unit}, at most {target:g}{unit} asked: {'reached' if value <= target else 'missed'}"


def tell(text):
    """Write a section of the page into the file that `scripts/bench` names."""
    Path(sys.argv[sys.argv.index("--") + 1]).write_text(text.strip() + "\n")

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Results kept for equal questions, as many as fit into so many bytes: those asked for last."""

from collections import OrderedDict
from functools import wraps
from threading import Lock

MOST_BYTES = 256_000_000


def kept(function):
    """Keep the results of a pure function, whose ``nbytes`` say how large they are, and do not change.

    `functools.lru_cache` counts results: four large ones are too many for some, forty small ones too few for others.
    What is held is added up as results come and go: to ask thousands of them how large they are takes milliseconds.
    """
    results, lock = OrderedDict(), Lock()
    held = 0

    @wraps(function)
    def asked(*question):
        nonlocal held
        with lock:
            if question in results:
                results.move_to_end(question)
                return results[question]
        found = function(*question)
        with lock:
            if question in results:  # another thread was as fast
                return results[question]
            results[question] = found
            held += found.nbytes
            while len(results) > 1 and held > MOST_BYTES:
                held -= results.popitem(last=False)[1].nbytes
        return found

    return asked

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Results kept for equal questions, as many as fit into so many bytes: those asked for last."""

from collections import OrderedDict
from functools import wraps
from threading import Lock

MOST_BYTES = 256_000_000


def kept(function):
    """Keep the results of a pure function, whose ``nbytes`` say how large they are.

    `functools.lru_cache` counts results: four large ones are too many for some, forty small ones too few for others.
    """
    results, lock = OrderedDict(), Lock()

    @wraps(function)
    def asked(*question):
        with lock:
            if question in results:
                results.move_to_end(question)
                return results[question]
        found = function(*question)
        with lock:
            results[question] = found
            while len(results) > 1 and sum(result.nbytes for result in results.values()) > MOST_BYTES:
                results.popitem(last=False)
        return found

    return asked

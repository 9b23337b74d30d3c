# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Round brackets in a text, and what stands outside of them."""

import re
from functools import cache


def outside(text, sign):
    """The places of a sign outside of brackets, from left to right.

    >>> list(outside("A(x=1)=B=C", "=")), list(outside("A(x)", "="))
    ([6, 8], [])
    """
    depth = 0
    for match in told_by(sign).finditer(text) if sign in text else ():
        found = match.group()
        if found == "(":
            depth += 1
        elif found == ")":
            depth -= 1
        elif not depth:
            yield match.start()


@cache
def told_by(sign):
    """What finds brackets and a sign: all else need not be looked at, letter by letter."""
    return re.compile(rf"[()]|{re.escape(sign)}")


def last_outside(text, sign):
    """The place of the last such sign outside of brackets, or -1."""
    return max(outside(text, sign), default=-1)


def first_outside(text, sign):
    """The place of the first such sign outside of brackets, or -1.

    >>> first_outside("A(x=1)=B=C", "="), first_outside("A(x)", "=")
    (6, -1)
    """
    return next(outside(text, sign), -1)

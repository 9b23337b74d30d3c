# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Telling how far work is that is made of several parts."""


def unheard(part):
    """Tells nobody."""


class Listener:
    """Who is told how far work is: equal to any other, so that what is kept of a question is kept for all who ask.

    Examples
    --------
    >>> told = []
    >>> Listener(told.append) == Listener()
    True
    """

    def __init__(self, progress=None):
        self.tell = progress or unheard

    def __eq__(self, other):
        return isinstance(other, Listener)

    def __hash__(self):
        return 0

    def leave(self):
        """Hear no more, nor keep what hears."""
        self.tell = unheard


def within(progress, start, end):
    """What a part of the work is to tell, that is from one share of the whole to another.

    Examples
    --------
    >>> told = []
    >>> within(told.append, 0.5, 0.75)(0.5)
    >>> told
    [0.625]
    """
    return lambda part: progress(start + part * (end - start))

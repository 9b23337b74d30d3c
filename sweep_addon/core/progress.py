# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Telling how far work is that is made of several parts."""


def unheard(part):
    """Tells nobody."""


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

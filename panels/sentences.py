# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sentences in the sidebar, which has no lines of more than one line."""

from functools import lru_cache
from textwrap import wrap

CHARACTER = 7.0  # pixels of a letter of the interface's font, at a scale of 1; most are narrower


def sentences(context):
    """A function that draws a sentence in as many lines as the sidebar's width asks for."""
    scale = context.preferences.system.ui_scale
    width = max(int((context.region.width - 60 * scale) / (CHARACTER * scale)), 12)

    def say(layout, sentence, icon, alert=False):
        column = layout.column(align=True)
        column.alert = alert
        for number, line in enumerate(lines(sentence, width)):
            column.label(text=line, icon="BLANK1" if number else icon)

    return say


@lru_cache(maxsize=64)
def lines(sentence, width):
    """The lines of a sentence, of so many letters at most: the same in most redraws."""
    return tuple(wrap(sentence, width))

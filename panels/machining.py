# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the sidebar shows of machined stock beside its parameters: what is wrong with its program."""

import re

from ..sweep_addon.core.later import later

is_fault = later("core.machining.verification", "is_fault")

LINE = re.compile(r"\blines? (\d+)")


def draw_told(layout, sweep, say):
    """What is wrong with the program, each with a button that goes to the worst line, and what else is told."""
    if sweep.error:
        draw_line(layout, sweep.error)
    for sentence in filter(None, sweep.told.split("\n")):
        wrong = is_fault(sentence)
        say(layout, sentence, "ERROR" if wrong else "INFO", alert=wrong)
        if wrong:
            draw_line(layout, sentence)


def draw_line(layout, sentence):
    """A button that goes to the first line that a sentence names."""
    found = LINE.search(sentence)
    if found:
        row = layout.row()
        row.alignment = "RIGHT"
        go = row.operator("object.sweep_grammar_edit", text=f"Line {found[1]}", icon="VIEWZOOM")
        go.line, go.column = int(found[1]), 1

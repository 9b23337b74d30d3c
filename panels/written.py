# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the sidebar shows of a text that a mesh is made of, a grammar or a program."""

GONE = "The text is not there any more: New makes one of what is remembered of it."


def draw_text(layout, group, name, say):
    """The text of a parameter, for people to choose, edit or make anew."""
    row = layout.row(align=True)
    row.template_ID(group, f"{name}_text", new="object.sweep_grammar_text_new", open="text.open")
    row.operator("object.sweep_grammar_edit", text="", icon="GREASEPENCIL").line = 0
    if getattr(group, f"{name}_text") is None:
        say(layout, GONE, "INFO")

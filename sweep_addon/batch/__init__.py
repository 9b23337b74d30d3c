# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Batch: job files read, planned, run on any number of machines, and written as models and pictures."""

COMMAND = []  # what Blender gave for the command: it takes nothing else back, and has no list to find it in again


def register():
    import bpy

    COMMAND.append(bpy.utils.register_cli_command("sweep", sweep))


def unregister():
    import bpy

    bpy.utils.unregister_cli_command(COMMAND.pop())


def sweep(arguments):
    """The command, loaded when it is called: most Blenders are started without it."""
    from .stopping import heed

    heed()
    from .command import main

    return main(arguments)

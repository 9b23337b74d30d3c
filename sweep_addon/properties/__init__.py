# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a .blend remembers of a sweep, and what makes it live."""

from . import handlers, sweep


def register():
    sweep.register()
    handlers.register()


def unregister():
    handlers.unregister()
    sweep.unregister()

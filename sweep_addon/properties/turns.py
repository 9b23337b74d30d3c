# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turns: what other threads would write into the scene is written by the thread that draws it.

A window renders and bakes in a thread of Blender's own, in which handlers are called. Where that wrote a mesh while the
window evaluated it, Blender crashed: see the note on altering data in the documentation of ``bpy.app.handlers``.
"""

from collections import deque
from functools import partial
from threading import Event, Lock, get_ident, main_thread

PATIENCE = 20.0  # seconds; a window that ends a render, because its file is closed, waits for it and gives no turns
WAITING = deque()


class Turn:
    """A call that is made once, by who takes it first."""

    def __init__(self, call):
        self.call, self.free, self.done, self.raised = call, Lock(), Event(), None

    def take(self):
        if not self.free.acquire(blocking=False):
            return
        try:
            self.call()
        except Exception as error:  # whoever waits is told
            self.raised = error
        finally:
            self.done.set()


def is_ours():
    """Whether this is the thread that draws."""
    return get_ident() == main_thread().ident


def in_turn(function, *arguments):
    """Call a function in the thread that draws, and come back when it is done."""
    if is_ours():
        function(*arguments)
        return
    turn = Turn(partial(function, *arguments))
    WAITING.append(turn)
    if not turn.done.wait(PATIENCE):
        turn.take()
    turn.done.wait()
    if turn.raised:
        raise turn.raised


def give():
    """Make the calls that wait."""
    while WAITING:
        WAITING.popleft().take()

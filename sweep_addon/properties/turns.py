# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turns: what other threads would write into the scene is written by the thread that draws it.

A window renders and bakes in a thread of Blender's own, in which handlers are called. Where that wrote a mesh while the
window evaluated it, Blender crashed: see the note on altering data in the documentation of ``bpy.app.handlers``.
"""

from collections import deque
from functools import partial
from threading import Event, Lock, get_ident, main_thread

PATIENCE, MOMENT = 20.0, 0.05  # seconds that a turn is waited for, and between two looks whether it will come
WAITING = deque()
CLOSED = Event()  # while the window waits for the end of other threads, and no turn will come


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
    waited = 0.0
    while not turn.done.wait(MOMENT):
        waited += MOMENT
        if CLOSED.is_set() or waited > PATIENCE:
            turn.take()
    if turn.raised:
        raise turn.raised


def give():
    """Make the calls that wait."""
    CLOSED.clear()
    while WAITING:
        WAITING.popleft().take()

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What other threads would write into the scene is written by the thread that draws it, which gives them turns.

A window renders and bakes in a thread of Blender's own, in which handlers are called. Where that wrote a mesh while the
window evaluated it, Blender crashed: see the note on altering data in the documentation of ``bpy.app.handlers``.

The window may itself wait for that thread: EEVEE keeps the graphics card while it looks for motion blur, and a file
that is closed waits for its renders. No turn comes then, and the thread writes, but never while the window evaluates.
"""

from collections import deque
from functools import partial
from threading import Event, Lock, get_ident, main_thread

MOMENT = 0.02  # seconds between two looks whether the turn has come
PATIENCE = 0.5  # seconds that a turn is waited for; a moment, while the window does not answer
FOR_EVER = 20.0  # seconds after which nothing is waited for: then nobody has told the end of an evaluation


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


class Window:
    """The thread that draws, as others see it."""

    def __init__(self):
        self.waiting, self.patience = deque(), PATIENCE
        self.writing, self.evaluating = Lock(), False
        self.stands_in = None  # the thread that writes in its place

    def before_evaluation(self):
        """Wait for the end of what another thread writes."""
        with self.writing:
            self.evaluating = True

    def after_evaluation(self):
        self.evaluating = False

    def before_close(self):
        """Whoever waits for a turn waits in vain: the window waits for them."""
        self.patience = MOMENT

    def give(self):
        """Make the calls that wait."""
        self.patience, self.evaluating = PATIENCE, False
        while self.waiting:
            self.waiting.popleft().take()

    def wait(self, turn):
        """Wait until a call is made, by the window or else here."""
        self.waiting.append(turn)
        waited = 0.0
        while not turn.done.wait(MOMENT):
            waited += MOMENT
            if waited < self.patience:
                continue
            with self.writing:
                if not self.evaluating or waited > FOR_EVER:
                    self.patience, self.stands_in = MOMENT, get_ident()
                    turn.take()
                    self.stands_in = None


window = Window()


def is_drawing_thread():
    """Whether this is the thread that draws, or writes in its place."""
    return get_ident() in (main_thread().ident, window.stands_in)


def in_drawing_thread(function, *arguments):
    """Call a function in the thread that draws, and come back when it is done."""
    if is_drawing_thread():
        function(*arguments)
        return
    turn = Turn(partial(function, *arguments))
    window.wait(turn)
    if turn.raised:
        raise turn.raised

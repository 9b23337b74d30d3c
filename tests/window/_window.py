# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A person at the window: moves the mouse, clicks, types, and takes pictures.

A session is a generator function. It yields the seconds to wait until Blender has drawn; what it asserts is asserted
after real events went through Blender's own event system.
"""

import os
import subprocess
import sys
import traceback
from pathlib import Path

import bpy

PICTURES = Path(os.environ.get("SWEEP_PICTURES", "build/window"))
DIGITS = dict(zip("0123456789", "ZERO ONE TWO THREE FOUR FIVE SIX SEVEN EIGHT NINE".split(), strict=True)) | {
    ".": "PERIOD"
}


class Person:
    """The mouse and keyboard of the first window."""

    def __init__(self):
        self.window = bpy.context.window_manager.windows[0]
        self.area = next(area for area in self.window.screen.areas if area.type == "VIEW_3D")
        self.sidebar = next(region for region in self.area.regions if region.type == "UI")
        self.view = next(region for region in self.area.regions if region.type == "WINDOW")
        self.place = (self.view.x + self.view.width // 3, self.view.y + self.view.height // 2)
        self.held = {}

    def send(self, type, value, **more):
        more = {**self.held, **more}
        self.window.event_simulate(type=type, value=value, x=int(self.place[0]), y=int(self.place[1]), **more)

    def hold_alt(self, steps):
        """Keep Alt down during some steps."""
        self.held = {"alt": True}
        self.send("LEFT_ALT", "PRESS")
        yield 0.2
        yield from steps
        self.held = {}
        self.send("LEFT_ALT", "RELEASE")
        yield 0.3

    def move(self, x, y):
        """Come to a place in small steps, so that what lies there notices."""
        for offset in (9, 3, 0):
            self.place = (x - offset, y)
            self.send("MOUSEMOVE", "NOTHING")
            yield 0.1

    def click(self, x, y, button="LEFTMOUSE"):
        yield from self.move(x, y)
        self.send(button, "PRESS")
        self.send(button, "RELEASE")
        yield 0.5

    def drag(self, x, y, right):
        yield from self.move(x, y)
        self.send("LEFTMOUSE", "PRESS")
        yield 0.3
        for step in range(1, 9):
            self.place = (x + right * step / 8, y)
            self.send("MOUSEMOVE", "NOTHING")
            yield 0.1
        self.send("LEFTMOUSE", "RELEASE")
        yield 0.5

    def press(self, type, unicode=None, **held):
        self.send(type, "PRESS", **({"unicode": unicode} if unicode else {}), **held)
        self.send(type, "RELEASE", **held)
        yield 0.3

    def type_number(self, x, y, text):
        """Hover over a number field, open it with Return, and replace what it says."""
        yield from self.move(x, y)
        yield from self.press("RET")
        yield from self.press("A", ctrl=True)
        for character in text:
            yield from self.press(DIGITS[character], unicode=character)
        yield from self.press("RET")
        yield 0.4

    def over_view(self):
        yield from self.move(self.view.x + self.view.width // 3, self.view.y + self.view.height // 3)

    def undo(self):
        yield from self.over_view()
        yield from self.press("Z", ctrl=True)
        yield 0.4

    def redo(self):
        yield from self.over_view()
        yield from self.press("Z", ctrl=True, shift=True)
        yield 0.4

    def open_sidebar(self, tab):
        """Press N over the view and choose a tab, which Blender knows only after it has drawn the sidebar."""
        yield from self.over_view()
        if not self.area.spaces.active.show_region_ui:
            yield from self.press("N")
        while self.sidebar.active_panel_category == "UNSUPPORTED":
            self.area.tag_redraw()
            yield 0.1
        self.sidebar.active_panel_category = tab
        self.area.tag_redraw()
        yield 0.6

    def top(self, right, down):
        """A place in the sidebar: a share of its width, pixels below its top."""
        return self.sidebar.x + self.sidebar.width * right, self.sidebar.y + self.sidebar.height - down

    def picture(self, name):
        self.area.tag_redraw()
        yield 0.3
        PICTURES.mkdir(parents=True, exist_ok=True)
        subprocess.run(["import", "-window", "root", str(PICTURES / f"{name}.png")], check=True)


def run(session):
    """Run a session step by step on a timer, and leave with 0 or, after a picture of the failure, with 1.

    It has failed too where a callback raised, as a tooltip may: Blender shows that on the terminal alone.
    """
    raised = []

    def hook(*error):
        traceback.print_exception(*error)
        raised.append(error)

    sys.excepthook = hook
    bpy.context.preferences.view.show_splash = False
    bpy.context.preferences.system.viewport_aa = "OFF"  # it is drawn many times over to look smoother
    person = Person()
    steps = session(person)

    def step():
        try:
            return next(steps)
        except StopIteration:
            leave(bool(raised))
        except BaseException:
            traceback.print_exc()
            subprocess.run(["import", "-window", "root", str(PICTURES / f"{session.__name__}-failed.png")], check=False)
            leave(1)

    bpy.app.timers.register(step, first_interval=1.0)


def leave(code):
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)

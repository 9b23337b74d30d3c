# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ending by a signal: at once, with nothing unfinished left behind.

An exception would not do: Blender prints and drops one that is raised while it calls back, and while it renders the
main thread comes to none.
"""

import os
import shutil
import signal
import socket
import sys
from contextlib import suppress
from pathlib import Path
from subprocess import TimeoutExpired
from threading import Lock, Thread

STOPPED = "stopped; what is finished stays, and the same command goes on from there\n"
SIGNALS = signal.SIGINT, signal.SIGTERM
GRACE = 20.0  # seconds that processes have to end in
FAILED = 1

unfinished, processes = set(), set()  # folders of what is being written, and processes of tasks
starting = Lock()  # of these, while one begins; held for ever once this process ends


def heed():
    """End this process when it is told to, from now on; Blender would finish what it is at, or leave files behind."""
    told, heard = socket.socketpair()
    told.setblocking(False)
    signal.set_wakeup_fd(told.detach())
    for each in SIGNALS:
        if signal.getsignal(each) != signal.SIG_IGN:  # as in the background of a script, whose Ctrl-C is not meant
            signal.signal(each, lambda *_: None)  # Python then tells of it
    Thread(target=lambda: heard.recv(1) and stop(), daemon=True).start()


def stop():
    """End this process and those that it has begun."""
    starting.acquire()
    for process in list(processes):
        process.terminate()
    for process in list(processes):
        with suppress(TimeoutExpired):
            process.wait(GRACE)
    for folder in list(unfinished):
        shutil.rmtree(folder, ignore_errors=True)
    os.write(2, STOPPED.encode())
    leave(FAILED)


def leave(code):
    """End this process at once, and leave nothing of Blender's behind, which would take it away at its own end."""
    if "bpy" in sys.modules:
        temporary = Path(sys.modules["bpy"].app.tempdir)
        if temporary.name.startswith("blender_"):  # where it could make none it has that of all programs
            shutil.rmtree(temporary, ignore_errors=True)
    os._exit(code)

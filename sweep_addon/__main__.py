# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""``sweep VERB ...`` or ``python -m sweep_addon VERB ...``: the verbs of ``blender --command sweep``, where Blender is
a Python module or there is none."""

import sys

from .batch.stopping import heed, leave


def end(code):
    """End at once where Blender was used: the module bpy 4.5 may wait for ever on its way out."""
    sys.stdout.flush()
    sys.stderr.flush()
    if "bpy" in sys.modules:
        leave(code)
    sys.exit(code)


def run():
    """The exit code; a mistake of the program is told here, as nothing may end this process but `end`."""
    heed()
    from .batch.command import main  # which takes a while

    try:
        return main(sys.argv[1:])
    except Exception:
        sys.excepthook(*sys.exc_info())
        return 1


def begin():
    """What ``python -m sweep_addon`` does, and the command ``sweep`` that pip installs."""
    end(run())


if __name__ == "__main__":
    begin()

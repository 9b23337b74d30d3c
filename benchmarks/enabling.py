# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""In a Blender just started: how long enabling the extension takes, and then NumPy's import. Started by `overhead`."""

import subprocess
import sys
import time

import addon_utils

NAME = "bl_ext.user_default.sweep_addon"
IMPORT = "import time; start = time.perf_counter(); import numpy; print(time.perf_counter() - start)"


def numpy_import():
    """The seconds that NumPy's import takes: the bpy wheel has imported it, and another Python of it has not."""
    if "numpy" in sys.modules:
        return float(subprocess.run([sys.executable, "-I", "-c", IMPORT], capture_output=True, check=True).stdout)
    start = time.perf_counter()
    import numpy  # noqa: F401

    return time.perf_counter() - start


there = "numpy" in sys.modules
start = time.perf_counter()
addon_utils.enable(NAME, default_set=True)
enabled = time.perf_counter() - start
brought = not there and "numpy" in sys.modules
print(f"measured: {1000 * enabled} {1000 * numpy_import()} {brought}")

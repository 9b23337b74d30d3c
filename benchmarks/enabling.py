# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""In a Blender just started: how long enabling the extension takes, and then NumPy's import. Started by `overhead`."""

import sys
import time

import addon_utils

NAME = "bl_ext.user_default.sweep_addon"

there = "numpy" in sys.modules  # the bpy wheel imports it
start = time.perf_counter()
addon_utils.enable(NAME, default_set=True)
enabled = time.perf_counter()
brought = not there and "numpy" in sys.modules
import numpy  # noqa: E402, F401

imported = time.perf_counter()
print(f"measured: {1000 * (enabled - start)} {1000 * (imported - enabled)} {brought}")

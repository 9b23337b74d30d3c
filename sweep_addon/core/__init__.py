# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes and their meshes, without Blender."""

from time import time_ns

BEGAN = time_ns()  # a file that was written later may not be what was imported of it

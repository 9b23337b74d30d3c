# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The shapes of the program: adding one here brings it to Blender, job files and the command line."""

from .generalized_cylinder import GeneralizedCylinder

SHAPES = (GeneralizedCylinder,)

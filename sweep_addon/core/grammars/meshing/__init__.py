# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures as meshes: tubes along whole axes, polygons and organs, and their chart."""

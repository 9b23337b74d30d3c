# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grids of rings and columns: their faces, vertices, texture coordinates and attributes."""

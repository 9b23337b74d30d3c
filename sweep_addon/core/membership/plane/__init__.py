# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of the plane: how far points are from regions, lines and arcs, and on which side."""

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Offsets of solids: the boundary of what a ball visits that moves over a surface; and surfaces of level sets."""

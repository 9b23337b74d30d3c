# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Stations: where along a trajectory a contour stands, and in which frame."""

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Variation: how a contour changes on its way, in size, turn, place and form."""

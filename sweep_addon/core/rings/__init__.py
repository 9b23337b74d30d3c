# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rings: contours where they stand, at corners and ends too, and what closes them."""

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sets of points: what tells of each kind of shape if points are in it, and how far they are."""

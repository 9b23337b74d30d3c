# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Motions of figures and solids: as series piece by piece, with all that is asked of them."""

# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a shape is told: parameters declared once, and all that is derived from them."""

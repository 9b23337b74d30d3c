# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The text of a grammar: reading it, what it is made of, and writing it."""

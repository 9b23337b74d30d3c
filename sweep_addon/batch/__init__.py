# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Batch: job files read, planned, run on any number of machines, and written as models and pictures."""

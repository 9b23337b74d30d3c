# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The bridge: the only reader and writer of Blender's data, from arrays and declared values and back."""

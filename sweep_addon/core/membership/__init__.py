# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Point membership classification of sweeps, solids and trees of them, without a mesh."""

from .classifying import classify
from .inverse import Images, inverse_sweep

__all__ = ["Images", "classify", "inverse_sweep"]

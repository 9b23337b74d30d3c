# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Programs of milling machines, RS-274 text: read as the moves that a machine with three axes makes of them."""

from .reading import read
from .toolpath import Toolpath

__all__ = ["Toolpath", "read"]

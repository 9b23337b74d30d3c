# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Maintainability: how a part gets out of an assembly, and the volume that must stay empty for it."""

from .dismantling import Disassembly, disassembly
from .finding import removal_path
from .path import RemovalPath

__all__ = ["Disassembly", "RemovalPath", "disassembly", "removal_path"]
